#!/usr/bin/env python3
"""The rows there and back by SPIRV-Cross:  spirv_cross.py FOLDER SINGLE GLSLANG DXC CLIENT

FOLDER: where `lvsm_client_rows write` has put them. SINGLE: of the one-file versions. The unchanged lvsm_all.glsl and each
row's fragment shader become SPIR-V, and that GLSL ES 3.00, which CLIENT, lvsm_client_opengl, runs. Of a program that calls
every function HLSL and MSL are made as well; dxc compiles the HLSL.
"""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/compile"))
import shaders  # noqa: E402

folder, single, glslang, dxc, client = sys.argv[1:]
LIBRARY = (pathlib.Path(single) / "lvsm_all.glsl").read_text()
PER_DRAW = 12


def run(*words):
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{words[0]}: {done.stdout}")
    return done.stdout


def back(text, name, stage, *to):
    """What SPIRV-Cross makes of a shader of that name, behind #version 450 and the library."""
    path = pathlib.Path(folder) / f"{name}.{stage}"
    path.write_text(f"#version 450\n{LIBRARY}{text}")
    run(glslang, "-G", "--auto-map-bindings", "--auto-map-locations", "-o", f"{path}.spv", str(path))
    return run("spirv-cross", *to, f"{path}.spv")


def es(row):
    """The row's shader for each twelve numbers of its results, without #version."""
    parts = []
    for first in range(0, row["numbers"], PER_DRAW):
        text = back(f"#define FIRST {first}\n{row['kernel']}", f"{row['function']}{first}", "frag", "--version", "300", "--es")
        parts.append(f"#{'elif' if parts else 'if'} FIRST == {first}\n" + text.split("\n", 1)[1])
    return "".join(parts) + "#endif\n"


def to_other_languages():
    """Fails where the program of all functions does not become HLSL that dxc takes, or MSL."""
    program = shaders.GLSL_MAIN["comp"] % shaders.calls("GLSL", "lvsm")
    hlsl = pathlib.Path(folder) / "all.hlsl"
    hlsl.write_text(back(program, "all", "comp", "--hlsl", "--shader-model", "60"))
    run(dxc, "-T", "cs_6_0", "-E", "main", "-Fo", str(hlsl.with_suffix(".dxil")), str(hlsl))
    msl = back(program, "all", "comp", "--msl")
    if "kernel void main0" not in msl:
        raise RuntimeError(f"this is no MSL: {msl[:400]}")
    print(f"HLSL of {len(hlsl.read_text())} characters, which dxc takes, and MSL of {len(msl)}")


for command in (glslang, "spirv-cross", dxc):
    if not shutil.which(command):
        print(f"skipped: no {command}")
        sys.exit(77)
try:
    to_other_languages()
    rows = json.loads((pathlib.Path(folder) / "rows.json").read_text())
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for row, text in zip(rows, pool.map(es, rows)):
            row["kernel"] = text
except RuntimeError as error:
    print(f"FAIL {error}")
    sys.exit(1)
(pathlib.Path(folder) / "rows.json").write_text(json.dumps(rows))
empty = pathlib.Path(folder) / "empty.glsl"
empty.write_text("")
status = subprocess.run([client, "functions", "300 es", empty, folder]).returncode
version = pathlib.Path(folder) / "version"
if status == 0:
    version.write_text("SPIRV-Cross of Debian, " + version.read_text())
sys.exit(status)
