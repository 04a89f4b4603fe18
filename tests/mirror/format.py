#!/usr/bin/env python3
"""Fails where the C++ of tests, examples and wasm is not as .clang-format says; --fix makes it so.

Versions of clang-format differ in what they make of one .clang-format, so one version decides, that of packages.txt.
Without it, exit status 77. The headers in include/ are laid out by hand.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = "14"


def formatter():
    """The command of the right version, or None."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        if shutil.which(name):
            text = subprocess.run([name, "--version"], stdout=subprocess.PIPE, text=True).stdout
            if re.search(rf"version {VERSION}\.", text):
                return name
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fix", action="store_true")
    options = parser.parse_args()
    command = formatter()
    if not command:
        print(f"skipped: no clang-format {VERSION}")
        return 77
    files = sorted(path for folder in ("tests", "examples", "wasm") for path in (ROOT / folder).rglob("*.[ch]pp"))
    if not files:
        sys.exit("no files")
    done = subprocess.run([command, "-i" if options.fix else "--dry-run", "--Werror", *files])
    if done.returncode != 0:
        print("clang-format would change these files: tests/mirror/format.py --fix does")
    return 1 if done.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
