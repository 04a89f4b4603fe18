#!/usr/bin/env python3
"""The recorded run of lvsm_bench that docs/bench.md shows.

    recorded.py --check LVSM_BENCH     fails where the run recorded is one of other benchmarks than there are now
    recorded.py --record LVSM_BENCH    runs them, nine times each, and writes the medians to recorded.json

Times depend on the machine and on what else it does, so no test compares them.
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import recorded_run

FILE = pathlib.Path(__file__).with_name("recorded.json")
REPETITIONS = 9
COMMAND = f"build/tests/bench/lvsm_bench --benchmark_repetitions={REPETITIONS} --benchmark_enable_random_interleaving"
COUNTERS = ("of_bandwidth", "share_sampled")


def machine(context):
    """In words: the processor, how much of it there is, and its last cache."""
    cache = max((c["size"] for c in context["caches"] if c["level"] == 3), default=0)
    return f"{recorded_run.processor()}, {cache >> 20} MiB of L3 cache"


def record(program):
    done = subprocess.run([program, *COMMAND.split()[1:], "--benchmark_format=json"], check=True, stdout=subprocess.PIPE)
    report = json.loads(done.stdout)
    runs = {}
    for run in report["benchmarks"]:
        if run["run_type"] == "iteration":
            runs.setdefault(run["run_name"], []).append(run)
    rows = []
    for name, all_ in sorted(runs.items(), key=lambda item: listed(program).index(item[0])):
        scale = {"ns": 1.0e-6, "us": 1.0e-3, "ms": 1.0}[all_[0]["time_unit"]]
        row = {"name": name, "ms": round(scale * statistics.median(run["real_time"] for run in all_), 4)}
        row.update({counter: round(statistics.median(run[counter] for run in all_), 4)
                    for counter in COUNTERS if counter in all_[0]})
        rows.append(row)
    context = report["context"]
    niceness = os.getpriority(os.PRIO_PROCESS, 0)
    head = {"date": context["date"][:10], "machine": machine(context), "compiler": context["compiler"],
            "load": recorded_run.load(), "command": (f"nice -n {niceness} " if niceness else "") + COMMAND}
    text = ",\n".join(f"{json.dumps(key)}: {json.dumps(value)}" for key, value in head.items())
    FILE.write_text("{\n" + text + ',\n"rows": [\n' + ",\n".join(map(json.dumps, rows)) + "\n]}\n")


def listed(program):
    """The benchmarks that there are, in their order."""
    return subprocess.run([program, "--benchmark_list_tests"], check=True, stdout=subprocess.PIPE, text=True).stdout.split()


def check(program):
    names = listed(program)
    recorded = [row["name"] for row in json.loads(FILE.read_text())["rows"]]
    for name in sorted(set(names) ^ set(recorded)):
        yield f"{name} is {'not recorded' if name in names else 'recorded, but there is no such benchmark'}"


if __name__ == "__main__":
    recorded_run.main(__doc__, check, record)
