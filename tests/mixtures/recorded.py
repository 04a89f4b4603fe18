#!/usr/bin/env python3
"""The recorded figures of mixtures, and whether a program of now prints those of a small run.

    recorded.py FILE COMMAND...     FILE: of this folder; every number must be within 0.002 of the recorded one
    lvsm_mixture_windows > windows.txt       records them
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
NEAR = 0.002
WORST = 0.1  # one window's error, where another order of roundings may merge another pair


def tables(name):
    """The tables of a recorded output: lists of cells, without the line under the heading."""
    found, lines = [], []
    for line in (HERE / name).read_text().splitlines() + [""]:
        if line.startswith("|"):
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if not re.fullmatch(r"[-|]+", "".join(cells)):
                lines.append(cells)
        elif lines:
            found.append(lines)
            lines = []
    return found


def numbers(text):
    return [float(n) for n in re.findall(r"(?<![\w.])\d+(?:\.\d+)?", text)]


def main():
    recorded = (HERE / sys.argv[1]).read_text()
    now = subprocess.run(sys.argv[2:], check=True, capture_output=True, text=True).stdout
    print(now)
    pairs = list(zip(numbers(recorded), numbers(now)))
    faults = [f"{a} recorded, {b} now" for a, b in pairs
              if abs(a - b) > (WORST if round(a, 2) == a and round(b, 2) == b else NEAR)]
    if len(numbers(recorded)) != len(numbers(now)):
        faults.append("another number of figures")
    print(*faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
