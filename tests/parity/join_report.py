"""join_report.py FOLDER OUTPUT --rows N [--complete]: joins the reports of the parity cases into one list.

With --complete, fails unless each of the N functions was run in C++, GLSL and HLSL, the shaders on two devices and
HLSL by two compilers.
"""
import argparse
import json
import os
import pathlib
import sys

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("folder", type=pathlib.Path)
parser.add_argument("output", type=pathlib.Path)
parser.add_argument("--rows", type=int, required=True)
parser.add_argument("--complete", action="store_true")
options = parser.parse_args()

rows = [row for path in sorted(options.folder.glob("*.json")) for row in json.loads(path.read_text())]
partial = options.output.with_suffix(".partial")
partial.write_text(json.dumps(rows, indent=1) + "\n")
os.replace(partial, options.output)

ways = {}
for row in rows:
    ways.setdefault(row["function"], set()).add((row["language"], row["compiler"], row["device"]))
needed = {("cpp", 1, 1), ("glsl", 1, 2), ("hlsl", 2, 2)}
missing = []
for function, seen in sorted(ways.items()):
    for language, compilers, devices in needed:
        here = [way for way in seen if way[0] == language]
        if len({way[1] for way in here}) < compilers or len({way[2] for way in here}) < devices:
            missing.append(f"{function} in {language}")

inputs = sum(row["inputs"] for row in rows)
non_finite = sum(row["non_finite"] for row in rows)
print(f"{len(ways)} functions, {len(rows)} rows, {inputs} results, {non_finite} not finite: {options.output}")
for name in missing:
    print("not on every device or compiler:", name)
if len(ways) != options.rows:
    print(f"{options.rows} functions are listed, {len(ways)} have run")
    sys.exit(1)
sys.exit(1 if missing and options.complete else 0)
