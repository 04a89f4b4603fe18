#!/usr/bin/env python3
"""Fails where the table of docs/cost.md is not that of recorded.json; with --write, makes it so."""
import argparse
import json
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
DOCS = HERE.parents[1] / "docs/cost.md"
TABLE = re.compile(r"^\| estimate \|.*\n(?:\|.*\n)+", re.MULTILINE)


def table():
    names = re.findall(r"^ESTIMATE\(([^,]+),", (HERE / "estimates.def").read_text(), re.MULTILINE)
    rows = json.loads((HERE / "recorded.json").read_text())["rows"]
    figures = {(row["target"], row["name"]): f"{row['instructions']}, {row['inverse_throughput']}" for row in rows}
    targets = list(dict.fromkeys(row["target"] for row in rows))
    lines = [["estimate", *targets], ["---"] * (len(targets) + 1)]
    lines += [[name, *(figures[target, name] for target in targets)] for name in names]
    return "".join("|" + "|".join(cell if cell == "---" else f" {cell} " for cell in line) + "|\n" for line in lines)


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--write", action="store_true")
text = DOCS.read_text()
updated = TABLE.sub(table(), text)
if parser.parse_args().write:
    DOCS.write_text(updated)
elif updated != text:
    raise SystemExit(f"{DOCS} shows other figures than recorded.json; tests/cost/docs_table.py --write mends it")
