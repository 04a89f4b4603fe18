"""The tables of docs/mutations.md, from what mutate.py --record has written."""
import json
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent

def recorded():
    return json.loads((HERE / "recorded.json").read_text())


def topics():
    reasons = set((HERE / "survivors.txt").read_text().splitlines())
    yield ["topic", "mutants", "fail a test", "do not compile", "survive with a reason", "survive without one"]
    rows = []
    for topic, ran in sorted(recorded()["topics"].items()):
        reasoned = sum(key in reasons for key in ran["survivors"])
        rows.append([ran["killed"] + ran["broken"] + len(ran["survivors"]), ran["killed"], ran["broken"], reasoned,
                     len(ran["survivors"]) - reasoned])
        yield [f"`{topic}`", *map(str, rows[-1])]
    yield ["all of these", *(str(sum(column)) for column in zip(*rows))]


def named():
    tests = recorded()["named"]
    yield ["", "function", "change", "test that fails"]
    number, reason = 0, ""
    for line in (HERE / "named.txt").read_text().splitlines():
        if line.startswith("# "):
            reason = line[2:]
        elif line:
            number += 1
            function = re.match(r"\w+/(\w+):", line)[1]
            yield [str(number), f"`{function}`", reason, tests[line] or "none"]


TABLES = {"mutation.topics": lambda: list(topics()), "mutation.named": lambda: list(named())}
