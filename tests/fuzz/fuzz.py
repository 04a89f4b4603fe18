#!/usr/bin/env python3
"""Feeds the host functions bytes that libFuzzer makes up, under AddressSanitizer and UndefinedBehaviorSanitizer.

    tests/fuzz/fuzz.py                             20,000 inputs for each target
    tests/fuzz/fuzz.py optimal --runs 100000000    many, for one
    tests/fuzz/fuzz.py optimal --input FILE        an input that failed, again

A target is a file beside this one. What fails is written to build/fuzz/TARGET-crash-...; make a unit test of it. Without
clang++ or its libFuzzer the exit status is 77.
"""
import argparse
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SANITIZERS = "fuzzer,address,undefined,float-cast-overflow"
FLAGS = ["-std=c++17", "-O1", "-g", f"-fsanitize={SANITIZERS}", "-fno-sanitize-recover=all"]


def said(source, what):
    """The words of a line "// Sources: ..." or "// Packages: ..." in a target: what else it is built of."""
    return (re.findall(rf"^// {what}: (.+)$", source.read_text(), re.MULTILINE) or [""])[0].split()


def compile_target(target, compiler, folder):
    """The program, built where it is older than what it is made of; None where there is no libFuzzer."""
    program = folder / target
    source = HERE / f"{target}.cpp"
    sources = [ROOT / name for name in said(source, "Sources")]
    inputs = [source, *sources, HERE / "bytes.hpp", *(ROOT / "include/lvsm").glob("*.hpp")]
    if program.exists() and program.stat().st_mtime > max(path.stat().st_mtime for path in inputs):
        return program
    packages = said(source, "Packages")
    try:
        found = subprocess.run(["pkg-config", "--cflags", "--libs", *packages], capture_output=True, text=True)
        if packages and found.returncode != 0:
            print(f"skip: {found.stderr}")
            return None
        libraries = found.stdout.split() if packages else []
        command = [compiler, *FLAGS, "-I", str(ROOT / "include"), "-I", str(ROOT / "tests/support"), str(source),
                   *map(str, sources), *libraries, "-o", str(program)]
        done = subprocess.run(command, capture_output=True, text=True)
    except FileNotFoundError as error:
        print(f"skip: no {error.filename}")
        return None
    if done.returncode != 0 and "libclang_rt" in done.stderr:
        print(f"skip: {compiler} has no libFuzzer (Debian: libclang-rt-14-dev)")
        return None
    if done.returncode != 0:
        sys.exit(done.stderr)
    return program


def main():
    targets = sorted(path.stem for path in HERE.glob("*.cpp"))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("target", nargs="*", default=targets, choices=[*targets, []], metavar="TARGET",
                        help=", ".join(targets))
    parser.add_argument("--runs", type=int, default=20000, help="inputs for each target")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--input", help="run this file alone")
    parser.add_argument("--build", default=str(ROOT / "build"), help="the build folder")
    parser.add_argument("--compiler", default="clang++")
    options = parser.parse_args()

    folder = pathlib.Path(options.build) / "fuzz"
    folder.mkdir(parents=True, exist_ok=True)
    failed = False
    for target in options.target:
        program = compile_target(target, options.compiler, folder)
        if program is None:
            sys.exit(77)
        # The longest input is an image of the largest size that a target makes.
        arguments = [options.input] if options.input else [
            f"-runs={options.runs}", f"-seed={options.seed}", "-max_len=4096", "-len_control=20", "-timeout=20",
            f"-artifact_prefix={folder}/{target}-", "-print_final_stats=0", "-verbosity=0"]
        done = subprocess.run([program, *arguments], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        print(f"{target}: {'fails' if done.returncode else 'holds'} for {options.input or f'{options.runs} inputs'}")
        if done.returncode:
            print(done.stdout[-6000:])
            failed = True
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
