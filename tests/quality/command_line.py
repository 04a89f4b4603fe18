#!/usr/bin/env python3
"""What lvsm_quality says to options that make no sense, and that it leaves nothing half-written.

    command_line.py LVSM_QUALITY
"""
import json
import os
import subprocess
import sys
import tempfile

SMALL = ["--size", "48", "--width", "5", "--techniques", "VSM rg16,MSM4 unorm16"]


def run(program, *options):
    return subprocess.run([program, *options], capture_output=True, text=True)


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "reports", "quality.json")
        broken = os.path.join(folder, "broken.obj")
        with open(broken, "w") as file:
            file.write("v 0 0 0\n")
        wrong = {
            "--scenes": ["--scenes", "moon"],
            "--techniques": ["--techniques", "magic"],
            "--width": ["--width", "4"],
            "tree": ["--tree", "--width", "5"],
            "--footprint": ["--footprint", "40,1"],
            "--size": ["--size", "many"],
            "--output": ["--output", folder, *SMALL, "--scenes", "fence"],
            "/nowhere.obj": ["--model", "/nowhere.obj"],
            broken: ["--model", broken],
            "--costs": ["--certain", "--costs", "/nowhere.json"],
        }
        for named, options in wrong.items():
            result = run(program, "--output", output, *options) if "--output" not in options else run(program, *options)
            assert result.returncode != 0, f"{options} passes"
            assert named in result.stderr, f"{options} does not name {named}: {result.stderr}"
            assert not os.path.exists(output), f"{options} writes a report"
            assert not result.stdout, f"{options} prints a table"

        result = run(program, "--output", output, *SMALL, "--scenes", "fence,street-oblique", "--seed", "4",
                     "--pictures", folder)
        assert result.returncode == 0, result.stderr
        with open(output) as file:
            rows = json.load(file)
        assert {row["scene"] for row in rows} == {"fence", "street-oblique"}
        for row in rows:
            for key in ("technique", "peer", "bits", "scene", "seed", "rmse", "bleed", "dark", "p99", "width",
                        "footprint", "stretch", "taps", "resolution", "texel_bits", "calm", "cost", "map_cost", "map_bytes", "window", "chosen_rmse"):
                assert key in row, key
            assert row["seed"] == 4 and 0 <= row["rmse"] <= 1
        assert sum(name.endswith(".png") for name in os.listdir(folder)) == len(rows)
        assert "MSM4 unorm16" in result.stdout and "fence" in result.stderr


if __name__ == "__main__":
    sys.exit(main())
