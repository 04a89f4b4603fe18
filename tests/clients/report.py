#!/usr/bin/env python3
"""Joins what the clients have left into one list:  report.py FOLDER OUTPUT [--complete] [--record]

Fails where a client has not run every function that another has run, has run none, or has failed; with --complete, where
one of CLIENTS is not there. The recorded figures, which docs/clients.md shows, are those of another device maybe, but of no
other order of magnitude: FACTOR says how much an error may have changed. --record keeps the list as recorded_clients.json, of which docs/clients.md is made.
"""
import argparse
import json
import os
import pathlib
import sys

RECORDED = pathlib.Path(__file__).with_name("recorded_clients.json")
PRECISION = "`precision highp float;` and `precision highp int;` before it"
# By the name of its report: what is run, and what its user has to do.
CLIENTS = {
    "opengl_330_core": ("fragment shader of 3.30", "paste `lvsm_all.glsl` after `#version`"),
    "opengl_450_core": ("fragment shader of 4.50", "paste `lvsm_all.glsl` after `#version`"),
    "opengl_300_es": ("fragment shader of ES 3.00", f"paste `lvsm_all.glsl`, {PRECISION}"),
    "opengl_310_es": ("fragment shader of ES 3.10", f"paste `lvsm_all.glsl`, {PRECISION}"),
    "three": ("`RawShaderMaterial`", "`THREE.ShaderChunk.lvsm` is `lvsm_all.glsl`; `#include <lvsm>`, `glslVersion: THREE.GLSL3`"),
    "three_webgpu": ("`WebGPURenderer`, compute", "`code(text of lvsm_all.wgsl, [], \"wgsl\")` among the includes of a `wgslFn`"),
    "webgpu": ("compute shader, by Tint", "paste `lvsm_all.wgsl`"),
    "wgpu": ("compute shader, by naga", "paste `lvsm_all.wgsl`"),
    "naga": ("compute shader of 4.50, by naga", "`#define LVSM_PRECISE`, which naga does not know, then `lvsm_all.glsl`"),
    "spirv_cross": ("SPIR-V of 4.50 and back, drawn by OpenGL ES; of all functions also HLSL, which dxc takes, and MSL, "
                    "which nothing here compiles", "nothing"),
    "slang": ("HLSL to WGSL, run by wgpu; of all functions also SPIR-V, GLSL and Metal",
              "`#include \"lvsm/lvsm.hlsli\"`; for WGSL `#define LVSM_PRECISE` before it, since Slang keeps `precise` there"),
    "panda3d": ("fragment shader of 3.30", "`#pragma include \"lvsm_all.glsl\"`"),
}
FACTOR = 10
COLUMNS = ("client", "version", "functions", "inputs", "worst_function", "worst_error", "tolerance")


def reports(folder):
    """Those that are there, by name."""
    return {name: json.loads((folder / f"{name}.json").read_text()) for name in CLIENTS if (folder / f"{name}.json").exists()}


def faults(found, complete):
    if not found:
        yield "no client has run"
    every = max((report["functions"] for report in found.values()), default=0)
    for name, report in found.items():
        if report["failed"]:
            yield f"{name}: {report['failed']} functions failed"
        if report["functions"] != every or report["inputs"] <= 0:
            yield f"{name}: {report['functions']} functions of {every}, {report['inputs']} inputs"
        if not report["version"]:
            yield f"{name} does not say what version it is"
    if complete:
        yield from (f"{name} has not run" for name in CLIENTS if name not in found)


def outdated(found, recorded):
    """What the document shows and is no longer so."""
    for name, report in found.items():
        row = recorded.get(name)
        if row is None:
            yield f"{name} is not recorded"
            continue
        for column in ("worst_error", "tolerance"):
            least, most = sorted((report[column], row[column]))
            if most > FACTOR * least:
                yield f"{name}: {column} is {report[column]:.2g}, recorded {row[column]:.2g}"
    yield from (f"{name} is recorded and is none of CLIENTS" for name in recorded if name not in CLIENTS)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--complete", action="store_true")
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()

    found = reports(options.folder)
    wrong = list(faults(found, options.complete))
    if not options.record:
        wrong += [f"{line}: --record" for line in outdated(found, json.loads(RECORDED.read_text()))]
    rows = {name: {column: report[column] for column in COLUMNS} for name, report in found.items()}
    for row in rows.values():
        print(f"{row['client']} ({row['version']}): {row['functions']} functions, {row['inputs']} inputs, "
              f"{row['worst_function']} {row['worst_error']:.2g} of {row['tolerance']:.2g}")
    print(*wrong, sep="\n")
    if wrong:
        return 1
    partial = options.output.with_suffix(".partial")
    partial.write_text(json.dumps(list(rows.values()), indent=1) + "\n")
    os.replace(partial, options.output)
    if options.record:
        RECORDED.write_text(json.dumps(rows, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
