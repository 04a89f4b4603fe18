"""The recorded errors of the quick start and of the clients, as tests/docs/documents.py shows them."""
import json
import pathlib

import report

RECORDED = json.loads(pathlib.Path(__file__).with_name("recorded.json").read_text())


def error(name):
    """RMSE in grey levels."""
    return RECORDED["errors"][name]


def shown(name):
    value = error(name)
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def splits():
    places = {"0.30": "0.3", "0.40": "0.4", "0.50, uniform": "uniform", "optimalSplits": "optimalSplits", "0.60": "0.6",
              "lloydRelax": "lloydRelax"}
    lines = [["split", "`bracketedVisibility2`", "`layeredVisibility`"]]
    for label, name in places.items():
        where = f"{RECORDED['optimal' if name == 'optimalSplits' else 'lloyd']:.2f}, `{name}`" if name in (
            "optimalSplits", "lloydRelax") else label
        lines.append([where, shown(f"bracketed, split {name}"), shown(f"layered, split {name}")])
    return lines


def floors():
    lines = [["minVariance", "`bracketedVisibility2`", "`layeredVisibility`"]]
    for label, names in (("0", ["minVariance 0"] * 2), ("1e-6", ["minVariance 0.000001"] * 2),
                         ("1e-5", ["split optimalSplits", "split lloydRelax"]), ("1e-4", ["minVariance 0.0001"] * 2)):
        lines.append([label, *(shown(f"{kind}, {name}") for kind, name in zip(("bracketed", "layered"), names))])
    return lines


def others():
    """Each technique as it should be, then with one thing in another way."""
    bases = {"`bracketedVisibility2`, rgba16f": ("bracketed", "bracketed, split optimalSplits"),
             "`layeredVisibility`, rgba16f": ("layered", "layered, split lloydRelax"),
             "`exponentialVisibility4` 40/10, rgba32f": ("EVSM4 40/10 rgba32f", "EVSM4 40/10 rgba32f"),
             "`exponentialVisibility4` 5.5/5.5, rgba16f": ("EVSM4 5.5/5.5 rgba16f", "EVSM4 5.5/5.5 rgba16f"),
             "`chebyshevUpperBound`, rgba16f": ("VSM", "VSM")}
    lines = [["function, format", "as it should be", "reduced by 0.1", "back faces in the map"]]
    for label, (name, base) in bases.items():
        more = [f"{name}, {what}" for what in ("reduced by 0.1", "back faces")]
        lines.append([label, shown(base), *(shown(m) if m in RECORDED["errors"] else "" for m in more)])
    return lines


def clients():
    lines = [["client", "version", "what runs", "what its user does", "error", "allowed", "function"]]
    for name, row in json.loads(report.RECORDED.read_text()).items():
        what, todo = report.CLIENTS[name]
        lines.append([row["client"], row["version"], what, todo, f"{row['worst_error']:.1e}", f"{row['tolerance']:.1e}",
                      f"`{row['worst_function']}`"])
    return lines


TABLES = {"clients.clients": clients, "clients.splits": splits, "clients.floors": floors, "clients.others": others}
NAMES = {"quickStart": error, "split": lambda name: RECORDED[name]}
