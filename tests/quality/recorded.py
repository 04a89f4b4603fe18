#!/usr/bin/env python3
"""The recorded runs of lvsm_quality and lvsm_calm that the documents show, and the test that they are what is measured now.

    recorded.py --check LVSM_QUALITY LVSM_CALM     measures a small part and compares every error with the record
    recorded.py --record LVSM_QUALITY LVSM_CALM [FOLDER]    measures everything and writes recorded.json; what FOLDER
                                                            holds of it, as RUN NUMBER.json, is not measured anew
    recorded.py --time LVSM_QUALITY                how long it takes by default and with all widths, into time.json
    recorded.py --renew PARTS LVSM_QUALITY         measures only techniques whose names contain one of PARTS, and keeps
                                                   the others as they are; runs without any such technique too

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
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import recorded_run

FILE = pathlib.Path(__file__).with_name("recorded.json")
TIMES = FILE.with_name("time.json")
TIMED = {"default": [], "all widths": ["--width", "3,7,15,25"]}
MEAN = "mesh mean"
# One of flat layers, one of meshes, both short to measure.
PART = ["--scenes", "slanted,trees-grazing"]
OTHERS = ("calm", "small_calm", "certain")
SMALL_CALM = ["--size", "96", "--points", "300", "--frames", "4", "--cases", "1"]
CALM = ["--size", "160", "--points", "1000"]
COSTS = ["--costs", str(FILE.parents[1] / "cost/recorded.json")]
CERTAIN = ["--certain", "--width", "15,25", "--receivers", "3000", *COSTS]
SMALL_CERTAIN = ["--certain", "--width", "15", "--receivers", "3000", "--scenes", "bunnies-spot", "--techniques", "MSM4",
                 *COSTS]
# What is known of one another among many.
SOME = ",".join(["VSM rg16", "EVSM4 rgba32f 42/10", "EVSM4 rgba32f chosen", "MSM4 unorm16", "MSM4 rgba32f", "MSM4 quantised", "trigonometric",
                 "LVSM-8 unorm8 plane", "LVSM-16 unorm8 plane", "mixture K=2", "mixture K=4 128", "PCF", "limit: exact"])
TREE = "MSM4 rgba32f,MSM4 quantised,mixture K=2 64,mixture K=4 128,LVSM-16 unorm8 plane,PCF,limit: exact"
FEWER = ["--receivers", "4000"]
# Each run is what some calls measure together. At width 25 mixtures and power moments have variants.
RUNS = {
    "7": [[]],
    "15": [["--width", "15"]],
    "3": [["--width", "3", "--one-tap", *FEWER]],
    "25": [["--width", "25", "--one-tap", *FEWER, "--techniques",
            "VSM,ESM,CSM,PCF,MSM4 unorm,MSM4 x,trigono,limit: exact"],
           ["--width", "25", *FEWER, "--techniques", "mixture K=2,mixture K=4 128,MSM4 rgba32f,MSM4 quantised"]],
    **{f"footprint {length}{' x 1/8' if stretch > 1 else ''}":
       [["--footprint", f"{length},{stretch}", "--receivers", "2000", "--techniques", SOME]]
       for stretch in (1, 8) for length in (4, 16)},
    **{f"forms {width}": [["--forms", "--width", width, "--receivers", "3000"]] for width in ("7", "15")},
    "tree 7": [["--tree", *FEWER, "--techniques", TREE]],
    "tree 15": [["--tree", "--width", "15", *FEWER, "--techniques", TREE]],
}
BUDGETS = [32, 64, 128, 256]
# The arithmetic is the same everywhere but for the last digits of exp, log and the like.
TOLERANCE = 1.0e-5


def measure(program, *options, only=None):
    if only is not None:
        at = options.index("--techniques") if "--techniques" in options else len(options)
        options = [*options[:at], *options[at + 2:], "--techniques", only]
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


def summary(name, rows, whole):
    """What is kept of a technique: its error in each scene, and over the mesh scenes means and, if whole, pooled groups."""
    mesh = [row for row in rows if row["mesh"]]
    kept = {**kind(name, rows), "rmse": {row["scene"]: digits(row["rmse"]) for row in rows},
            "chosen": digits(mean(row["chosen_rmse"] for row in mesh))}
    if whole:
        kept |= {key: digits(mean(row[key] for row in mesh)) for key in ("bleed", "dark", "p99", "calm")}
        kept["unweighted"] = digits(mean(row["unweighted"]["rmse"] for row in mesh))
        kept["groups"] = {group: pooled(mesh, group) for group in mesh[0]["groups"]}
    return kept


def digest(lines):
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


def record(quality, calm, keep=None):
    def measured(name, program, *options):
        kept = keep and pathlib.Path(keep) / f"{name.replace('/', '_')}.json"
        return json.loads(kept.read_text()) if kept and kept.exists() else measure(program, *options)

    runs = {}
    for run, calls in RUNS.items():
        rows = [row for i, call in enumerate(calls) for row in measured(f"{run} {i}", quality, *call)]
        runs[run] = [json.dumps(summary(name, found, run == "7")) for name, found in by_technique(rows).items()]
    rows = measured("7 0", quality)
    mesh = list(dict.fromkeys(row["scene"] for row in rows if row["mesh"]))
    flicker = {"calm": [json.dumps(row) for row in measured("calm", calm, *CALM)],
               "small_calm": [json.dumps(row) for row in measured("small calm", calm, *SMALL_CALM)],
               "certain": certain(measured("certain", quality, *CERTAIN))}
    write(rows[0]["seed"], mesh, runs, flicker)


CERTAINTY = ["rmse", "pcf_rmse", "uncertain", "groups", "groups_magnified", "bound_cost", "pcf_cost"]


def certain(rows):
    """A line for each width and judge: its scenes, each with what CERTAINTY names."""
    found = {}
    for row in rows:
        kept = found.setdefault((row["width"], row["judge"]), {"peer": row["peer"], "scenes": {}})
        kept["scenes"][row["scene"]] = [digits(row[key]) for key in CERTAINTY]
    return [json.dumps({"width": width, "judge": judge, **kept}) for (width, judge), kept in found.items()]


def write(seed, mesh, runs, others):
    """runs, others: lines by name."""
    lines = [line for run in (*runs.values(), *others.values()) for line in run]
    listed = [f'{json.dumps(name)}: [\n' + ",\n".join(run) + "\n]" for name, run in runs.items()]
    FILE.write_text('{"seed": %d, "digest": "%s",\n"mesh_scenes": %s,\n"runs": {\n%s\n},\n%s}\n' % (
        seed, digest(lines), json.dumps(mesh), ",\n".join(listed),
        ",\n".join(f'"{name}": [\n' + ",\n".join(found) + "\n]" for name, found in others.items())))


def renew(parts, quality):
    """Measures some techniques anew, in the runs that have them; new ones come last."""
    kept = whole()
    runs = {name: {t["name"]: json.dumps(t) for t in run} for name, run in kept["runs"].items()}
    for run in runs:
        runs[run] = {name: line for name, line in runs[run].items() if not any(part in name for part in parts.split(","))}
    for run, calls in RUNS.items():
        for call in calls:
            if "--forms" in call:
                continue
            wanted = call[call.index("--techniques") + 1].split(",") if "--techniques" in call else [""]
            if run != "7" and not any(part in name and one in name for name in runs["7"]
                                     for part in parts.split(",") for one in wanted):
                continue
            rows = [row for row in measure(quality, *call, only=parts) if any(part in row["technique"] for part in wanted)]
            for name, found in by_technique(rows).items():
                runs[run][name] = json.dumps(summary(name, found, run == "7"))
    write(kept["seed"], kept["mesh_scenes"], {name: list(run.values()) for name, run in runs.items()},
          {name: [json.dumps(row) for row in kept[name]] for name in OTHERS})


def time_runs(quality):
    """Seconds of the runs that a user makes. It should be the only one on its machine: the load before says whether."""
    found = {"processor": recorded_run.processor(), "load": recorded_run.load(), "seconds": {}}
    for name, options in TIMED.items():
        start = time.monotonic()
        measure(quality, *options)
        found["seconds"][name] = round(time.monotonic() - start)
    TIMES.write_text(json.dumps(found, indent=1) + "\n")
    print(found)


def times():
    return json.loads(TIMES.read_text())


def check(quality, calm):
    """Yields what differs from the record."""
    kept = [*whole()["runs"].values(), *(whole()[name] for name in OTHERS)]
    if digest([json.dumps(t) for part in kept for t in part]) != whole()["digest"]:
        yield f"{FILE.name} has been changed by hand"
    now = by_technique(measure(quality, *PART))
    for name in sorted(set(now) ^ {t["name"] for t in whole()["runs"]["7"]}):
        yield f"{name} is {'not recorded' if name in now else 'recorded, but there is no such technique'}"
    yield from differences("7", now)
    run = "footprint 16 x 1/8"
    yield from differences(run, by_technique(measure(quality, *RUNS[run][0], "--scenes", "slanted")))
    yield from differences("forms 7", by_technique(measure(quality, *RUNS["forms 7"][0], "--scenes", "slanted")))
    for now in map(json.loads, certain(measure(quality, *SMALL_CERTAIN))):
        was = next(row for row in whole()["certain"] if (row["width"], row["judge"]) == (now["width"], now["judge"]))
        for scene, figures in now["scenes"].items():
            if any(abs(a - b) > TOLERANCE for a, b in zip(figures, was["scenes"][scene])):
                yield f"certain by {now['judge']}, {scene}: {figures}, recorded {was['scenes'][scene]}"
    for was, is_ in zip(whole()["small_calm"], measure(calm, *SMALL_CALM)):
        if was.keys() != is_.keys() or any(
                abs(is_[key] - was[key]) > TOLERANCE if isinstance(was[key], float) else is_[key] != was[key]
                for key in was):
            yield f"{was} is recorded, {is_} now"


def differences(run, now):
    for t in whole()["runs"][run]:
        for row in now.get(t["name"], []):
            was, is_ = t["rmse"].get(row["scene"]), digits(row["rmse"])
            if was is None or abs(was - is_) > TOLERANCE:
                yield f"{run}: {t['name']}, {row['scene']}: {is_}, recorded {was}"


@functools.cache
def whole():
    return json.loads(FILE.read_text())


def techniques(limits=False, run="7"):
    """Those that are stored in some bits, or the limits, in one of RUNS."""
    return [t for t in whole()["runs"][run] if (t["bits"] == 0) == limits]


def technique(name, run="7"):
    return next(t for t in whole()["runs"][run] if t["name"] == name)


def scenes_of(column):
    """The scenes that a column is the mean of: one, the lights of a world, or all of meshes."""
    return [scene for scene in technique_scenes() if column == MEAN and scene in whole()["mesh_scenes"]
            or column in (scene, scene.split("-")[0])]


def technique_scenes():
    return list(whole()["runs"]["7"][0]["rmse"])


COLUMNS = [*dict.fromkeys(scene.split("-")[0] for scene in technique_scenes()), MEAN] if FILE.exists() else []


def rmse(name, column=MEAN, run="7"):
    return mean(technique(name, run)["rmse"][scene] for scene in scenes_of(column))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--renew"]:
        sys.exit(renew(*sys.argv[2:]))
    if sys.argv[1:2] == ["--time"]:
        sys.exit(time_runs(*sys.argv[2:]))
    recorded_run.main(__doc__, check, record, "If they are meant: tests/quality/recorded.py --record LVSM_QUALITY LVSM_CALM; "
                      "tests/docs/documents.py --write")
