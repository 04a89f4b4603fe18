#!/usr/bin/env python3
"""Compiles the C++ headers as users do, under one compiler and one setting, and fails on any warning.

A unit is one header, included twice, and an explicit instantiation of each of its functions for float and double, made
from the header itself: nothing is left that only a caller's types would bring to light.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import lvsm_api  # noqa: E402

WARNINGS = "-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion -Werror".split()
# Macros of headers that a client may have included before ours: of Windows, X11, C libraries, Unreal and Qt. The standard
# headers and GLM come before them, since they do not bear them all. Whatever uses one of these names does not compile.
PLATFORM_MACROS = """
    min max near far small hyper interface pascal cdecl IN OUT OPTIONAL CONST VOID TRUE FALSE ERROR NO_ERROR DELETE STRICT
    THIS RELATIVE ABSOLUTE DIFFERENCE OVERFLOW UNDERFLOW DOMAIN None Bool Status Success Always True False Above Below
    Unsorted Complex CursorShape major minor unix linux I PI M_PI B0 log2 check verify text TEXT emit signals slots
""".split()
STANDARDS = {"c++17": "-std=c++17", "c++20": "-std=c++20", "c++23": "-std=c++2b"}
ALL = sorted(lvsm_api.topics(ROOT, "C++"))


def instantiations(header):
    lines = []
    for function in lvsm_api.functions(ROOT, "C++", header, canonical=False):
        if not function.template:
            continue
        result, name, parameters = function.declaration
        for scalar in ("float", "double"):
            values = {"typename": scalar, "glm::qualifier": "glm::defaultp"}
            placeholders = [parameter.split("=")[0].split() for parameter in function.template.split(",")]
            arguments = [values[kind] for kind, _ in placeholders]
            text = f"template {result} {name}<{', '.join(arguments)}>({', '.join(parameters)});"
            for (_, placeholder), argument in zip(placeholders, arguments):
                text = re.sub(rf"\b{placeholder}\b", argument, text)
            lines.append(text)
    return lines


def unit(headers, before=""):
    lines = [before] + [f"#include <lvsm/{header}.hpp>" for header in headers for _ in range(2)]
    body = [line for header in headers for line in instantiations(header)]
    return "\n".join(lines + ["namespace lvsm", "{"] + body + ["}", ""])


def platform_headers():
    includes = ["cassert", "cmath", "cstddef", "cstdint", "cstring", "type_traits", "glm/glm.hpp"]
    return "".join([f"#include <{name}>\n" for name in includes] +
                   [f"#undef {name}\n#define {name} <a macro of another header>\n" for name in PLATFORM_MACROS])


def run(command, **options):
    result = subprocess.run(command, **options)
    if result.returncode != 0:
        print("failed:", *command)
    return result.returncode == 0


def link_two_units(compile_):
    """What is not inline in a header shows when two units meet."""
    with tempfile.TemporaryDirectory() as folder:
        text = "".join(f"#include <lvsm/{header}.hpp>\n" for header in ALL)
        sources = [pathlib.Path(folder) / name for name in ("first.cpp", "second.cpp")]
        sources[0].write_text(text)
        sources[1].write_text(text + "int main() {}\n")
        return run(compile_ + ["-o", folder + "/program"] + sources)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("compiler")
    parser.add_argument("setting", help=f"{', '.join(STANDARDS)}, no_exceptions_no_rtti, two_units, platform_macros or a GLM_ macro")
    parser.add_argument("--system", action="append", default=[], help="include folder of GLM")
    options = parser.parse_args()
    if not shutil.which(options.compiler):
        print(f"skipped: no {options.compiler}")
        return 77

    # The compiler's own folders must not be named again: that would change the order in which it searches them.
    systems = [flag for folder in options.system if folder != "/usr/include" for flag in ("-isystem", folder)]
    compile_ = [options.compiler, *WARNINGS, f"-I{ROOT / 'include'}", *systems, STANDARDS.get(options.setting, "-std=c++17")]
    if options.setting == "two_units":
        return 0 if link_two_units(compile_) else 1
    units = [[header] for header in ALL]
    if options.setting == "no_exceptions_no_rtti":
        compile_ += ["-fno-exceptions", "-fno-rtti"]
    elif options.setting.startswith("GLM_"):
        compile_ += [f"-D{options.setting}"]
        units = [ALL]
    before = platform_headers() if options.setting == "platform_macros" else ""
    checks = [run(compile_ + ["-fsyntax-only", "-x", "c++", "-"], input=unit(headers, before), text=True)
              for headers in units]
    print(f"{sum(checks)} of {len(checks)} units are clean")
    return 0 if all(checks) else 1


if __name__ == "__main__":
    sys.exit(main())
