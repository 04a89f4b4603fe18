#!/usr/bin/env python3
"""Compiles the sampling wrappers and the ready passes for what tests/sampling does not run, and compares their docs.

    compile.py --glslang glslangValidator --dxc dxc
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
WRAPPERS = ["glsl/lvsm/sampling/combined.glsl", "glsl/lvsm/sampling/separate.glsl", "hlsl/lvsm/sampling/separate.hlsli"]
GLSL_VERSIONS = {"combined": ["400 core", "450 core", "310 es", "320 es"], "separate": ["400 core", "450 core"]}
HLSL_PASSES = ["blur", "store"]


def run(*command):
    result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    passed = result.returncode == 0 and "WARNING:" not in result.stdout
    if not passed:
        print(*command, result.stdout, sep="\n")
    return passed


def glsl_wrappers(glslang, folder):
    for name, versions in GLSL_VERSIONS.items():
        for version in versions:
            path = pathlib.Path(folder) / f"{name}.frag"
            precision = ("precision highp float;\nprecision highp int;\nprecision highp sampler2DArray;\n"
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


def docs_of(path):
    """The doc comment of each function, and its parameters but for the map and its sampler."""
    found = {}
    pattern = r"((?:^///[^\n]*\n)+)\w+ lvsm_(\w+)\(([^)]*)\)"
    for doc, name, parameters in re.findall(pattern, (ROOT / path).read_text(), re.MULTILINE):
        names = [re.sub(r"\[.*", "", p).split()[-1] for p in parameters.split(",")]
        found[name] = (doc, [n for n in names if n not in ("map", "filtering")])
    return found


def same_docs():
    first = docs_of(WRAPPERS[0])
    for path in WRAPPERS[1:]:
        for name in sorted(set(first) | set(docs_of(path))):
            same = first.get(name) == docs_of(path).get(name)
            if not same:
                print(f"{name} differs in its docs or parameters: {WRAPPERS[0]} and {path}")
            yield same
    yield bool(first)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--glslang", required=True)
parser.add_argument("--dxc", required=True)
options = parser.parse_args()
for command in (options.glslang, options.dxc):
    if not shutil.which(command) or subprocess.run([command, "--version"], stdout=subprocess.DEVNULL).returncode == 77:
        print(f"skipped: no {command}")
        sys.exit(77)
with tempfile.TemporaryDirectory() as temporary:
    checks = [*same_docs(), *glsl_wrappers(options.glslang, temporary), *hlsl_as_dxil(options.dxc, temporary)]
print(f"{sum(checks)} of {len(checks)} checks passed")
sys.exit(0 if all(checks) else 1)
