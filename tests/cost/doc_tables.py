"""The recorded costs, as tests/docs/documents.py shows them. cost/has_not_grown compares them with what is now."""
import json
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
RECORDED = json.loads((HERE / "recorded.json").read_text())
ROWS = {(row["target"], row["name"]): row for row in RECORDED["rows"]}
TARGETS = list(dict.fromkeys(row["target"] for row in RECORDED["rows"]))
FIRST = TARGETS[0]
WIDTHS = [3, 7, 15, 25]


def names(kind):
    return [name for target, name in ROWS if target == FIRST and ROWS[target, name]["kind"] == kind]


def three(target, name):
    return ", ".join(str(ROWS[target, name][key]) for key in ("inverse_throughput", "instructions", "registers"))


def by_wrapper(name):
    """Units with the wrappers' rule for borders; the same where no sampler filters."""
    return str(ROWS[FIRST, name]["wrapper_inverse_throughput"])


def estimates():
    """Units, instructions and registers of each whole estimate; of many taps units alone, in a table of their own."""
    single = [name for name in names("estimate") if not name.endswith(" taps")]
    return [["estimate", *TARGETS, f"by the wrapper, {FIRST}"],
            *([name, *(three(target, name) for target in TARGETS), by_wrapper(name)] for name in single)]


def taps():
    """Units of each estimate that is made several times."""
    found = [name.removesuffix(" 4 taps") for name in names("estimate") if name.endswith(" 4 taps")]
    return [["taps", "1", "4", "9", "16", "25"],
            *([name, *(str(cost(name + many)) for many in ("", " 4 taps", " 9 taps", " 16 taps", " 25 taps"))]
              for name in found)]


def passes():
    """Units and instructions of each pass, and its bytes: read, written. A blur is as dear in any format of as many
    components, and is shown in one."""
    shown = [name for name in names("pass") if not re.match(r"(blur|mip) .*(?<!rgba16)$", name)]
    return [["pass", *TARGETS, "bytes read", "bytes written"],
            *([name, *(three(target, name) for target in TARGETS), f"{ROWS[FIRST, name]['read_bytes']:g}",
               f"{ROWS[FIRST, name]['written_bytes']:g}"] for name in shown)]


def maps():
    """Units and bytes for each texel of the shadow map, at each width and at half resolution."""
    found = list(dict.fromkeys(ROWS[FIRST, name]["map"] for name in names("map")))
    def cells(name):
        rows = [ROWS[FIRST, f"map {name} {width}{half}"] for width in WIDTHS for half in ("", " half")]
        return [f"{row['inverse_throughput']:.0f}" for row in rows], rows
    lines = [["map", "bits", *(f"{width}{half}" for width in WIDTHS for half in ("", ", half")), "bytes", "bytes, half"]]
    for name in found:
        units, rows = cells(name)
        lines.append([name + (" (a slice)" if rows[0]["slice"] else ""), str(rows[0]["bits"]), *units,
                      *(f"{row['read_bytes'] + row['written_bytes']:g}" for row in rows[:2])])
    return lines


def cost(name, target=FIRST):
    """Inverse throughput of an estimate or pass; of a function without its loads."""
    return ROWS[target, name]["inverse_throughput"]


def instructions(name, target=FIRST):
    """Likewise."""
    return ROWS[target, name]["instructions"]


def map_cost(name, width, half=False):
    """Units for each texel of the shadow map."""
    return cost(f"map {name} {width}{' half' if half else ''}")


TABLES = {"cost.estimates": estimates, "cost.taps": taps, "cost.passes": passes, "cost.maps": maps}
NAMES = {"cost": cost, "instructions": instructions, "map_cost": map_cost,
         "mesa": re.search(r"[\d.]+", RECORDED["compiler"]).group()}
