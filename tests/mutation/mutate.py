#!/usr/bin/env python3
"""Changes the maths in small ways, one at a time, and says which changes no unit test notices.

    tests/mutation/mutate.py                    every mutant of every C++ header (an hour on two cores)
    tests/mutation/mutate.py --topic plane      of some topics
    tests/mutation/mutate.py --sample 8         a few, the same ones each time
    tests/mutation/mutate.py --check            runs nothing: the lists still match the sources
    tests/mutation/mutate.py --language glsl    of one shader language alone, which parity has to notice

A survivor needs a reason: survivors.txt lists those that change nothing that is promised, each group under its reason.
named.txt holds changes written by hand; each of them has to fail a test. Exits with 1 where a survivor has no reason or
a named change survives. A new header is a new topic, which --check asks for; docs/mutations.md shows what --record has
written.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import time
from concurrent import futures

import mutants as maths
from schemata import HERE, ROOT, Build
from shaders import Parity

NO_TOPIC = {"lvsm": "includes the others and holds nothing of its own"}
QUICK = 0.3  # seconds that the first tests of a mutant may take together


def listed(path):
    """Keys of a list and the reason that each stands under."""
    reasons, reason, ended = {}, [], True
    for line in path.read_text().splitlines():
        if line.startswith("# "):
            reason = [line[2:]] if ended else reason + [line[2:]]
            ended = False
        elif line:
            reasons[line] = " ".join(reason)
        ended = ended or not line.startswith("#")
    return reasons


def headers():
    return {path.stem: path for path in sorted((ROOT / "include/lvsm").glob("*.hpp"))}


def all_mutants():
    """By topic, those that the rules make and those that are named."""
    found = {topic: maths.mutants(path)[1] for topic, path in headers().items()}
    known = {mutant.key for mutants in found.values() for mutant in mutants}
    lost = []
    for key in listed(HERE / "named.txt"):
        if key in known:
            continue
        topic = maths.parse(key)[0]
        mutant = maths.named(headers()[topic], key) if topic in found else None
        if mutant is None:
            lost.append(key)
        else:
            found[topic].append(mutant)
    return found, lost


def includes(path, seen):
    for name in re.findall(r'#include ["<](?:lvsm/)?(\w+)\.hpp[">]', path.read_text()):
        header = ROOT / f"include/lvsm/{name}.hpp"
        if header.exists() and name not in seen:
            seen.add(name)
            includes(header, seen)
    return seen


class Tests:
    """The unit tests that judge a topic: its own, and those of every function's range; all that read it where it has none
    of its own. They are told apart by their files' names."""

    def __init__(self, topic):
        unit = ROOT / "tests/unit"
        reading = [path for path in sorted(unit.glob("*_test.cpp"))
                   if "LVSM_ASSERT" not in path.read_text() and topic in includes(path, set())]
        own = [path for path in reading if re.fullmatch(rf"{topic}(_[a-z]+)?_test", path.stem)]
        self.sources = [*own, *(path for path in reading if path.stem == "totality_test")] if own else reading
        self.steps = []
        self.seconds = 0.0

    def time(self, program):
        """Parts the cases into steps: the quick ones of each file first."""
        quick, slow = [], []
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        for source in self.sources:
            out = subprocess.run([program, f"-sf=*/{source.name}", "-d=true"], capture_output=True, text=True)
            if out.returncode != 0:
                sys.exit(f"mutate: {source.name} fails without any mutant:\n{out.stdout[-3000:]}")
            left = QUICK
            cases = re.findall(r"^(\d+\.\d+) s: (.+)$", out.stdout, re.MULTILINE)
            for seconds, name in sorted((float(s), name) for s, name in cases):
                left -= seconds
                (quick if left > 0 else slow).append(name)
        self.steps = [names for names in (quick, slow) if names]
        self.seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def failing_case(output):
    names = re.findall(r"^TEST CASE:  (.+)$", output, re.MULTILINE)
    return names[-1].strip() if names else "crash"


def try_mutant(program, number, steps, seconds):
    """The test that fails, or None. A loop that does not end is stopped by the processor's time, whatever else runs."""
    limit = f"--cpu={3 + int(3 * seconds)}"
    for names in steps:
        pattern = ",".join(name.replace("\\", "\\\\").replace(",", "\\,") for name in names)
        done = subprocess.run(["prlimit", limit, program, "-aa=1", "-nc=true", "-tc=" + pattern], capture_output=True,
                              text=True, env={**os.environ, "LVSM_MUTANT": str(number)}, errors="replace")
        if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
            return "does not end"
        if done.returncode != 0:
            return failing_case(done.stdout)
    return None


def check(found, lost):
    """The lists' lines that no longer match the sources."""
    known = {mutant.key for mutants in found.values() for mutant in mutants}
    errors = [f"named.txt: no such line any more: {key}" for key in lost]
    for key, reason in listed(HERE / "survivors.txt").items():
        if key not in known:
            errors.append(f"survivors.txt: no such mutant any more: {key}")
        if not reason:
            errors.append(f"survivors.txt: no reason above: {key}")
    return errors


def unrecorded(found):
    """What docs/mutations.md lacks: a header without its row, a row without its header or of other mutants than it has
    now, a named change without its test, more than one survivor in a hundred without a reason."""
    recorded = json.loads((HERE / "recorded.json").read_text())
    rows, topics = recorded["topics"], set(found)
    errors = [f"recorded.json: {topic}.hpp has not been run: tests/mutation/mutate.py --topic {topic} --record"
              for topic in sorted(topics - set(rows))]
    errors += [f"recorded.json: no header is named {topic}.hpp any more" for topic in sorted(set(rows) - topics)]
    reasons = listed(HERE / "survivors.txt")
    for topic in sorted(topics & set(rows)):
        row, keys = rows[topic], {mutant.key for mutant in found[topic]}
        ran = row["killed"] + row["broken"] + len(row["survivors"])
        if ran != len(keys) or set(row["survivors"]) - keys:
            errors.append(f"recorded.json: {topic}.hpp has {len(keys)} mutants, of which {ran} or others were run: "
                          f"tests/mutation/mutate.py --topic {topic} --record")
    errors += [f"recorded.json: no test fails for {key}: tests/mutation/mutate.py --named --record"
               for key in listed(HERE / "named.txt") if not recorded["named"].get(key)]
    bare = [key for row in rows.values() for key in row["survivors"] if key not in reasons]
    count = sum(row["killed"] + row["broken"] + len(row["survivors"]) for row in rows.values())
    if 100 * len(bare) > count:
        errors.append(f"recorded.json: {len(bare)} of {count} mutants survive without a reason, more than one in a hundred")
    return errors


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--topic", action="append", help="a header's name without its ending; may be repeated")
    parser.add_argument("--sample", type=int, help="so many mutants, spread evenly")
    parser.add_argument("--unlisted", action="store_true", help="leave out the survivors that have their reason")
    parser.add_argument("--language", choices=["glsl", "hlsl"], help="change this one alone; needs the tests built")
    parser.add_argument("--named", action="store_true", help="only the changes of named.txt")
    parser.add_argument("--record", action="store_true", help="write what came out for docs/mutations.md")
    parser.add_argument("--check", action="store_true", help="only compare the lists with the sources")
    parser.add_argument("--build", default=str(ROOT / "build"), help="the build folder")
    parser.add_argument("--compiler", default=os.environ.get("CXX", "c++"))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    if options.record and (options.sample or options.unlisted):
        parser.error("only whole topics and named changes are recorded")
    return options


def chosen(found, options, reasons):
    """The mutants to run, by topic."""
    if options.topic:
        unknown = set(options.topic) - set(found)
        if unknown:
            sys.exit(f"mutate: no header is named {', '.join(sorted(unknown))}")
        found = {topic: found[topic] for topic in options.topic}
    if options.named:
        named = listed(HERE / "named.txt")
        found = {topic: [m for m in mutants if m.key in named] for topic, mutants in found.items()}
    if options.unlisted:
        found = {topic: [m for m in mutants if m.key not in reasons] for topic, mutants in found.items()}
    if options.sample:
        # And one that is known to survive: neither may come out as the other.
        flat = [m for mutants in found.values() for m in mutants if m.key not in reasons]
        kept = {flat[i * len(flat) // options.sample].key for i in range(options.sample)}
        kept.update([m.key for mutants in found.values() for m in mutants if m.key in reasons][:1])
        found = {topic: [m for m in mutants if m.key in kept] for topic, mutants in found.items()}
    return {topic: mutants for topic, mutants in found.items() if mutants}


def run_shaders(options):
    """Mutants of one shader language; what parity does not see is printed, for a person to judge."""
    folder = ROOT / options.language / "lvsm"
    topics = options.topic or sorted(path.stem for path in folder.glob("*.*") if path.stem not in ("lvsm", "config"))
    for topic in topics:
        parity = Parity(options.build, options.language, topic)
        count = min(options.sample or len(parity.mutants), len(parity.mutants))
        parity.run([parity.mutants[i * len(parity.mutants) // count] for i in range(count)], options.jobs)


def run_topic(topic, mutants, options, reasons, named):
    started = time.time()
    tests = Tests(topic)
    build = Build(pathlib.Path(options.build) / "mutation", topic, mutants, options.compiler, options.jobs)
    build.run([ROOT / "tests/unit/main.cpp", *tests.sources])
    tests.time(build.program)
    built = time.time() - started

    def judge(mutant):
        killer = try_mutant(build.program, build.numbers[mutant.key], tests.steps, tests.seconds)
        return {"topic": topic, "mutant": mutant.key, "test": killer, "named": mutant.key in named,
                "reason": reasons.get(mutant.key)}

    with futures.ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(judge, [mutant for mutant in mutants if mutant.key not in build.broken]))
    for result in results:
        if result["test"] is None and (result["named"] or not result["reason"]):
            print("survives: " + result["mutant"])
        elif result["test"] and result["reason"]:
            print("is listed as a survivor, and fails a test: " + result["mutant"])
    alive = sum(result["test"] is None for result in results)
    print(f"{topic}: {len(results)} mutants in {time.time() - started:.0f} s, {built:.0f} s of it to build; {alive} survive, "
          f"{len(mutants) - len(results)} do not compile", flush=True)
    return results


def remember(topic, results, mutants, options):
    """Records what came out: of named changes which test fails, and of a whole topic how many mutants do."""
    path = HERE / "recorded.json"
    recorded = json.loads(path.read_text()) if path.exists() else {"topics": {}, "named": {}}
    keys = listed(HERE / "named.txt")
    known = {key: test for key, test in recorded["named"].items() if key in keys}
    known.update({result["mutant"]: result["test"] for result in results if result["named"]})
    recorded["named"] = {key: known[key] for key in keys if key in known}
    if not options.named:
        alive = [result["mutant"] for result in results if result["test"] is None]
        recorded["topics"][topic] = {"killed": len(results) - len(alive), "broken": len(mutants) - len(results),
                                     "survivors": alive}
    path.write_text(json.dumps(recorded, indent=1, sort_keys=False) + "\n")


def main():
    options = arguments()
    found, lost = all_mutants()
    errors = check(found, lost)
    if options.check:
        errors += unrecorded({topic: mutants for topic, mutants in found.items() if topic not in NO_TOPIC})
    for error in errors:
        print(error)
    if options.check:
        sys.exit(1 if errors else 0)
    if options.language:
        run_shaders(options)
        return
    reasons, named = listed(HERE / "survivors.txt"), listed(HERE / "named.txt")
    found = chosen(found, options, reasons)

    results = []
    for topic, mutants in found.items():
        of_topic = run_topic(topic, mutants, options, reasons, named)
        results += of_topic
        if options.record:
            remember(topic, of_topic, mutants, options)

    alive = [r for r in results if r["test"] is None]
    bare = [r for r in alive if not r["reason"] or r["named"]]
    wrong = [r for r in results if r["test"] and r["reason"]]
    print(f"{len(results)} mutants: {len(results) - len(alive)} fail a test, {len(alive)} survive, "
          f"{len(bare)} of them without a reason")
    sys.exit(1 if bare or wrong or errors else 0)


if __name__ == "__main__":
    main()
