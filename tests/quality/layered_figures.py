#!/usr/bin/env python3
"""The figures of the experiments that this library started from, on the layered scenes, as lvsm_quality gives them.

    layered_figures.py LVSM_QUALITY

Compares without shift and slope floor, on texel centres, at one tap. A figure of the notes has two or three digits: within 10% of it, as it was
before rounding. Ours, marked so, may be better by more.
"""
import json
import subprocess
import sys
import tempfile

SCENES = ("foliage", "fence", "stack", "slanted")
DIGIT = 0.0005  # what rounding to three digits can take away
FIGURES = {
    "VSM rg32f": (0.097, 0.111, 0.073, 0.036),
    "MSM4 unorm16": (0.039, 0.017, 0.012, 0.008),
    "EVSM4 rgba32f 42/10": (0.067, 0.062, 0.009, 0.018),
    "MSM4 rgba32f": (0.031, 0.017, 0.002, 0.028),
    "LVSM-2 unorm16 paper, uniform": (0.091, 0.299, 0.059, 0.030),
    "LVSM-4 unorm16 paper, uniform": (0.088, 0.295, 0.035, 0.041),
    "LVSM-8 unorm16 paper, uniform": (0.086, 0.297, 0.023, 0.044),
}
OURS = {
    "LVSM-4 unorm16 bracketed, uniform": (0.028, 0.0001, 0.013, 0.016),
    "LVSM-4 unorm16 bracketed, optimal": (0.028, 0.003, 0.012, 0.014),
    "MSM4 x 2 layers unorm16, optimal": (0.023, 0.0003, 0.007, 0.014),
    "MSM4 x 4 layers unorm16, optimal": (0.012, 0.0001, 0.002, 0.024),
}


def measure(program):
    with tempfile.TemporaryDirectory() as folder:
        output = folder + "/quality.json"
        names = ["--techniques=" + name.split(",")[0] for name in {**FIGURES, **OURS}]
        subprocess.run([program, "--size=384", "--centred", "--each-pass", "--one-tap", "--receivers=1000000", "--scenes=" + ",".join(SCENES), "--output", output, *names],
                       check=True, stdout=subprocess.DEVNULL)
        with open(output) as file:
            return {(row["technique"], row["scene"]): row["plain_rmse"] for row in json.load(file)}


def main():
    measured = measure(sys.argv[1])
    wrong = 0
    for name, figures in {**FIGURES, **OURS}.items():
        for scene, figure in zip(SCENES, figures):
            error = measured[name, scene]
            good = error <= 1.1 * (figure + DIGIT) and (name in OURS or error >= 0.9 * (figure - DIGIT))
            wrong += not good
            print(f"{'' if good else 'WRONG '}{name}, {scene}: {error:.4f}, noted {figure}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
