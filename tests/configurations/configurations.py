"""The configurations that users build the C++ headers in, beside the one that all other tests run in."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Configuration:
    name: str
    why: str
    compiler: str
    flags: str
    link: str = ""
    runner: str = ""
    # What /proc/cpuinfo has to name for the program to run here.
    cpu: tuple = ()

    @property
    def command(self):
        return " ".join(dict.fromkeys(f"{self.compiler} {self.flags} {self.link}".split()))


CONFIGURATIONS = [
    Configuration("fma", "a product and a sum become one operation", "g++", "-std=c++17 -O1 -mfma", cpu=("fma",)),
    Configuration("native", "all that this machine can, and GLM's macros", "g++",
                  "-std=c++23 -O3 -march=native -DGLM_FORCE_INTRINSICS -DGLM_FORCE_INLINE -DGLM_FORCE_CTOR_INIT "
                  "-DGLM_FORCE_DEPTH_ZERO_TO_ONE"),
    Configuration("fast_math", "terms change places, NaN and subnormal numbers do not exist", "g++",
                  "-std=c++17 -O2 -march=native -ffast-math", link="-ffast-math"),
    Configuration("clang_fast_math", "the same by another compiler", "clang++", "-std=c++17 -O1 -mfma -ffast-math",
                  link="-ffast-math", cpu=("fma",)),
    Configuration("clang_libcxx", "another standard library, contraction across statements", "clang++",
                  "-std=c++20 -O1 -mfma -ffp-contract=fast -stdlib=libc++", link="-stdlib=libc++", cpu=("fma",)),
    Configuration("aarch64", "ARM, which contracts by default", "aarch64-linux-gnu-g++",
                  "-std=c++17 -O2 -DLVSM_UNIT_SHARE=16", link="-static", runner="qemu-aarch64"),
    Configuration("i686", "32 bits, floating point in SSE registers", "i686-linux-gnu-g++",
                  "-std=c++17 -O1 -msse2 -mfpmath=sse", link="-static"),
]
