"""The recorded costs, as tests/docs/documents.py shows them. cost/has_not_grown compares them with what is now."""
import json
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
RECORDED = json.loads((HERE / "recorded.json").read_text())
ROWS = {(row["target"], row["name"]): row for row in RECORDED["rows"]}
TARGETS = list(dict.fromkeys(row["target"] for row in RECORDED["rows"]))
FIRST = TARGETS[0]


def fetches():
    """Texels of four components that each estimate reads, in the order of estimates.def."""
    text = (HERE / "estimates.def").read_text()
    return {name: int(count) for name, count in re.findall(r"^ESTIMATE\(([^,]+), (\d+),", text, re.MULTILINE)}


def both(target, name):
    return f"{ROWS[target, name]['instructions']}, {ROWS[target, name]['inverse_throughput']}"


def estimates():
    """Instructions and inverse throughput of each whole estimate."""
    return [["estimate", *TARGETS], *([name, *(both(target, name) for target in TARGETS)] for name in fetches())]


def passes():
    """The same of each whole pass, which has no loads apart."""
    names = [name for target, name in ROWS if target == FIRST and ROWS[target, name]["load_instructions"] == 0]
    return [["pass", *TARGETS], *([name, *(both(target, name) for target in TARGETS)] for name in names)]


def cost(name, target=FIRST):
    """Inverse throughput of an estimate or function, its loads taken off."""
    return ROWS[target, name]["inverse_throughput"]


def instructions(name, target=FIRST):
    """Those of an estimate or function, without its loads."""
    return ROWS[target, name]["instructions"]


def loads(name, target=FIRST):
    """That of the loads alone."""
    return ROWS[target, name]["load_inverse_throughput"]


def paid(name, target=FIRST):
    """Both together."""
    return cost(name, target) + loads(name, target)


TABLES = {"cost.estimates": estimates, "cost.passes": passes}
NAMES = {"cost": cost, "instructions": instructions, "loads": loads, "paid": paid, "mesa": re.search(r"[\d.]+", RECORDED["compiler"]).group()}
