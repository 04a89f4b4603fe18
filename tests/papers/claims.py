"""What the papers say, item by item, beside what was measured here; the rows of docs/papers.md and papers.json.

A claim's `ours` is a text with figures in it, and `holds` an expression: both over what lvsm_papers and lvsm_papers_time
measured, by item: figure4.lit, or lit alone where the claim names that item as its `of`. Whether ours agree is the value
of that expression. One without an expression could not be reproduced, and says why.
"""
import importlib
import pathlib
import sys
import types
from dataclasses import dataclass

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

PAPERS = ("lvsm", "esm", "evsm", "vsm")


@dataclass(frozen=True)
class Claim:
    item: str
    claim: str
    theirs: str
    ours: str
    holds: str
    of: str = ""
    why: str = ""


def papers():
    """Each paper's module: NAME, ITEMS, which must all have claims, and CLAIMS."""
    return [importlib.import_module(f"claims_{name}") for name in PAPERS]


def spaces(values):
    return {item: types.SimpleNamespace(**figures) for item, figures in values.items()}


def row(paper, claim, values):
    names = {"max": max, "min": min, "abs": abs, "int": int, **spaces(values), **values.get(claim.of, {})}
    agrees = bool(eval(claim.holds, {"__builtins__": {}, **names})) if claim.holds else None
    return {"paper": paper.NAME, "item": claim.item, "claim": claim.claim, "theirs": claim.theirs,
            "ours": claim.ours.format(**names), "criterion": claim.holds, "agrees": agrees, "why": claim.why.format(**names)}


def rows(values):
    return [row(paper, claim, values) for paper in papers() for claim in paper.CLAIMS]


def faults(all_rows):
    """Yields what a reader would miss: an item without a row, and a row that does not agree or explain itself."""
    for paper in papers():
        for item in paper.ITEMS:
            if not any(r["paper"] == paper.NAME and r["item"] == item for r in all_rows):
                yield f"{paper.NAME}, {item}: there is no row"
    for r in all_rows:
        if not r["agrees"] and not r["why"]:
            yield f"{r['paper']}, {r['item']}: does not agree, and does not say why"
