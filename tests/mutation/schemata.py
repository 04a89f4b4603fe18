"""One build that holds every mutant of the C++ headers: each function body once for each of its mutants, in a switch
over a number that the environment gives. Building thousands of programs would take a day."""
import collections
import os
import pathlib
import re
import subprocess
import sys
from concurrent import futures

import mutants as maths

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
# -O1: the mutants run the tests thousands of times, and are compiled once.
# A mutant that leaves an array or an integer's range is stopped there, as the sanitizers of tests/fuzz would. g++ takes
# the array at the end of a structure for one of any length unless it is told not to.
FLAGS = ["-std=c++17", "-O1", "-w", "-fno-strict-aliasing", "-fsanitize=bounds,signed-integer-overflow,float-cast-overflow",
         "-fsanitize-undefined-trap-on-error"]
OF_COMPILER = {"clang": ["-ferror-limit=0"], "gcc": ["-fsanitize=bounds-strict"]}


def edited(text, start, mutant):
    """The text, which begins at `start` of its file, with the mutant in it."""
    return text[:mutant.start - start] + mutant.new + text[mutant.end - start:]


def with_all(text, file, mutants, numbers):
    """A header with all its mutants, and the mutant of each of its lines (None where the line is everybody's)."""
    pieces, at = [], 0
    of_body = collections.defaultdict(list)
    apart = []
    for mutant in mutants:
        for name, begin, end in file.bodies:
            if file.tokens[begin - 1].start < mutant.start < file.tokens[end].start:
                of_body[begin, end].append(mutant)
                break
        else:
            apart.append(mutant)
    edits = []  # (start, stop, [(text, mutant or None)])
    for (begin, end), inside in of_body.items():
        start, stop = file.tokens[begin - 1].end, file.tokens[end].start
        body = text[start:stop]
        parts = [("\nswitch (::lvsmMutant)\n{\n", None)]
        result = file.results[begin]
        call = f"return [&]() LVSM_PLAIN -> {result}" if result else "[&]() LVSM_PLAIN"
        for mutant in inside:
            # A function of its own: compilers take more than twice as long for one that is twice as large.
            parts.append((f"case {numbers[mutant.key]}: {call} {{{edited(body, start, mutant)}}}(); break;\n", mutant))
        parts.append((f"default: {{{body}}}\n}}\n", None))
        edits.append((start, stop, parts))
    of_number = collections.defaultdict(list)
    for mutant in apart:
        of_number[mutant.start, mutant.end].append(mutant)
    for (start, stop), changes in of_number.items():
        choice = text[start:stop]
        for mutant in changes:
            choice = f"(::lvsmSelectedMutant() == {numbers[mutant.key]} ? {mutant.new} : {choice})"
        edits.append((start, stop, [(choice, None)]))
    lines = []
    for start, stop, parts in sorted(edits, key=lambda edit: edit[0]):
        pieces.append((text[at:start], None))
        pieces += parts
        at = stop
    pieces.append((text[at:], None))
    for piece, mutant in pieces:
        lines += [mutant] * piece.count("\n")
    joined = "".join(piece for piece, _ in pieces)
    # A constant that a mutant may change is none for the compiler.
    joined = re.sub(r"\bconstexpr ([\w<>]+ k\w+ = [^;]*lvsmSelectedMutant)", r"inline const \1", joined)
    return joined, lines


class Build:
    """A topic's unit tests with a header that holds the given mutants."""

    def __init__(self, folder, topic, mutants, compiler, jobs):
        self.folder = pathlib.Path(folder) / topic
        self.folder.mkdir(parents=True, exist_ok=True)
        self.topic = topic
        self.mutants = mutants
        self.compiler = compiler
        self.jobs = jobs
        self.numbers = {mutant.key: number for number, mutant in enumerate(mutants)}
        self.broken = set()  # keys of mutants that do not compile
        self.lines = []
        self.program = self.folder / "lvsm_unit"

    def write_headers(self):
        """All of them, since each finds its neighbours beside itself."""
        folder = self.folder / "include/lvsm"
        folder.mkdir(parents=True, exist_ok=True)
        for path in (ROOT / "include/lvsm").glob("*.hpp"):
            text = path.read_text()
            if path.stem == self.topic:
                kept = [mutant for mutant in self.mutants if mutant.key not in self.broken]
                text, self.lines = with_all(text, maths.File(text), kept, self.numbers)
            target = folder / path.name
            if not target.exists() or target.read_text() != text:
                target.write_text(text)

    def compile(self, source):
        """The compiler's messages, or None where the object file is there."""
        target = self.folder / (source.stem + ".o")
        inputs = [source, *(self.folder / "include/lvsm").glob("*.hpp"), *(ROOT / "tests/unit").glob("*.hpp")]
        if target.exists() and target.stat().st_mtime > max(path.stat().st_mtime for path in inputs):
            return None
        target.unlink(missing_ok=True)
        flags = [*FLAGS, *OF_COMPILER["clang" if "clang" in self.compiler else "gcc"]]
        command = [self.compiler, *flags, "-I", str(self.folder / "include"),
                   "-include", str(HERE / "selected.hpp"), "-c", str(source), "-o", str(target)]
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"})
        return done.stderr if done.returncode != 0 else None

    def blame(self, messages):
        """Keys of the mutants at whose lines the compiler stopped."""
        found = set()
        for pattern in (r":(\d+):\d+: (?:fatal )?error", r":(\d+):"):
            for line in re.findall(rf"include/lvsm/{self.topic}\.hpp" + pattern, messages):
                mutant = self.lines[int(line) - 1] if int(line) <= len(self.lines) else None
                if mutant:
                    found.add(mutant.key)
            if found:
                break
        return found

    def run(self, sources):
        """Builds; mutants that do not compile are left out."""
        for _ in range(8):
            self.write_headers()
            with futures.ThreadPoolExecutor(self.jobs) as pool:
                messages = [m for m in pool.map(self.compile, sources) if m is not None]
            if not messages:
                break
            blamed = set().union(*(self.blame(m) for m in messages)) - self.broken
            if not blamed:
                sys.exit("mutate: the headers with their mutants do not compile:\n" + messages[0][:4000])
            self.broken |= blamed
        else:
            sys.exit("mutate: mutants that do not compile remain after eight rounds")
        objects = [str(self.folder / (source.stem + ".o")) for source in sources]
        subprocess.run([self.compiler, *objects, "-o", str(self.program)], check=True)
