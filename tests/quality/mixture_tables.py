"""What the documents show of mixtures beside the best that is published, of minified receivers and of calm."""
import choose
import recorded
from recorded import COLUMNS, MEAN, rmse

LIMIT = "limit: exact, receiver's plane"
FAMILIES = COLUMNS[:-1]
# What a mixture of so many bits a texel of the shadow map is called.
MIXTURES = {16: "mixture K=2 64-bit, half", 32: "mixture K=4 128-bit, half", 64: "mixture K=2 64-bit",
            128: "mixture K=4 128-bit"}
DECODED = ", four decodes"
WINDOWS = ("7", "15", "25", "tree 7", "tree 15")
GOALS = {32: 0.75, 64: 0.65, 128: 0.6}
BESIDE = ["MSM4 quantised 32-bit", "MSM4 quantised 64-bit", "MSM4 rgba32f", "MSM4 rgba32f, half",
          "MSM4 quantised 64-bit, half", "LVSM-16 unorm8 plane, optimal"]


def stored(t):
    """Whether it is made before it is looked up, once: not PCF and no taps."""
    return not t["name"].startswith("PCF") and t["taps"] == 1


def best_published(bits, run):
    """The best of what is published, stored, in no more bits, by the mesh mean."""
    peers = [t["name"] for t in recorded.techniques(run=run) if t["peer"] and stored(t) and t["texel_bits"] <= bits]
    return min(peers, key=lambda name: rmse(name, MEAN, run))


def best_mixture(bits, run, read=""):
    """The best in no more bits, by one fetch, or with read = DECODED by four decisions."""
    return min((name + read for size, name in MIXTURES.items() if size <= bits), key=lambda name: rmse(name, MEAN, run))


def over_published(bits, run="7", column=MEAN, read=""):
    return rmse(best_mixture(bits, run, read), column, run) / rmse(best_published(bits, run), column, run)


def worst_family(bits, run="7", read=""):
    """The family of scenes where a mixture is worst against the best published, of those where that errs at all."""
    families = [f for f in FAMILIES if rmse(best_published(bits, run), f, run) > 1e-3]
    worst = max(families, key=lambda f: over_published(bits, run, f, read))
    return worst, over_published(bits, run, worst, read)


def goals():
    lines = [["bits", "window", "best published", "mixture, one fetch", "ratio", "worst family", "four decodes", "ratio",
              "worst family", "to reach"]]
    for bits, goal in GOALS.items():
        for run in WINDOWS:
            peer = best_published(bits, run)
            cells = []
            for read in ("", DECODED):
                ours = best_mixture(bits, run, read)
                worst, ratio = worst_family(bits, run, read)
                cells += [f"{ours.removesuffix(read).removeprefix('mixture ')}: {rmse(ours, MEAN, run):.4f}",
                          f"{over_published(bits, run, MEAN, read):.2f}", f"{worst} {ratio:.2f}"]
            lines.append([str(bits), run, f"{peer}: {rmse(peer, MEAN, run):.4f}", *cells, f"{goal:.2f}"])
    return lines


def errors(run):
    def table():
        known = {t["name"]: t for t in recorded.techniques(run=run)}
        names = [name for half in MIXTURES.values() for name in (half, half + DECODED)]
        rows = [name for name in [*names, *BESIDE, "PCF, whole window", "limit: mixture K=4, not coded", LIMIT]
                if name in known or name.startswith("limit") and any(t["name"] == name for t in recorded.techniques(True, run))]
        lines = [["", "bits a texel", *COLUMNS, "mesh mean, setting chosen"]]
        for name in rows:
            t = recorded.technique(name, run)
            bold = f"**{name}**" if name.startswith("mixture") else name
            lines.append([bold, f"{t['texel_bits']:g}" if t["bits"] else "-",
                          *(f"{rmse(name, column, run):.4f}" for column in COLUMNS), f"{t['chosen']:.4f}"])
        return lines
    return table


FOOTPRINTS = ["footprint 4", "footprint 16", "footprint 4 x 1/8", "footprint 16 x 1/8"]


def minified():
    lines = [["mesh mean", "bits", *(cell for run in FOOTPRINTS for cell in (run.removeprefix("footprint "), "cost"))]]
    rows = [t for limits in (False, True) for t in recorded.techniques(limits, FOOTPRINTS[0])]
    for row in sorted(rows, key=lambda t: sum(rmse(t["name"], MEAN, run) for run in FOOTPRINTS)):
        cells = []
        for run in FOOTPRINTS:
            t = dict(recorded.technique(row["name"], run))
            choose.add_costs([t])
            cells += [f"{rmse(row['name'], MEAN, run):.4f}", "-" if t["cost"] is None else f"{t['cost']:.0f}"]
        lines.append([row["name"] + (" (peer)" if row["peer"] else ""),
                      f"{row['texel_bits']:g}" if row["bits"] else "-", *cells])
    return lines


def flicker(technique, scene, motion, what="deviation"):
    return next(row[what] for row in recorded.whole()["calm"]
                if (row["technique"], row["scene"], row["motion"]) == (technique, scene, motion))


SCENES = list(dict.fromkeys(row["scene"] for row in recorded.whole()["calm"])) if recorded.FILE.exists() else []
MOTIONS = {"grid moves": "grid", "light turns": "light"}


def calm():
    lines = [["deviation over the frames, and RMSE", *(f"{scene}, {short}" for scene in SCENES for short in MOTIONS.values())]]
    for name in dict.fromkeys(row["technique"] for row in recorded.whole()["calm"]):
        cells = [f"{flicker(name, scene, motion):.4f}, {flicker(name, scene, motion, 'rmse'):.4f}"
                 for scene in SCENES for motion in MOTIONS]
        if name == "the light itself":
            cells = [cell.split(",")[0] for cell in cells]
        lines.append([name, *cells])
    return lines


def flicker_ratios(ours, peer):
    """Deviations over the frames of ours over those of a peer's, in each scene and motion."""
    return [flicker(ours, scene, motion) / flicker(peer, scene, motion) for scene in SCENES for motion in MOTIONS]


def calm_of(name):
    """RMSE of the difference of the errors of neighbours on one surface."""
    return recorded.technique(name)["calm"]


TABLES = {"mixtures.goals": goals, "mixtures.width7": errors("7"), "mixtures.width15": errors("15"),
          "mixtures.width25": errors("25"), "mixtures.tree7": errors("tree 7"), "mixtures.tree15": errors("tree 15"),
          "quality.minified": minified, "quality.calm": calm}
NAMES = {"over_published": over_published, "DECODED": DECODED, "WINDOWS": WINDOWS, "worst_family": worst_family, "flicker_ratios": flicker_ratios,
         "calm_of": calm_of, "chosen": lambda name, run="7": recorded.technique(name, run)["chosen"]}
