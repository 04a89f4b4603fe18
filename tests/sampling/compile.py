#!/usr/bin/env python3
"""Compiles the sampling wrappers and the ready passes for what tests/sampling does not run.

    compile.py --glslang glslangValidator --dxc dxc
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GLSL_VERSIONS = {"combined": ["330 core", "400 core", "450 core", "300 es", "310 es", "320 es"], "separate": ["400 core", "450 core"]}
HLSL_PASSES = sorted(path.stem for path in (ROOT / "hlsl/lvsm/passes").glob("*.hlsl"))


def run(*command):
    result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    passed = result.returncode == 0 and "WARNING:" not in result.stdout
    if not passed:
        print(*command, result.stdout, sep="\n")
    return passed


def glsl_wrappers(glslang, folder):
    forms = {path.stem for path in (ROOT / "glsl/lvsm/sampling").glob("*.glsl")} - {"common"}
    for name in sorted(forms ^ set(GLSL_VERSIONS)):
        print(f"GLSL_VERSIONS of {__file__} is to have the files of glsl/lvsm/sampling: {name}")
        yield False
    for name, versions in GLSL_VERSIONS.items():
        for version in versions:
            path = pathlib.Path(folder) / f"{name}.frag"
            precision = ("precision highp float;\nprecision highp int;\n"
                         if version.endswith("es") else "")
            path.write_text(f"#version {version}\n#extension GL_GOOGLE_include_directive : require\n{precision}"
                            f'#include "lvsm/sampling/{name}.glsl"\n'
                            "layout(location = 0) out vec4 result;\nvoid main() { result = vec4(1.0); }\n")
            vulkan = ["-V", "-o", path.with_suffix(".spv")] if name == "separate" else ["-l"]
            yield run(glslang, *vulkan, f"-I{ROOT}/glsl", path)


def hlsl_as_dxil(dxc, folder):
    def compile_(profile, entry, path):
        return run(dxc, "-T", profile, "-E", entry, "-WX", "-I", ROOT / "hlsl", "-Fo", f"{folder}/out", path)

    yield compile_("cs_6_0", "main", ROOT / "tests/sampling/kernels/wrappers.hlsl")
    for name in HLSL_PASSES:
        path = ROOT / f"hlsl/lvsm/passes/{name}.hlsl"
        yield compile_("cs_6_0", f"lvsm_{name}Compute", path)
        yield compile_("ps_6_0", f"lvsm_{name}Pixel", path)
    for entry in ("histogram", "place"):
        yield compile_("cs_6_0", f"lvsm_{entry}Compute", ROOT / "hlsl/lvsm/passes/place.hlsl")


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--glslang", required=True)
parser.add_argument("--dxc", required=True)
options = parser.parse_args()
for command in (options.glslang, options.dxc):
    if not shutil.which(command) or subprocess.run([command, "--version"], stdout=subprocess.DEVNULL).returncode == 77:
        print(f"skipped: no {command}")
        sys.exit(77)
with tempfile.TemporaryDirectory() as temporary:
    checks = [*glsl_wrappers(options.glslang, temporary), *hlsl_as_dxil(options.dxc, temporary)]
print(f"{sum(checks)} of {len(checks)} checks passed")
sys.exit(0 if all(checks) else 1)
