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


def derived(times):
    """The ratios of one item's times: X is X_map and X_shade together."""
    t = {**times, **{name.removesuffix("_map"): times[name] + times[name.removesuffix("_map") + "_shade"]
                     for name in times if name.endswith("_map")}}
    over = {f"{name}_over": t[name] / t[base] for base in ("evsm4", "vsm") if base in t for name in t}
    for n in (2, 4, 8, 14):
        if f"lvsm{n}" in t and "vsm" in t:
            over.update({f"ratio{n}": t[f"lvsm{n}"] / t["vsm"], f"shade_ratio{n}": t[f"lvsm{n}_shade"] / t["vsm_shade"]})
        if f"csm{2 * n}" in t:
            over.update({f"csm_over{n}": t[f"csm{2 * n}"] / t[f"lvsm{n}"],
                         f"csm_shade_over{n}": t[f"csm{2 * n}_shade"] / t[f"lvsm{n}_shade"]})
    if "lvsm14" in t:
        over.update({"growth14": t["lvsm14"] / t["lvsm2"], "shade_growth14": t["lvsm14_shade"] / t["lvsm2_shade"]})
    if "z_max" in t:
        over["z_over"] = t["z_max"] / t["threshold"]
    if "evsm_full" in t:
        over.update({"evsm_9_of": t["evsm_9"] / t["vsm_9"], "evsm_full_of": t["evsm_full"] / t["pcf9_gauss"]})
    if "one_pass5" in t:
        five, seven, nine, linear = (t[f"{name}_map"] - t["none_map"] for name in ("five", "seven", "nine", "nine_linear"))
        fetch = (nine - five) / 8
        over.update({"blur_one": t["one_pass5"] / t["one_pass3"], "blur_separable": five / t["one_pass5"],
                     "blur7": seven / five, "blur9": nine / five, "blur_linear": linear / five, "blur_fetch": fetch,
                     "blur_pass": five / 2 - 5 * fetch})
    return {**t, **over}


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
