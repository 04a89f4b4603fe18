#!/usr/bin/env python3
"""Follows CONTRIBUTING.md on a copy of the tree: a topic `echo` with one function and its test; then leaves out each step.

    contributing_test.py [STEP]; without it, lists the steps

Passes when check.py finds nothing wrong with all steps done, and with the step left out a fault that names the file or
word that is missing. `everything` leaves out none. The cost and the mutations are not among them: cost/has_not_grown and
mutation/lists say what they lack.
"""
import pathlib
import shutil
import sys
import tempfile

import check

ROOT = pathlib.Path(__file__).resolve().parents[2]

NOTICE = "// SPDX-License-Identifier: MIT\n// Copyright (c) 2026 lvsm contributors\n"
DOC = "/// A depth as it is.\n/// depth: in [0,1], clamped to it. Result in [0,1]. Source: none.\n"
HPP = NOTICE + """// Needs: GLM, config.
// What comes back.
#ifndef LVSM_ECHO_HPP
#define LVSM_ECHO_HPP

#include "config.hpp"

namespace lvsm
{

""" + DOC + """template <typename T>
T echo(T depth)
{
    return detail::clamp(depth, T(0), T(1));
}

} // namespace lvsm

#endif
"""
SHADER = NOTICE + """// Needs: no other.
// What comes back.
#ifndef LVSM_ECHO_{0}
#define LVSM_ECHO_{0}

""" + DOC + """float lvsm_echo(float depth)
{{
    return clamp(depth, 0.0, 1.0);
}}

#endif
"""
WGSL = NOTICE + """// Needs: no other.
// What comes back.

""" + DOC + """fn lvsm_echo(depth: f32) -> f32
{
    return clamp(depth, 0.0, 1.0);
}
"""
TEST = '#include <lvsm/echo.hpp>\n\n#include <doctest/doctest.h>\n\nTEST_CASE("echo") { CHECK(lvsm::echo(2.0f) == 1.0f); }\n'

# Each step: files that it writes, or (file, text, what is put in front of it); and what a fault says without it.
STEPS = {
    "cpp": ({"include/lvsm/echo.hpp": HPP}, "topic echo is missing in C++"),
    "glsl": ({"glsl/lvsm/echo.glsl": SHADER.format("GLSL")}, "topic echo is missing in GLSL"),
    "hlsl": ({"hlsl/lvsm/echo.hlsli": SHADER.format("HLSLI")}, "topic echo is missing in HLSL"),
    "wgsl": ({"wgsl/lvsm/echo.wgsl": WGSL}, "wgsl/lvsm/echo.wgsl is not what is made of GLSL"),
    "row": (("tests/parity/functions.def", "// moments\n", "FUNCTION(echo, Float, (A(0)), depths, 0.0, 1.0)\n"),
            "echo has no row in tests/parity/functions.def"),
    "unit_test": ({"tests/unit/echo_test.cpp": TEST}, "no test in tests/unit/*_test.cpp calls echo"),
    "include_in_cpp": (("include/lvsm/lvsm.hpp", '#include "esm.hpp"\n', '#include "echo.hpp"\n'),
                       "the umbrella does not include echo in C++"),
    "include_in_glsl": (("glsl/lvsm/lvsm.glsl", '#include "esm.glsl"\n', '#include "echo.glsl"\n'),
                        "the umbrella does not include echo in GLSL"),
    "include_in_hlsl": (("hlsl/lvsm/lvsm.hlsli", '#include "esm.hlsli"\n', '#include "echo.hlsli"\n'),
                        "the umbrella does not include echo in HLSL"),
    "manual_of_cpp": (("include/lvsm/lvsm.hpp", "depth, moments, layers", "echo, "), "lvsm.hpp does not name the topic echo"),
    "manual_of_glsl": (("glsl/lvsm/lvsm.glsl", "depth, moments, layers", "echo, "), "lvsm.glsl does not name the topic echo"),
    "manual_of_hlsl": (("hlsl/lvsm/lvsm.hlsli", "depth, moments, layers", "echo, "), "lvsm.hlsli does not name the topic echo"),
    "manual_of_wgsl": (("wgsl/lvsm/lvsm.wgsl", "depth, moments, layers", "echo, "), "lvsm.wgsl does not name the topic echo"),
    "readme": (("README.md", "| `depth` |", "| `echo` | what comes back |\n"), "README.md's table of topics does not name the topic echo"),
}


def take(root, step):
    done = STEPS[step][0]
    if isinstance(done, dict):
        for name, text in done.items():
            (root / name).write_text(text)
        return
    name, before, added = done
    text = (root / name).read_text()
    assert before in text, f"{name} has no {before!r}"
    (root / name).write_text(text.replace(before, added + before, 1))


def main():
    if len(sys.argv) < 2:
        print("everything", *STEPS, sep="\n")
        return 0
    left_out = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch) / "tree"
        shutil.copytree(ROOT, root, ignore=lambda folder, names: [n for n in names if n.startswith((".", "build"))
                                                                  or n in ("shared", "node_modules")])
        for step in STEPS:
            if step != left_out:
                take(root, step)
        found = list(check.differences(root))
    print(*found, sep="\n")
    if left_out == "everything":
        return 1 if found else 0
    return 0 if any(STEPS[left_out][1] in line for line in found) else 1


if __name__ == "__main__":
    sys.exit(main())
