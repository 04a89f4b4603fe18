#!/usr/bin/env python3
"""Fails when a language's LVSM_VERSION is not the project's version:  version.py ROOT MAJOR.MINOR.PATCH"""
import pathlib
import re
import sys

root, version = pathlib.Path(sys.argv[1]), sys.argv[2]
major, minor, patch = map(int, version.split("."))
wanted = str(10000 * major + 100 * minor + patch)
status = 0
for name in ("include/lvsm/config.hpp", "glsl/lvsm/config.glsl", "hlsl/lvsm/config.hlsli", "wgsl/lvsm/config.wgsl"):
    found = re.findall(r"^(?:#define LVSM_VERSION|const LVSM_VERSION: i32 =) (\w+);?$", (root / name).read_text(), re.MULTILINE)
    print(f"{name}: {' '.join(found) or 'no LVSM_VERSION'}, wanted {wanted} for {version}")
    status |= found != [wanted]
sys.exit(status)
