#!/usr/bin/env python3
"""Compiles the sampling wrappers and the ready passes as users do whose settings tests/sampling does not run.

    compile.py CASE --glslang glslangValidator --dxc dxc
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PASSES = ROOT / "glsl/lvsm/passes"
INCLUDE = "#extension GL_GOOGLE_include_directive : require\n"
# What GLSL ES asks a user to write, and all of it.
HIGHP = "precision highp float;\nprecision highp int;\n"
WRAPPERS = {"combined": ["330 core", "400 core", "450 core", "300 es", "310 es", "320 es"],
            "separate": ["400 core", "450 core"]}
PASS_VERSIONS = {".frag": ["330 core", "450 core", "300 es", "310 es"], ".comp": ["450 core", "310 es", "320 es"]}
# Includes a file, and calls one of its functions with values that the compiler does not know.
WHOLE = """layout(location = 0) in highp vec2 uv;
layout(binding = 0) uniform highp sampler2D map;
layout(binding = 1) uniform highp sampler2DArray layers;
layout(location = 0) out vec4 result;
void main()
{
    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = uv.x + float(i);
    lvsm_MapPoint at = lvsm_mapPoint(uv, uv, uv, 1);
    result = vec4(lvsm_sampleEsm(layers, layers, at, uv.x, uv.y, 0.1), lvsm_samplePcf(layers, at, uv.x, uv, 3.0, 0.0, 0.0),
                  lvsm_sampleLayers(layers, at, uv.x, splits, 4, 0.1, 0.1, uv.y), lvsm_sampleMap(map, uv, uv, uv, uv.xyxy).x);
}
"""


class Compilers:
    def __init__(self, options, folder):
        self.options = options
        self.folder = pathlib.Path(folder)

    def run(self, *command, refusal=None):
        """Whether the command succeeds without a warning, or fails with a message that holds refusal."""
        result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                text=True)
        passed = result.returncode == 0 and "WARNING:" not in result.stdout
        if refusal:
            passed = result.returncode != 0 and refusal in result.stdout
        if not passed:
            print(*command, f"expected {refusal or 'success'}", result.stdout, sep="\n")
        return passed

    def glsl(self, suffix, text, vulkan=False, refusal=None):
        path = self.folder / f"shader{suffix}"
        path.write_text(text)
        flags = ["-V", "-o", self.folder / "out.spv"] if vulkan else ["-l"]
        return self.run(self.options.glslang, *flags, f"-I{ROOT}/glsl", f"-I{PASSES}", path, refusal=refusal)

    def hlsl(self, profile, entry, file, macros="", refusal=None):
        path = self.folder / "shader.hlsl"
        path.write_text(f'{macros}#include "{file}"\n')
        return self.run(self.options.dxc, "-T", profile, "-E", entry, "-WX", "-I", ROOT / "hlsl", "-Fo",
                        self.folder / "out", path, refusal=refusal)


def head(version):
    return f"#version {version}\n{INCLUDE}{HIGHP if version.endswith('es') else ''}"


def pass_text(name, version, macros=""):
    """A pass with its first line replaced, as its comment says."""
    return head(version) + macros + re.sub(r"\A[^\n]*\n", "", (PASSES / name).read_text()).replace(INCLUDE, "")


def glsl_versions(compilers):
    forms = {path.stem for path in (ROOT / "glsl/lvsm/sampling").glob("*.glsl")} - {"common", "highp"}
    for name in sorted(forms ^ set(WRAPPERS)):
        print(f"WRAPPERS of {__file__} is to have the files of glsl/lvsm/sampling: {name}")
        yield False
    for name, versions in WRAPPERS.items():
        for version in versions:
            yield compilers.glsl(".frag", head(version) + f'#include "lvsm/sampling/{name}.glsl"\n'
                                 "layout(location = 0) out vec4 result;\nvoid main() { result = vec4(1.0); }\n",
                                 vulkan=name == "separate")
    for suffix, versions in PASS_VERSIONS.items():
        for path in sorted(PASSES.glob(f"*{suffix}")):
            for version in versions:
                yield compilers.glsl(suffix, pass_text(path.name, version))


def hlsl_as_dxil(compilers):
    yield compilers.hlsl("cs_6_0", "main", ROOT / "tests/sampling/kernels/wrappers.hlsl")
    for path in sorted((ROOT / "hlsl/lvsm/passes").glob("*.hlsl")):
        text = path.read_text()
        entries = [("cs_6_0", entry) for entry in re.findall(r"\[numthreads\([^)]*\)\]\nvoid (\w+)", text)]
        entries += [("ps_6_0", entry) for entry in re.findall(r"^float4 (\w+)\([^)]*\) : SV_Target", text, re.MULTILINE)]
        yield bool(entries)
        for profile, entry in entries:
            yield compilers.hlsl(profile, entry, f"lvsm/passes/{path.name}")


def relaxed_functions(folder):
    """The functions of a SPIR-V module in which something is computed in mediump."""
    text = subprocess.run(["spirv-dis", "--raw-id", folder / "out.spv"], stdout=subprocess.PIPE, text=True, check=True)
    relaxed = set(re.findall(r"OpDecorate (%\w+) RelaxedPrecision", text.stdout))
    names = dict(re.findall(r'OpName (%\w+) "([^"(]*)', text.stdout))
    found, function = set(), None
    for line in text.stdout.splitlines():
        if match := re.match(r"\s*(%\w+) = OpFunction ", line):
            function = names[match[1]]
        if function and (match := re.match(r"\s*(%\w+) = ", line)) and match[1] in relaxed:
            found.add(function)
    return found


def es_computes_in_highp(compilers):
    """With the user's preamble nothing is relaxed; a mediump client that wraps the include relaxes its own code alone."""
    include = '#include "lvsm/sampling/combined.glsl"\n'
    for after, expected in (("", set()), ("precision mediump float;\n", {"main"})):
        yield compilers.glsl(".frag", head("310 es") + include + after + WHOLE, vulkan=True)
        found = relaxed_functions(compilers.folder)
        if found != expected:
            print(f"mediump in {found}, expected in {expected}")
        yield found == expected
    for suffix in (".comp", ".frag"):
        for name in ("blur", "store"):
            yield compilers.glsl(suffix, pass_text(name + suffix, "310 es"), vulkan=True)
            yield not relaxed_functions(compilers.folder)


def refusals(compilers):
    include = '#include "lvsm/sampling/common.glsl"\nvoid main() {}\n'
    yield compilers.glsl(".frag", f"#version 100\n{INCLUDE}{HIGHP}{include}", refusal="lvsm needs GLSL ES 3.00")
    yield compilers.glsl(".frag", f"#version 150\n{INCLUDE}{include}", refusal="lvsm needs GLSL 3.30")
    some = "#define LVSM_BLUR_SOURCE layout(binding = 7)\n"
    yield compilers.glsl(".comp", pass_text("blur.comp", "450", some), refusal="define all of")
    some += "#define LVSM_BLUR_BLOCK layout(std140, binding = 8)\n"
    yield compilers.glsl(".comp", pass_text("blur.comp", "450", some), refusal="define all of")
    yield compilers.glsl(".frag", pass_text("store.frag", "450", "#define LVSM_STORE_BLOCK layout(std140)\n"),
                         refusal="define all of")
    yield compilers.hlsl("cs_6_0", "lvsm_blurCompute", "lvsm/passes/blur.hlsl", "#define LVSM_BLUR_TARGET u4\n",
                         refusal="define all of")
    yield compilers.hlsl("cs_6_0", "lvsm_storeCompute", "lvsm/passes/store.hlsl", "#define LVSM_STORE_TARGET u4\n",
                         refusal="define all of")
    technique = "#define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, {}(42.0, 10.0))\n"
    yield compilers.glsl(".comp", pass_text("store.comp", "450", technique.format("vec2")),
                         refusal="define LVSM_STORE_LARGEST")
    yield compilers.hlsl("cs_6_0", "lvsm_storeCompute", "lvsm/passes/store.hlsl", technique.format("float2"),
                         refusal="define LVSM_STORE_LARGEST")


def bindings_are_the_users(compilers):
    """Descriptor sets and register spaces of the client's own."""
    for name, input_ in (("BLUR", "SOURCE"), ("STORE", "DEPTHS")):
        glsl = "".join(f"#define LVSM_{name}_{what} layout({layout}set = {i}, binding = {i + 5})\n"
                       for i, (what, layout) in enumerate([(input_, ""), ("TARGET", ""), ("BLOCK", "std140, ")]))
        for suffix in (".comp", ".frag"):
            yield compilers.glsl(suffix, pass_text(name.lower() + suffix, "450", glsl), vulkan=True)
        hlsl = "".join(f"#define LVSM_{name}_{what} {register}4, space{i}\n"
                       for i, (what, register) in enumerate([(input_, "t"), ("TARGET", "u"), ("BLOCK", "b"),
                                                             *([("SAMPLER", "s")] if name == "BLUR" else [])]))
        for profile, stage in (("cs_6_0", "Compute"), ("ps_6_0", "Pixel")):
            yield compilers.hlsl(profile, f"lvsm_{name.lower()}{stage}", f"lvsm/passes/{name.lower()}.hlsl", hlsl)


CASES = {case.__name__: case
         for case in (glsl_versions, hlsl_as_dxil, es_computes_in_highp, refusals, bindings_are_the_users)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", choices=CASES)
    parser.add_argument("--glslang", required=True)
    parser.add_argument("--dxc", required=True)
    options = parser.parse_args()
    for command in (options.glslang, options.dxc):
        if not shutil.which(command) or subprocess.run([command, "--version"], stdout=subprocess.DEVNULL).returncode == 77:
            print(f"skipped: no {command}")
            return 77
    with tempfile.TemporaryDirectory() as folder:
        checks = list(CASES[options.case](Compilers(options, folder)))
    print(f"{sum(checks)} of {len(checks)} checks passed")
    return 0 if checks and all(checks) else 1


if __name__ == "__main__":
    sys.exit(main())
