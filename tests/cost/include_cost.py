#!/usr/bin/env python3
"""Prints what including lvsm/lvsm.hpp costs, beside the cost of the GLM headers that it includes, and their ratio.

    tests/cost/include_cost.py [--cxx COMPILER] [--runs N] [--limit 1.15] [--report build/reports/include_cost.json]

Each is a unit that holds nothing but the includes. The cost is the compiler's processor time, median of N runs. The two
take turns, and the ratio is the median of the turns' ratios, so that other work on the machine weighs on both alike.
With --limit a larger ratio is a failure.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import sys
import tempfile

INCLUDE = pathlib.Path(__file__).resolve().parents[2] / "include"


def glm_headers(header, seen):
    """The GLM headers that a header of ours names, and those that the ones it includes name."""
    if header in seen:
        return set()
    seen.add(header)
    text = header.read_text()
    found = set(re.findall(r"^#include <(glm/[^>]+)>", text, re.MULTILINE))
    for name in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE):
        found |= glm_headers(header.parent / name, seen)
    return found


def seconds(command):
    """User and system time of the command and what it starts."""
    process = os.posix_spawnp(command[0], command, os.environ)
    _, status, usage = os.wait4(process, 0)
    if status != 0:
        sys.exit("failed: " + " ".join(command))
    return usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cxx", default="c++")
    parser.add_argument("--runs", type=int, default=21)
    parser.add_argument("--limit", type=float)
    parser.add_argument("--report", type=pathlib.Path)
    options = parser.parse_args()

    headers_of_glm = sorted(glm_headers(INCLUDE / "lvsm/lvsm.hpp", set()))
    units = {"glm": headers_of_glm, "lvsm": ["lvsm/lvsm.hpp"]}
    times = {name: [] for name in units}
    with tempfile.TemporaryDirectory() as folder:
        for name, headers in units.items():
            pathlib.Path(folder, name + ".cpp").write_text("".join(f"#include <{header}>\n" for header in headers))
        for run in range(options.runs + 1):
            for name in units:
                time = seconds([options.cxx, "-std=c++17", "-O2", f"-I{INCLUDE}", "-c", f"{folder}/{name}.cpp",
                                "-o", f"{folder}/{name}.o"])
                if run > 0:  # the first one fills the file cache
                    times[name].append(time)

    medians = {name: statistics.median(values) for name, values in times.items()}
    ratio = statistics.median(lvsm / glm for lvsm, glm in zip(times["lvsm"], times["glm"]))
    print(f"{medians['glm']:.3f} s  {' '.join(headers_of_glm)}")
    print(f"{medians['lvsm']:.3f} s  lvsm/lvsm.hpp")
    print(f"{ratio:.3f}    ratio, median of {options.runs} runs with {options.cxx}")
    if options.report:
        options.report.parent.mkdir(parents=True, exist_ok=True)
        options.report.write_text(json.dumps({"compiler": options.cxx, "runs": options.runs, "glm_headers": headers_of_glm,
                                              "glm_seconds": medians["glm"], "lvsm_seconds": medians["lvsm"],
                                              "ratio": ratio}, indent=2) + "\n")
    return 1 if options.limit and ratio > options.limit else 0


if __name__ == "__main__":
    sys.exit(main())
