#!/usr/bin/env python3
"""Writes the reports of two functions, spoils them in one way, and passes when join_report.py refuses them.

    report_test.py CASE; without it, lists the cases
"""
import json
import pathlib
import subprocess
import sys
import tempfile

JOIN = pathlib.Path(__file__).with_name("join_report.py")
WAYS = [("cpp", "c++", "host"),
        *[("glsl", "glslang", device) for device in ("llvmpipe", "SwiftShader")],
        *[("hlsl", compiler, device) for compiler in ("glslang", "dxc") for device in ("llvmpipe", "SwiftShader")],
        *[("wgsl", "naga", device) for device in ("llvmpipe", "SwiftShader")]]


def good():
    """By file: the verdicts of two functions in every way."""
    files = {}
    for function in ("first", "second"):
        for language, compiler, device in WAYS:
            for domain in ("depths", "hostile"):
                files.setdefault(f"{function}.{language}.json", []).append(
                    {"function": function, "language": language, "compiler": compiler, "source": "include",
                     "device": device, "domain": domain, "inputs": 4096, "non_finite": 0, "outside": 0})
    return files


def each(files, change):
    for rows in files.values():
        for row in rows:
            change(row)


# Of each case: what it does to the reports, and a part of what must be said; None where nothing is wrong.
CASES = {
    "nothing": (lambda files: None, None),
    "no_inputs": (lambda files: each(files, lambda row: row.update(inputs=0)), "no inputs: first"),
    "hostile_alone": (lambda files: each(files, lambda row: row.update(domain="hostile")), "one domain of its own"),
    "no_hostile": (lambda files: [rows.__delitem__(slice(1, None, 2)) for rows in files.values()], "one domain of its own"),
    "not_finite": (lambda files: files["second.hlsl.json"][0].update(non_finite=7), "7 non_finite: second"),
    "outside": (lambda files: files["first.glsl.json"][0].update(outside=1), "1 outside: first"),
    "empty_folder": (lambda files: files.clear(), "first has not run"),
    "function_missing": (lambda files: [files.pop(f"second.{language}.json") for language in ("cpp", "glsl", "hlsl", "wgsl")],
                         "second has not run"),
    "device_missing": (lambda files: files["first.glsl.json"].__delitem__(slice(2, None)), "first in glsl"),
    "wgsl_missing": (lambda files: files.pop("second.wgsl.json"), "second in wgsl"),
    "wgsl_device_missing": (lambda files: files["first.wgsl.json"].__delitem__(slice(2, None)), "first in wgsl"),
    "compiler_missing": (lambda files: files["first.hlsl.json"].__delitem__(slice(4, None)), "first in hlsl"),
    "old_function": (lambda files: files.update({"old.cpp.json": []}), None),
}


def main():
    if len(sys.argv) < 2:
        print(*CASES, sep="\n")
        return 0
    spoil, expected = CASES[sys.argv[1]]
    files = good()
    spoil(files)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program = folder / "parity"
        program.write_text("#!/bin/sh\necho first\necho second\n")
        program.chmod(0o755)
        reports = folder / "parity.d"
        reports.mkdir()
        for file, rows in files.items():
            (reports / file).write_text(json.dumps(rows))
        done = subprocess.run([sys.executable, JOIN, program, reports, folder / "parity.json", "--complete"],
                              stdout=subprocess.PIPE, text=True)
        print(done.stdout, end="")
        written = (folder / "parity.json").exists()
        lingering = (reports / "old.cpp.json").exists()
    refused = done.returncode != 0 and not written and (expected or "") in done.stdout
    return 0 if not lingering and refused == (expected is not None) and written == (expected is None) else 1


if __name__ == "__main__":
    sys.exit(main())
