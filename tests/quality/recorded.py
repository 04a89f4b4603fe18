#!/usr/bin/env python3
"""The recorded run of lvsm_quality that the documents show, and the test that it is what would be measured now.

    recorded.py --check LVSM_QUALITY     measures two of the scenes and compares every technique's error with the record
    recorded.py --record LVSM_QUALITY    measures everything and writes recorded.json

The record carries a digest of itself, so that no figure of the scenes that are not measured each time is changed by hand.
"""
import functools
import hashlib
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import recorded_run

FILE = pathlib.Path(__file__).with_name("recorded.json")
MEAN = "mesh mean"
# One of flat layers, one of meshes, both short to measure.
PART = ["--scenes", "slanted,trees-grazing"]
BUDGETS = [32, 64, 128, 256]
# The arithmetic is the same everywhere but for the last digits of exp, log and the like.
TOLERANCE = 1.0e-5


def measure(program, *options):
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "quality.json"
        subprocess.run([program, "--output", str(output), *options], check=True, stdout=subprocess.DEVNULL)
        return json.loads(output.read_text())


def by_technique(rows):
    found = {}
    for row in rows:
        found.setdefault(row["technique"], []).append(row)
    return found


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def pooled(rows, group):
    """Weight and RMSE of all receivers of a group together."""
    parts = [row["groups"][group] for row in rows]
    weight = sum(part["weight"] for part in parts)
    square = sum(part["weight"] * part["rmse"] ** 2 for part in parts)
    return [round(weight), digits(math.sqrt(square / weight)) if weight else 0.0]


def digits(value):
    return round(value, 6)


def budget(row):
    """The least of BUDGETS that a texel of the shadow map fits in; 0 for a limit."""
    return 0 if row["bits"] == 0 else min(bits for bits in BUDGETS if row["texel_bits"] <= bits)


def kind(name, rows):
    """What a technique is: `bits` is the budget that it fits in."""
    return {"name": name, "bits": budget(rows[0]),
            **{key: rows[0][key] for key in ("peer", "taps", "resolution", "texel_bits", "filtered", "estimate",
                                             "decisions")}}


def summary(name, rows):
    """What is kept of a technique: its error in each scene, and over the mesh scenes means and pooled groups."""
    mesh = [row for row in rows if row["mesh"]]
    return {**kind(name, rows),
            **{key: digits(mean(row[key] for row in mesh)) for key in ("bleed", "dark", "p99", "calm")},
            "unweighted": digits(mean(row["unweighted"]["rmse"] for row in mesh)),
            "groups": {group: pooled(mesh, group) for group in mesh[0]["groups"]},
            "rmse": {row["scene"]: digits(row["rmse"]) for row in rows}}


def digest(lines):
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


def write(rows, wide_rows):
    lines = [json.dumps(summary(name, found)) for name, found in by_technique(rows).items()]
    wide = [json.dumps({**kind(name, found), "rmse": {row["scene"]: digits(row["rmse"]) for row in found}})
            for name, found in by_technique(wide_rows).items()]
    mesh = list(dict.fromkeys(row["scene"] for row in rows if row["mesh"]))
    FILE.write_text('{"seed": %d, "width": %d, "wide": %d, "digest": "%s",\n"mesh_scenes": %s,\n'
                    '"techniques": [\n%s\n],\n"wide_techniques": [\n%s\n]}\n' % (
                        rows[0]["seed"], rows[0]["width"], wide_rows[0]["width"], digest(lines + wide),
                        json.dumps(mesh), ",\n".join(lines), ",\n".join(wide)))


def record(program):
    write(measure(program), measure(program, "--width", "15"))


def check(program):
    """Yields what differs from the record."""
    if digest([json.dumps(t) for t in whole()["techniques"] + whole()["wide_techniques"]]) != whole()["digest"]:
        yield f"{FILE.name} has been changed by hand"
    now = by_technique(measure(program, *PART))
    for name in sorted(set(now) ^ {t["name"] for t in whole()["techniques"]}):
        yield f"{name} is {'not recorded' if name in now else 'recorded, but there is no such technique'}"
    for t in whole()["techniques"]:
        for row in now.get(t["name"], []):
            was, is_ = t["rmse"].get(row["scene"]), digits(row["rmse"])
            if was is None or abs(was - is_) > TOLERANCE:
                yield f"{t['name']}, {row['scene']}: {is_}, recorded {was}"


@functools.cache
def whole():
    return json.loads(FILE.read_text())


def techniques(limits=False, wide=False):
    """Those that are stored in some bits, or the limits; for the ordinary filter, or for the wide one."""
    return [t for t in whole()["wide_techniques" if wide else "techniques"] if (t["bits"] == 0) == limits]


def technique(name, wide=False):
    return next(t for t in whole()["wide_techniques" if wide else "techniques"] if t["name"] == name)


def scenes_of(column):
    """The scenes that a column is the mean of: one, the lights of a world, or all of meshes."""
    return [scene for scene in technique_scenes() if column == MEAN and scene in whole()["mesh_scenes"]
            or column in (scene, scene.split("-")[0])]


def technique_scenes():
    return list(whole()["techniques"][0]["rmse"])


COLUMNS = [*dict.fromkeys(scene.split("-")[0] for scene in technique_scenes()), MEAN] if FILE.exists() else []


def rmse(name, column=MEAN, wide=False):
    return mean(technique(name, wide)["rmse"][scene] for scene in scenes_of(column))


if __name__ == "__main__":
    recorded_run.main(__doc__, check, record, "If they are meant: tests/quality/recorded.py --record LVSM_QUALITY; "
                      "tests/docs/documents.py --write")
