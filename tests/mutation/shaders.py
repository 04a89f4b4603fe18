"""Mutants of one shader language, judged by parity: the function's row compares it with C++ in double precision."""
import dataclasses
import pathlib
import re
import shutil
import subprocess
import threading
from concurrent import futures

import mutants as maths

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENDINGS = {"glsl": ".glsl", "hlsl": ".hlsli"}
MOST_ROWS = 4  # that a helper's mutant is tried with


def rows_of(file, function):
    """The rows of functions.def that run a function: its own, or those of the functions that call it."""
    rows = set(re.findall(r"^FUNCTION\((\w+),", (ROOT / "tests/parity/functions.def").read_text(), re.MULTILINE))
    seen, found, waiting = set(), [], [function]
    while waiting:
        name = waiting.pop(0)
        if name in seen:
            continue
        seen.add(name)
        if name.removeprefix("lvsm_") in rows:
            found.append(name.removeprefix("lvsm_"))
        else:
            waiting += [other for other, begin, end in file.bodies
                        if any(file.at(i) == name for i in range(begin, end))]
    return found[:MOST_ROWS]


class Parity:
    """One mutated copy of the shaders for each thread that judges."""

    def __init__(self, build, language, topic):
        self.build = pathlib.Path(build)
        self.language = language
        self.path = ROOT / language / f"lvsm/{topic}{ENDINGS[language]}"
        self.file, found = maths.mutants(self.path)
        # Constants that are not the same in all languages are the mirror's to find.
        self.mutants = [m for m in found if any(m.function == name for name, _, _ in self.file.bodies)]

    def judge(self, mutant):
        """The row that fails, None where none does, "" where the mutant does not compile or has no row."""
        folder = self.build / f"mutation/{self.language}/{threading.get_ident()}"
        if not folder.exists():
            shutil.copytree(ROOT / self.language, folder)
        text = self.file.text
        target = folder / "lvsm" / self.path.name
        target.write_text(text[:mutant.start] + mutant.new + text[mutant.end:])
        rows = rows_of(self.file, mutant.function)
        for row in rows:
            done = subprocess.run(
                [self.build / "tests/parity/lvsm_parity", row, "--language", self.language, "--devices", "llvmpipe",
                 f"--{self.language}", folder, "--single", self.build / "single"], capture_output=True, text=True)
            if re.search(rf"glslang on {row}:", done.stderr):
                return ""
            if done.returncode == 77:
                raise SystemExit(77)
            if done.returncode != 0:
                return f"parity/{row}/{self.language}"
        return None if rows else ""

    def run(self, mutants, jobs):
        for mutant in mutants[:1]:
            if self.judge(dataclasses.replace(mutant, new=self.file.text[mutant.start:mutant.end])) is not None:
                raise SystemExit(f"mutate: {mutant.function} fails in parity without any mutant")
        with futures.ThreadPoolExecutor(jobs) as pool:
            verdicts = list(pool.map(self.judge, mutants))
        shutil.rmtree(self.build / f"mutation/{self.language}", ignore_errors=True)
        alive = [m.key for m, test in zip(mutants, verdicts) if test is None]
        print(*[f"parity does not see: {key}" for key in alive], sep="\n", end="\n" if alive else "")
        tried = len(mutants) - verdicts.count("")
        print(f"{self.path.name}: {tried} mutants, {tried - len(alive)} fail in parity, {len(alive)} do not, "
              f"{verdicts.count('')} do not compile", flush=True)
        return tried, len(alive)
