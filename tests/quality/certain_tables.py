"""What docs/quality.md says of who is certain by bounds on both sides: what `lvsm_quality --certain` measured."""
import recorded


def certainty(width, judge):
    """Means over the mesh scenes of what recorded.CERTAINTY names, with the cost and PCF's error's worst excess."""
    row = next(row for row in recorded.whole()["certain"] if (row["width"], row["judge"]) == (width, judge))
    scenes = [dict(zip(recorded.CERTAINTY, figures)) for figures in row["scenes"].values()]
    found = {key: recorded.mean(scene[key] for scene in scenes) for key in recorded.CERTAINTY}
    for key in ("groups", "groups_magnified", "uncertain"):
        found[f"cost by {key}"] = recorded.mean(scene["bound_cost"] + scene[key] * scene["pcf_cost"] for scene in scenes)
    return found | {"peer": row["peer"], "error": found["rmse"] / found["pcf_rmse"]}


def certain():
    lines = [["surely lit or dark by", "width", "error over PCF's", "receivers that are not", "groups of 8 x 8",
              "groups, magnified", "bound", "with PCF for the groups", "magnified", "PCF for all"]]
    for row in recorded.whole()["certain"]:
        c = certainty(row["width"], row["judge"])
        lines.append([row["judge"] + (" (peer)" if c["peer"] else ""), str(row["width"]), f"{c['error']:.2f}",
                      *(f"{c[key]:.2f}" for key in ("uncertain", "groups", "groups_magnified")),
                      *(f"{c[key]:.0f}" for key in ("bound_cost", "cost by groups", "cost by groups_magnified", "pcf_cost"))])
    return lines


TABLES = {"quality.certain": certain}
NAMES = {"certainty": certainty, "certain_judges": lambda: [row["judge"] for row in recorded.whole()["certain"]]}
