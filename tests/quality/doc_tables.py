"""The recorded errors, as tests/docs/documents.py shows them; quality/recorded compares them with what is now."""
import certain_tables
import choose
import mixture_tables
import recorded
from recorded import COLUMNS, MEAN, rmse


def line(name, shown=None):
    return [shown or name, *(f"{rmse(name, column):.4f}" for column in COLUMNS)]


LIMIT = "limit: exact, receiver's plane"
# A peer that errs less is as good as exact: it wins, but no ratio to it means anything.
EXACT = 1e-3


def best(techniques):
    return min((t["name"] for t in techniques), key=rmse, default=None)


def against(what, ours, peer):
    """The best of ours over the best peer, in how many scenes it wins, and the share of the gap to the limit closed."""
    scenes = {scene: ratio(ours, peer, scene) for scene in recorded.technique_scenes()}
    worst = max((scene for scene in scenes if rmse(peer, scene) > EXACT), key=scenes.get)
    won = sum(value < 1 for value in scenes.values())
    gaps = {column: rmse(peer, column) - rmse(LIMIT, column) for column in COLUMNS}
    closed = [f"{(rmse(peer, column) - rmse(ours, column)) / gap:.2f}" if gap > EXACT else "-"
              for column, gap in gaps.items()]
    return [[f"**{what}: {ours} / {peer}**; wins {won} of {len(scenes)}, worst {worst} {scenes[worst]:.2f}",
             *(f"{ratio(ours, peer, column):.2f}" if rmse(peer, column) > EXACT else "-" for column in COLUMNS)],
            ["of the gap to the limit it closes", *closed]]


def results(bits):
    """Those of so many bits with one tap, and the three best of the other variants; then ours against the peers."""
    def table():
        here = sorted((t for t in recorded.techniques() if t["bits"] == bits), key=lambda t: rmse(t["name"]))
        others = [t for t in here if (t["taps"], t["resolution"]) != (1, 1)]
        lines = [[f"{bits} bits", *COLUMNS]]
        for t in here:
            if t not in others or t in others[:3] or t in [o for o in others if not o["peer"]][:3]:
                lines.append(line(t["name"], t["name"] + (" (peer)" if t["peer"] else "")))
        within = [t for t in recorded.techniques() if t["bits"] <= bits]
        for what, wanted in (("one tap", choose.one_tap), ("stored, no taps", mixture_tables.stored), ("anything", lambda t: True)):
            ours = best([t for t in here if not t["peer"] and wanted(t)])
            peer = best([t for t in within if t["peer"] and wanted(t)])
            if ours and peer:
                lines += against(what, ours, peer)
        return lines

    return table


def limits():
    return [["limits", *COLUMNS], *(line(t["name"]) for t in sorted(recorded.techniques(True), key=lambda t: rmse(t["name"])))]


GROUPS = {"lit": "lit", "penumbra": "penumbra", "shadow": "shadow", "near": "occluder < .02", "middle": ".02 to .15",
          "far": "farther"}
IN_GROUPS = ["VSM rg16", "MSM4 rgba32f", "LVSM-8 unorm8 plane, optimal", "LVSM-16 unorm8 plane, optimal",
             "limit: exact distribution", "limit: exact, receiver's plane"]


def groups():
    lines = [["on the mesh scenes", "bleed", "dark", "99%", "rmse without n.l", *GROUPS.values()]]
    for name in IN_GROUPS:
        t = recorded.technique(name)
        cells = [f"{t['bleed']:.4f}", f"{t['dark']:.4f}", f"{t['p99']:.3f}", f"{t['unweighted']:.3f}",
                 *(f"{t['groups'][group][1]:.3f}" for group in GROUPS)]
        lines.append([name, *(cell.removeprefix("0") for cell in cells)])
    return lines


def ratio(ours, peer, column=MEAN, run="7"):
    return rmse(ours, column, run) / max(rmse(peer, column, run), 1.0e-9)


def ratios(ours, peer):
    """In each mesh scene."""
    return [ratio(ours, peer, scene) for scene in recorded.whole()["mesh_scenes"]]


def share_of(name, *kinds):
    """Of the squared error of receivers of all kinds of light, that of these."""
    squares = {kind: weight * error**2 for kind, (weight, error) in recorded.technique(name)["groups"].items()}
    return sum(squares[kind] for kind in kinds) / (squares["lit"] + squares["penumbra"] + squares["shadow"])


def peers_of(bits):
    return {t["name"] for t in recorded.techniques() if t["peer"] and t["bits"] == bits}


TABLES = {"quality.limits": limits, "quality.groups": groups,
          **{f"quality.bits{bits}": results(bits) for bits in choose.BUDGETS},
          **mixture_tables.TABLES, **certain_tables.TABLES, "choose.bits": choose.bits_table,
          "choose.wide": choose.wide_table, "choose.figures": choose.figures_table, "choose.cost": choose.cost_table,
          "choose.total": choose.total_table, "choose.forms": choose.forms_table, "choose.all": choose.full_table}
NAMES = {"rmse": rmse, "ratio": ratio, "ratios": ratios, "share_of": share_of, "peers_of": peers_of,
         "columns": COLUMNS, "seed": recorded.whole()["seed"], "wide_ratio": choose.wide_ratio,
         "one_sample_ratio": choose.one_sample_ratio, "form_error": choose.form_error,
         "PCF_AS_GOOD": lambda: choose.as_good_as_pcf(True), "TIMES": recorded.times,
         **mixture_tables.NAMES, **certain_tables.NAMES}
FILES = {"docs/choose.svg": choose.picture}
