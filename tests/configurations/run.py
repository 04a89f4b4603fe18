#!/usr/bin/env python3
"""Builds the unit tests and the rows of tests/parity in one configuration, as a user's build would, and runs them.

    run.py NAME ...       exit status 77 where the compiler, the emulator or the processor is missing
    run.py --record FOLDER    what the runs reported there becomes recorded.json, which docs/configurations.md shows

What has been built is built again only where a source or a flag has changed.
"""
import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys

from configurations import CONFIGURATIONS

ROOT = pathlib.Path(__file__).resolve().parents[2]
RECORDED = pathlib.Path(__file__).with_name("recorded.json")
UNIT = [path for path in sorted((ROOT / "tests/unit").glob("*.cpp")) if path.name != "assert_test.cpp"]


def missing(configuration):
    """Why this machine cannot run a configuration, or nothing."""
    for tool in filter(None, (configuration.compiler, configuration.runner)):
        if not shutil.which(tool):
            return f"no {tool}"
    cpu = pathlib.Path("/proc/cpuinfo")
    flags = cpu.read_text().split() if cpu.exists() else []
    return "".join(f"the processor has no {flag}" for flag in configuration.cpu if flag not in flags)


def run(*command, **options):
    return subprocess.run([str(part) for part in command], **options)


def build(configuration, folder, answers, systems):
    """Compiles what has changed; False where something does not compile."""
    sources = hashlib.sha256(configuration.command.encode())
    for part in ("include", "tests/unit", "tests/parity", "tests/configurations"):
        for path in sorted((ROOT / part).rglob("*.*pp")) + sorted((ROOT / part).rglob("*.def")):
            sources.update(path.read_bytes())
    stamp = folder / "built"
    if stamp.exists() and stamp.read_text() == sources.hexdigest():
        return True
    stamp.unlink(missing_ok=True)
    # After the compiler's own folders, which for another processor hold other headers.
    includes = [f"-I{ROOT / 'include'}", f"-I{ROOT / 'tests/parity'}"]
    includes += [flag for system in systems for flag in ("-idirafter", system)]

    def compiled(source):
        # The test framework's own file is no part of what is tested, and doctest's quick checks compile in half the time.
        flags = ["-O0" if flag.startswith("-O") and source.name == "main.cpp" else flag for flag in configuration.flags.split()]
        return run(configuration.compiler, *flags, "-DDOCTEST_CONFIG_SUPER_FAST_ASSERTS", *includes, "-c", source, "-o",
                   folder / (source.name + ".o")).returncode == 0

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        if not all(pool.map(compiled, [*UNIT, *answers])):
            return False
    for program, parts in (("unit", UNIT), ("answers", answers)):
        if run(configuration.compiler, *[folder / (part.name + ".o") for part in parts], *configuration.link.split(), "-o",
               folder / program).returncode != 0:
            return False
    stamp.write_text(sources.hexdigest())
    return True


def run_unit(configuration, folder):
    """What the unit tests said, as figures; prints what failed."""
    done = run(*configuration.runner.split(), folder / "unit", stdout=subprocess.PIPE, text=True)
    counts = re.search(r"test cases: *(\d+) \| *(\d+) passed", done.stdout)
    if done.returncode != 0 or not counts:
        print(done.stdout)
    left_out = re.findall(r"MESSAGE: left out ", done.stdout)
    return {"cases": int(counts[1]) if counts else 0, "left_out": len(left_out), "unit_passed": done.returncode == 0}


def run_parity(configuration, folder, rows, report):
    """What the judge of tests/parity said of the answers, as figures."""
    inputs = folder / "rows"
    shutil.rmtree(inputs, ignore_errors=True)
    inputs.mkdir()
    run(rows, "write", inputs, check=True)
    answered = run(*configuration.runner.split(), folder / "answers", inputs).returncode == 0
    judged = run(rows, "judge", inputs, configuration.name, report, "precise").returncode == 0
    shutil.rmtree(inputs)
    found = json.loads(report.read_text())
    return {"functions": found["functions"], "inputs": found["inputs"], "parity_passed": answered and judged}


def record(folder):
    reports = {path.stem: json.loads(path.read_text()) for path in folder.glob("*.json")}
    lines = [json.dumps(reports[configuration.name]) for configuration in CONFIGURATIONS]
    RECORDED.write_text("[\n" + ",\n".join(lines) + "\n]\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("name", nargs="?", choices=[configuration.name for configuration in CONFIGURATIONS])
    parser.add_argument("--record", type=pathlib.Path, help="folder of reports")
    parser.add_argument("--folder", type=pathlib.Path, help="to build in")
    parser.add_argument("--answers", action="append", type=pathlib.Path, help="a source of the program of that name")
    parser.add_argument("--rows", type=pathlib.Path, help="the program lvsm_client_rows")
    parser.add_argument("--report", type=pathlib.Path)
    parser.add_argument("--system", action="append", default=[], help="include folder of GLM or doctest")
    options = parser.parse_args()
    if options.record:
        record(options.record)
        return 0

    configuration = next(c for c in CONFIGURATIONS if c.name == options.name)
    reason = missing(configuration)
    if reason:
        print(f"skipped: {reason}")
        return 77
    options.folder.mkdir(parents=True, exist_ok=True)
    options.report.parent.mkdir(parents=True, exist_ok=True)
    if not build(configuration, options.folder, options.answers, options.system):
        return 1
    version = run(configuration.compiler, "--version", stdout=subprocess.PIPE, text=True).stdout.splitlines()[0]
    found = {"name": configuration.name, "command": configuration.command, "runner": configuration.runner,
             "compiler": version}
    found.update(run_unit(configuration, options.folder))
    found.update(run_parity(configuration, options.folder, options.rows, options.folder / "judged.json"))
    options.report.write_text(json.dumps(found) + "\n")
    print(json.dumps(found, indent=1))
    return 0 if found["unit_passed"] and found["parity_passed"] else 1


if __name__ == "__main__":
    sys.exit(main())
