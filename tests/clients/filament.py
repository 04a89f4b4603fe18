#!/usr/bin/env python3
"""Filament's material compiler takes lvsm_all.glsl unchanged, for desktop and mobile:  filament.py SINGLE

What comes out is not run: that takes the engine and a window.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

# A function of each kind: moments, a loop over layers, four moments, an exponential warp, a struct, words of bits.
MATERIAL = """material { name : Shadow, shadingModel : unlit }
fragment {
#include "lvsm_all.glsl"
void material(inout MaterialInputs material)
{
    prepareMaterial(material);
    float depth = getUserTime().x;
    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = min(0.25 * float(i), 1.0);
    float lit = lvsm_bracketedVisibility2(vec4(0.5), depth, splits[lvsm_layerIndex(depth, splits, 4)], 1.0e-5);
    lit *= lvsm_momentVisibility4(lvsm_depthMoments4(0.5), depth, 1.0e-4);
    lit *= lvsm_exponentialVisibility4(lvsm_exponentialMoments(0.5, vec2(5.0)), depth, vec2(5.0), 1.0e-5);
    lit *= lvsm_mixtureVisibility2(uvec2(1u, uint(depth)), vec2(0.0), depth, vec2(0.0), 1.0, 0.001);
    material.baseColor = vec4(lit);
}
}
"""


def main():
    if not shutil.which("matc"):
        print("skipped: no matc")
        return 77
    status = 0
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(pathlib.Path(sys.argv[1]) / "lvsm_all.glsl", folder)
        path = pathlib.Path(folder) / "shadow.mat"
        path.write_text(MATERIAL)
        for platform, api in (("desktop", "opengl"), ("mobile", "opengl"), ("mobile", "vulkan")):
            done = subprocess.run(["matc", "-p", platform, "-a", api, "-o", f"{folder}/{platform}-{api}", path], cwd=folder,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            made = pathlib.Path(folder) / f"{platform}-{api}"
            passed = done.returncode == 0 and made.exists() and made.stat().st_size > 0
            print(f"{'ok  ' if passed else 'FAIL'} {platform} {api}", done.stdout if not passed else "")
            status |= 0 if passed else 1
    return status


if __name__ == "__main__":
    sys.exit(main())
