#!/usr/bin/env python3
"""What docs/choose.md shows: the recorded errors of tests/quality beside the recorded costs of tests/cost.

doc_tables.py offers the tables and the picture to tests/docs/documents.py, which writes and checks them. Run by itself,
it prints which of the figures that were hoped for are reached.
"""
import functools
import json
import math
import pathlib

import recorded

ROOT = pathlib.Path(__file__).resolve().parents[2]
COSTS = ROOT / "tests/cost/recorded.json"
TARGET = "GFX1100"
BUDGETS = recorded.BUDGETS
MEAN = recorded.MEAN


def map_of(technique, estimate, rows, width):
    """Units and bytes for each texel of the shadow map, or None twice: of the map that an estimate reads."""
    if estimate["map"] == "depths":
        return 0, 0
    half = " half" if technique["resolution"] < 1 else ""
    row = rows.get(f"map {estimate['map']} {width}{half}")
    if row is None:
        return None, None
    stored = technique["texel_bits"] / technique["resolution"] ** 2
    share = stored / row["bits"]
    return (row["inverse_throughput"] * (share if row["slice"] else 1),
            (row["read_bytes"] + row["written_bytes"]) * share)


@functools.cache
def cost_rows():
    return {row["name"]: row for row in json.loads(COSTS.read_text())["rows"] if row["target"] == TARGET}


def add_costs(techniques, width="7"):
    """What a technique costs is what its estimate in tests/cost/estimates.def does, with its taps and decisions."""
    rows = cost_rows()
    for technique in techniques:
        technique |= dict.fromkeys(("cost", "map_cost", "map_bytes"))
        estimate, taps = technique["estimate"], technique["taps"]
        if estimate == "":
            continue
        if estimate not in rows:
            raise SystemExit(f"{COSTS} has no estimate '{estimate}', which '{technique['name']}' is judged by")
        technique["map_cost"], technique["map_bytes"] = map_of(technique, rows[estimate], rows, width)
        row = rows.get(estimate + (f" {taps} taps" if taps > 1 else ""))
        if row is None:
            continue
        times = technique["decisions"] / row["decisions"]
        technique["instructions"] = round(times * row["instructions"])
        technique["registers"] = row["registers"]
        technique["cost"] = round(times * row["inverse_throughput"])


def dominated(technique, others, axes):
    """Whether another is no worse on any axis and better on one."""
    mine = [axis(technique) for axis in axes]
    for other in others:
        theirs = [axis(other) for axis in axes]
        if theirs != mine and all(b <= a for a, b in zip(mine, theirs)):
            return True
    return False


def error_of(technique):
    return technique["errors"][MEAN]


def bits_of(technique):
    return technique["bits"]


def cost_of(technique):
    return technique["cost"]


def mark_fronts(techniques):
    costed = [t for t in techniques if t["cost"] is not None]
    for technique in techniques:
        technique["fronts"] = []
        if not dominated(technique, techniques, [bits_of, error_of]):
            technique["fronts"].append("bits")
        if technique["cost"] is None:
            continue
        if not dominated(technique, costed, [cost_of, error_of]):
            technique["fronts"].append("cost")
        if not technique["fronts"] and not dominated(technique, costed, [bits_of, cost_of, error_of]):
            technique["fronts"].append("bits and cost")


@functools.cache
def techniques(run="7"):
    """All of them by bits and error, with what they cost and the fronts that they are on."""
    found = []
    for technique in recorded.techniques(run=run):
        errors = {column: round(recorded.rmse(technique["name"], column, run), 4) for column in recorded.COLUMNS}
        found.append({**technique, "errors": errors})
    found.sort(key=lambda t: (t["bits"], error_of(t), t["name"]))
    add_costs(found, run)
    mark_fronts(found)
    return found


def full_table():
    lines = [["technique", "whose", "bits", *recorded.COLUMNS, "units", "instr.", "registers", "map: units", "map: bytes", "front"]]
    for t in techniques():
        if (t["taps"], t["resolution"]) != (1, 1) and not t["fronts"]:
            continue
        cost = ["-" if t.get(key) is None else f"{t[key]:.0f}"
                for key in ("cost", "instructions", "registers", "map_cost", "map_bytes")]
        name = f"**{t['name']}**" if t["fronts"] else t["name"]
        lines.append([name, "peer" if t["peer"] else "ours", str(t["bits"]),
                      *(f"{t['errors'][column]:.4f}" for column in recorded.COLUMNS), *cost, ", ".join(t["fronts"])])
    return lines


def best(techniques):
    return min(techniques, key=lambda t: (error_of(t), cost_of(t) or 0, bits_of(t), t["name"]), default=None)


def shown(technique):
    return "-" if technique is None else f"{technique['name']}: {error_of(technique):.4f}"


def one_tap(technique):
    """Whether it is filtered and judged once."""
    return technique["filtered"] and technique["taps"] == 1


def bits_table():
    lines = [["bits at most", "ours, one tap", "a filtered peer, one tap", "ours, any taps", "a peer, any taps or PCF"]]
    for bits in BUDGETS:
        within = [t for t in techniques() if t["bits"] <= bits]
        ours, peers = ([t for t in within if t["peer"] == peer] for peer in (False, True))
        lines.append([str(bits), *(shown(best([t for t in found if any_ or one_tap(t)]))
                                   for any_ in (False, True) for found in (ours, peers))])
    return lines


def best_wide(cost):
    """The best of ours and the best peer at width 15 for no more cost."""
    within = [t for t in techniques("15") if t["cost"] is not None and t["cost"] <= cost]
    return [best([t for t in within if t["peer"] == whose]) for whose in (False, True)]


def wide_ratio(cost):
    ours, peer = best_wide(cost)
    return error_of(ours) / error_of(peer)


def best_one_sample(bits):
    """The best of ours that hardware filters and that is judged once, and the best such peer, in no more bits."""
    within = [t for t in techniques() if t["bits"] <= bits and one_tap(t)]
    return [best([t for t in within if t["peer"] == whose]) for whose in (False, True)]


def one_sample_ratio(bits):
    ours, peer = best_one_sample(bits)
    return error_of(ours) / error_of(peer)


def wide_table():
    """At some costs, bits included in none."""
    lines = [["cost at most", "ours", "a peer, PCF included", "ours over the peer"]]
    for cost in (64, 128, 256, 512, 1024, 2048):
        ours, peer = best_wide(cost)
        both = ours is not None and peer is not None
        lines.append([str(cost), shown(ours), shown(peer), f"{error_of(ours) / error_of(peer):.2f}" if both else "-"])
    return lines


PCF = "PCF, whole window"


def as_good_as_pcf(peer, run="15"):
    """Of ours or of PCF's own the cheapest that errs at most 1.1 times as much as PCF over the whole window."""
    limit = 1.1 * recorded.rmse(PCF, run=run)
    return min((t for t in techniques(run) if t["cost"] is not None and t["peer"] == peer and error_of(t) <= limit
                and (not peer or t["name"].startswith("PCF"))), key=lambda t: (cost_of(t), error_of(t)))


def wide_worst(cost):
    """The family of scenes where the best of ours at width 15 is worst against the best peer, of those where it errs."""
    ours, peer = best_wide(cost)
    ratios = {family: ours["errors"][family] / peer["errors"][family] for family in recorded.COLUMNS
              if peer["errors"][family] > 1e-3}
    return max(ratios.items(), key=lambda item: item[1])


def figures():
    """What was to be reached, and what is: name, limit, value, in words."""
    found = []
    for cost in (128, 256, 512):
        ours, peer = best_wide(cost)
        family, most = wide_worst(cost)
        found.append((f"width 15, {cost} units: error over the least of anything else", 0.8, wide_ratio(cost),
                      f"{ours['name']} / {peer['name']}"))
        found.append((f"the same in the worst family, {family}", 1, most, ""))
    for bits, limit in ((64, 0.9), (128, 0.85), (256, 0.65)):
        found.append((f"one filtered look-up a tap, {bits} bits: error over the best peer", limit, one_sample_ratio(bits),
                      "{} / {}".format(*(t["name"] for t in best_one_sample(bits)))))
    ours, pcf = as_good_as_pcf(False), as_good_as_pcf(True)
    whole = next(t for t in techniques("15") if t["name"] == PCF)
    for peer in (whole, pcf):
        found.append(("width 15, at most 1.1 times PCF's error: cost over PCF's", 0.4, cost_of(ours) / cost_of(peer),
                      f"{ours['name']} / {peer['name']}"))
    if recorded.TIMES.exists():
        for name, limit in (("default", 240), ("all widths", 600)):
            found.append((f"`lvsm_quality`, {name}: seconds on two cores", limit, recorded.times()["seconds"][name], ""))
    return found


def figures_table():
    lines = [["figure", "at most", "is", "reached", "ours / other"]]
    for name, limit, value, words in figures():
        text = str(value) if isinstance(value, int) else f"{value:.2f}"
        lines.append([name, str(limit), text, "yes" if value <= limit else "no", words])
    return lines


# One of each kind that somebody would take.
IN_TOTAL = ["VSM rg16", "EVSM4 rgba32f 42/10", "MSM4 unorm16", "MSM4 rgba32f", "trigonometric unorm16",
            "MSM4 quantised 32-bit", "LVSM-2 unorm8 bracketed, uniform", "LVSM-8 unorm8 bracketed, uniform",
            "LVSM-8 unorm8 plane, optimal", "MSM4 rgba32f, half", "LVSM-8 unorm8 plane, optimal, half", "PCF, 3 x 3",
            "PCF, whole window"]


def total_table():
    """For one and for four lit pixels to a texel, and from how many on PCF over the whole window takes more."""
    found = {t["name"]: t for t in techniques()}
    pcf = found["PCF, whole window"]["cost"]
    lines = [["technique", "error", "units a pixel", "units a texel", "bytes a texel", "P = T", "P = 4 T", "P / T"]]
    for t in (found[name] for name in IN_TOTAL):
        even = f"{t['map_cost'] / (pcf - t['cost']):.2f}" if t["map_cost"] and t["cost"] < pcf else "-"
        lines.append([t["name"], f"{error_of(t):.4f}", str(t["cost"]), f"{t['map_cost']:.0f}", f"{t['map_bytes']:.0f}",
                      f"{t['cost'] + t['map_cost']:.0f}", f"{4 * t['cost'] + t['map_cost']:.0f}", even])
    return lines


def cost_table():
    """A row for each cost at which some number of bits gets something better."""
    costed = [t for t in techniques() if t["cost"] is not None]
    lines = [["cost at most", *(f"{bits} bits" for bits in BUDGETS)]]
    previous = None
    for cost in sorted({t["cost"] for t in costed}):
        cells = [shown(best([t for t in costed if t["cost"] <= cost and t["bits"] <= bits])) for bits in BUDGETS]
        if cells != previous:
            lines.append([str(cost), *("same" if previous and cell == before else cell
                                       for cell, before in zip(cells, previous or cells))])
        previous = cells
    return lines


def form_error(name, run, column=MEAN):
    """That of a form over that of the whole estimate, in the worst scene where column is None."""
    base = name.split(":")[0].split(" ")[0]
    if column is not None:
        return recorded.rmse(name, column, run) / recorded.rmse(base, column, run)
    return max(recorded.rmse(name, scene, run) / max(recorded.rmse(base, scene, run), 1e-3)
               for scene in recorded.technique_scenes())


def forms_table():
    """What parts of the estimates from layers save when they are left out, and what is lost."""
    lines = [["form", "units", "error at width 7", "worst scene", "at width 15", "worst scene"]]
    for t in recorded.techniques(run="forms 7"):
        cells = [f"{form_error(t['name'], run, column):.3f}" for run in ("forms 7", "forms 15") for column in (MEAN, None)]
        lines.append([t["name"].replace(": ", " without: "), str(cost_rows()[t["name"]]["inverse_throughput"]), *cells])
    return lines


# Colours that stay apart for the colour-blind, and as far from white as from black; shapes tell the same.
STYLES = {32: ("#c05000", "circle"), 64: ("#0a80c0", "square"), 128: ("#0a9060", "triangle"),
          256: ("#b86aa0", "diamond")}
WIDTH, HEIGHT = 960, 620
LEFT, RIGHT, TOP, BOTTOM = 70, 940, 40, 560
COST_AXIS = (40.0, 2000.0)
ERROR_AXIS = (0.035, 0.36)


def place_x(cost):
    return LEFT + (RIGHT - LEFT) * math.log(cost / COST_AXIS[0]) / math.log(COST_AXIS[1] / COST_AXIS[0])


def place_y(error):
    return BOTTOM - (BOTTOM - TOP) * math.log(error / ERROR_AXIS[0]) / math.log(ERROR_AXIS[1] / ERROR_AXIS[0])


def mark(x, y, bits, peer):
    colour, shape = STYLES[bits]
    paint = f'stroke="{colour}" stroke-width="2" ' + ('class="hollow"' if peer else f'fill="{colour}"')
    if shape == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" {paint}/>\n'
    corners = {"square": [(-5, -5), (5, -5), (5, 5), (-5, 5)], "triangle": [(0, -6), (6, 5), (-6, 5)],
               "diamond": [(0, -7), (7, 0), (0, 7), (-7, 0)]}[shape]
    points = " ".join(f"{x + dx:.1f},{y + dy:.1f}" for dx, dy in corners)
    return f'<polygon points="{points}" {paint}/>\n'


def text(x, y, words, anchor="start", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{extra}>{words}</text>\n'


def axes():
    parts = ""
    for cost in (50, 75, 100, 150, 200, 300, 500, 800, 1200, 2000):
        x = place_x(cost)
        parts += f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{BOTTOM}"/>\n' + text(x, BOTTOM + 18, cost, "middle")
    for error in (0.04, 0.05, 0.06, 0.08, 0.1, 0.15, 0.2, 0.3):
        y = place_y(error)
        parts += f'<line x1="{LEFT}" x2="{RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>\n' + text(LEFT - 8, y + 4, error, "end")
    parts += text((LEFT + RIGHT) / 2, BOTTOM + 42, f"inverse throughput on {TARGET}, samples included", "middle")
    middle = (TOP + BOTTOM) / 2
    return parts + text(18, middle, "RMSE, mean of the mesh scenes", "middle", f' transform="rotate(-90 18 {middle})"')


def front_line(techniques, bits):
    front = [t for t in techniques if t["bits"] <= bits]
    front = sorted((t for t in front if not dominated(t, front, [cost_of, error_of])), key=cost_of)
    path = f"M{place_x(cost_of(front[0])):.1f},{place_y(error_of(front[0])):.1f}"
    for t in front[1:]:
        path += f" H{place_x(cost_of(t)):.1f} V{place_y(error_of(t)):.1f}"
    return f'<path d="{path} H{RIGHT}" fill="none" stroke="{STYLES[bits][0]}" stroke-width="1.5"/>\n'


def legend():
    parts = ""
    for i, bits in enumerate(BUDGETS):
        parts += mark(LEFT + 420 + 80 * i, 20, bits, False) + text(LEFT + 430 + 80 * i, 24, f"{bits} bits")
    parts += mark(LEFT + 420 + 80 * 4, 20, 64, True) + text(LEFT + 430 + 80 * 4, 24, "hollow: peer")
    return text(LEFT, 24, "Lines: least error at that cost with at most so many bits") + parts


def labels(techniques):
    """Names of those on a front, from the least error up, each at the first spot where it covers nothing."""
    parts = ""
    taken = [(place_x(cost_of(t)) - 7, place_y(error_of(t)) - 7, place_x(cost_of(t)) + 7, place_y(error_of(t)) + 7)
             for t in techniques]
    named = [t for t in techniques if t["fronts"]]
    for t in sorted(named, key=lambda t: (error_of(t), t["name"])):
        x, y = place_x(cost_of(t)), place_y(error_of(t))
        words = t["name"]
        width = 6.8 * len(words)
        spots = [(x - 10, y + 4, "end"), (x - 2, y + 19, "end"), (x - 2, y + 19, "start"), (x, y + 19, "middle"),
                 (x + 10, y - 9, "start"), (x + 10, y + 4, "start"), (x - 8, y - 9, "end")]
        for tx, ty, anchor in spots:
            begin = tx - {"start": 0, "middle": width / 2, "end": width}[anchor]
            box = (begin, ty - 10, begin + width, ty + 3)
            inside = box[0] > LEFT and box[2] < WIDTH and box[3] < BOTTOM
            if inside and not any(box[0] < b[2] and b[0] < box[2] and box[1] < b[3] and b[1] < box[3] for b in taken):
                taken.append(box)
                parts += text(tx, ty, words, anchor)
                break
    return parts


def picture():
    costed = [t for t in techniques() if t["cost"] is not None and t["cost"] <= COST_AXIS[1]]
    marks = "".join(mark(place_x(cost_of(t)), place_y(error_of(t)), t["bits"], t["peer"]) for t in costed)
    fronts = "".join(front_line(costed, bits) for bits in BUDGETS)
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}">
<title>Error against cost of every technique</title>
<style>
text {{ font: 12px sans-serif; fill: #222; stroke: #fff; stroke-width: 4px; paint-order: stroke; }}
line {{ stroke: #ddd; }}
.paper, .hollow {{ fill: #fff; }}
@media (prefers-color-scheme: dark) {{
  text {{ fill: #ddd; stroke: #111; }}
  line {{ stroke: #333; }}
  .paper, .hollow {{ fill: #111; }}
}}
</style>
<rect class="paper" width="{WIDTH}" height="{HEIGHT}"/>
{axes()}{fronts}{marks}{labels(costed)}{legend()}</svg>
"""


if __name__ == "__main__":
    print(*(" | ".join(line) for line in figures_table()), sep="\n")
