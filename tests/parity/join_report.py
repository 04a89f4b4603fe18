#!/usr/bin/env python3
"""join_report.py LVSM_PARITY FOLDER OUTPUT [--complete]: joins the reports of the parity cases into one list.

Fails unless every row of functions.def has run in C++ at least, over inputs of its own domain and hostile ones, and
nothing that ran was outside its range or not finite. With --complete, fails unless each was run in C++, GLSL, HLSL
and WGSL, the shaders on two devices and HLSL by two compilers. Reports of functions that are no more are deleted.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys

HOSTILE = "hostile"
# Of each language, how many compilers and devices.
NEEDED = {"cpp": (1, 1), "glsl": (1, 2), "hlsl": (2, 2), "wgsl": (1, 2)}


def reports(folder, functions):
    """The rows of all reports; those of functions that are gone are deleted."""
    rows = []
    for path in sorted(folder.glob("*.json")):
        if path.name.split(".")[0] in functions:
            rows += json.loads(path.read_text())
        else:
            print(f"deleted: {path.name}, of a function that has no row")
            path.unlink()
    return rows


def faults(rows, functions, complete):
    ways = {}
    for row in rows:
        way = (row["language"], row["compiler"], row["source"], row["device"])
        ways.setdefault(row["function"], {}).setdefault(way, []).append(row)
        where = f"{row['function']} {' '.join(way)} {row['domain']}"
        if row["inputs"] <= 0:
            yield f"no inputs: {where}"
        for count in ("non_finite", "outside"):
            if row[count] != 0:
                yield f"{row[count]} {count}: {where}"
    for function in functions:
        seen = ways.get(function, {})
        if not any(way[0] == "cpp" for way in seen):
            yield f"{function} has not run"
        for way, verdicts in seen.items():
            domains = [verdict["domain"] for verdict in verdicts]
            if domains.count(HOSTILE) != 1 or len(domains) != 2:
                yield f"one domain of its own and hostile inputs, once each: {function} {' '.join(way)} has {domains}"
        for language, (compilers, devices) in NEEDED.items():
            here = [way for way in seen if way[0] == language]
            if len({way[1] for way in here}) < compilers or len({way[3] for way in here}) < devices:
                if complete:
                    yield f"not on every device or compiler: {function} in {language}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parity", help="the program, which knows the rows")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--complete", action="store_true")
    options = parser.parse_args()

    functions = subprocess.run([options.parity, "--list"], check=True, stdout=subprocess.PIPE, text=True).stdout.split()
    if not functions:
        sys.exit(f"{options.parity} has no rows")
    rows = reports(options.folder, functions)
    found = list(faults(rows, functions, options.complete))
    print(f"{len(functions)} functions, {len(rows)} verdicts, {sum(row['inputs'] for row in rows)} results")
    print(*found, sep="\n")
    if not found:
        partial = options.output.with_suffix(".partial")
        partial.write_text(json.dumps(rows, indent=1) + "\n")
        os.replace(partial, options.output)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
