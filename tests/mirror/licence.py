#!/usr/bin/env python3
"""Fails when a file that users copy does not carry the licence's notice:  licence.py ROOT GENERATED

The notice is the first two lines, or those after #version, which some compilers want first. GENERATED is the folder of
the one-file versions. The holder and the year are those of LICENSE.
"""
import pathlib
import re
import sys


def lacks_notice(path, notice):
    return not re.sub(r"\A#version[^\n]*\n", "", path.read_text()).startswith(notice)


def main():
    root, generated = map(pathlib.Path, sys.argv[1:])
    copyright_ = re.search(r"^Copyright .*$", (root / "LICENSE").read_text(), re.MULTILINE).group()
    notice = f"// SPDX-License-Identifier: MIT\n// {copyright_}\n"
    folders = [root / "include", root / "glsl", root / "hlsl", root / "wgsl", generated]
    files = {folder: [path for path in sorted(folder.rglob("*")) if path.is_file()] for folder in folders}
    lacking = [path for of_folder in files.values() for path in of_folder if lacks_notice(path, notice)]
    print(*[f"{path} does not begin with the licence's notice" for path in lacking], sep="\n", end="\n" if lacking else "")
    print(", ".join(f"{len(of_folder)} files in {folder.name}" for folder, of_folder in files.items()))
    return 1 if lacking or not all(files.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
