#!/usr/bin/env python3
"""The rows through Slang:  slang_rows.py FOLDER HLSL

FOLDER: where `lvsm_client_rows write` has put them. HLSL: the folder that holds lvsm/. Slang takes the unchanged include as
HLSL and makes WGSL of it, which wgpu runs; it would keep `precise`, which is no WGSL, so LVSM_PRECISE is defined empty. Of
a program that calls every function it makes SPIR-V, GLSL and Metal, too.
"""
import ctypes
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
for part in ("support", "compile"):
    sys.path.insert(0, str(ROOT / "tests" / part))
import pypi  # noqa: E402
import shaders  # noqa: E402
import wgpu_rows  # noqa: E402

# Of the package only the compiler's library is used.
PACKAGES = ["slangpy==0.43.1"]
INCLUDE = '#include "lvsm/lvsm.hlsli"\n'


class Slang:
    def __init__(self):
        folder = pypi.add("slang", PACKAGES) / "slangpy"
        found = sorted(folder.glob("libslang-compiler.so*"))
        try:
            self.library = ctypes.CDLL(str(found[0]))
        except (IndexError, OSError) as error:
            pypi.skip(f"cannot load Slang: {error}")
        for name, result in (("spCreateSession", ctypes.c_void_p), ("spCreateCompileRequest", ctypes.c_void_p),
                             ("spGetBuildTagString", ctypes.c_char_p), ("spGetDiagnosticOutput", ctypes.c_char_p),
                             ("spGetCompileRequestCode", ctypes.c_void_p)):
            getattr(self.library, name).restype = result
        self.session = ctypes.c_void_p(self.library.spCreateSession(None))

    def version(self):
        return f"Slang {self.library.spGetBuildTagString().decode()}"

    def compile(self, path, target):
        """The text or binary of the compute shader `main`; RuntimeError with what Slang says where there is none."""
        request = ctypes.c_void_p(self.library.spCreateCompileRequest(self.session))
        words = [str(path), "-I", sys.argv[2], "-target", target, "-entry", "main", "-stage", "compute"]
        arguments = (ctypes.c_char_p * len(words))(*[word.encode() for word in words])
        failed = self.library.spProcessCommandLineArguments(request, arguments, len(words)) < 0
        failed = failed or self.library.spCompile(request) < 0
        size = ctypes.c_size_t()
        code = None if failed else self.library.spGetCompileRequestCode(request, ctypes.byref(size))
        made = ctypes.string_at(code, size.value) if code else b""
        said = self.library.spGetDiagnosticOutput(request) or b""
        self.library.spDestroyCompileRequest(request)
        if not made:
            raise RuntimeError(f"{path.name} as {target}: {said.decode()}")
        return made


def main():
    slang, path = Slang(), pathlib.Path(sys.argv[1]) / "shader.hlsl"
    path.write_text(INCLUDE + shaders.HLSL_MAIN["cs"] % shaders.calls("HLSL", "lvsm"))
    for target in ("spirv", "glsl", "metal"):
        print(f"{len(slang.compile(path, target))} bytes of {target}")

    def shader(row):
        path.write_text("#define LVSM_PRECISE\n" + INCLUDE + row["hlsl"])
        return slang.compile(path, "wgsl").decode()

    return wgpu_rows.run(path.parent, shader, f"{slang.version()}, ")


if __name__ == "__main__":
    sys.exit(main())
