"""The recorded errors, as tests/docs/documents.py shows them; quality/recorded compares them with what is now."""
import choose
import recorded
from recorded import COLUMNS, MEAN, rmse


def line(name, shown=None):
    return [shown or name, *(f"{rmse(name, column):.4f}" for column in COLUMNS)]


def ratio_line(what, ours, peer):
    return [f"**{what}: {ours} / {peer}**", *(f"{ratio(ours, peer, column):.2f}" for column in COLUMNS)]


def best(techniques, peer, taps):
    found = [t["name"] for t in techniques if t["peer"] == peer and t["taps"] <= taps]
    return min(found, key=rmse, default=None)


def results(bits):
    """Those of so many bits by error; then the best of ours over the best peer at no more bits, one tap and any."""
    def table():
        here = [t for t in recorded.techniques() if t["bits"] == bits]
        lines = [[f"{bits} bits", *COLUMNS]]
        for t in sorted(here, key=lambda t: rmse(t["name"])):
            lines.append(line(t["name"], t["name"] + (" (peer)" if t["peer"] else "")))
        within = [t for t in recorded.techniques() if t["bits"] <= bits]
        pairs = [(best(here, False, taps), best(within, True, taps)) for taps in (1, 1000)]
        if all(pairs[0]):
            lines.append(ratio_line("one tap", *pairs[0]))
        if all(pairs[1]) and pairs[1] != pairs[0]:
            lines.append(ratio_line("any taps", *pairs[1]))
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


def ratio(ours, peer, column=MEAN):
    return rmse(ours, column) / max(rmse(peer, column), 1.0e-9)


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
          "choose.bits": choose.bits_table, "choose.cost": choose.cost_table, "choose.all": choose.full_table}
NAMES = {"rmse": rmse, "ratio": ratio, "ratios": ratios, "share_of": share_of, "peers_of": peers_of,
         "columns": COLUMNS, "seed": recorded.whole()["seed"]}
FILES = {"docs/choose.svg": choose.picture}
