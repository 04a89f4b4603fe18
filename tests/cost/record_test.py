#!/usr/bin/env python3
"""That lvsm_cost --record drops no figure that it has not measured anew:  record_test.py LVSM_COST GLSL_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile

TARGET = "NAVI21"


def record(path):
    done = subprocess.run([sys.argv[1], "--glsl", sys.argv[2], "--targets", TARGET, "--recorded", str(path), "--record"],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode == 77:
        print(done.stdout)
        sys.exit(77)
    return done


def row(target, name):
    return {"target": target, "name": name, "instructions": -7, "inverse_throughput": -7, "load_instructions": 1,
            "load_inverse_throughput": 1}


with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "recorded.json"
    assert record(path).returncode == 0, "a file that is not there yet is written"
    fresh = json.loads(path.read_text())
    names = [r["name"] for r in fresh["rows"]]
    assert "VSM" in names and "layerWarp" in names and {r["target"] for r in fresh["rows"]} == {TARGET}

    # One target of three: the others keep their figures, but for what is no function any more.
    others = [row(target, name) for target in ("GFX1100", "POLARIS10") for name in ("VSM", "layerWarp")]
    path.write_text(json.dumps({**fresh, "rows": [*others, row("GFX1100", "gone"), row(TARGET, "gone"), row(TARGET, "VSM")]}))
    assert record(path).returncode == 0
    merged = json.loads(path.read_text())["rows"]
    assert [r for r in merged if r["target"] == TARGET] == fresh["rows"], "the target's own figures are new"
    assert [r for r in merged if r["target"] != TARGET] == others, "the other targets' figures are lost"
    assert [r["target"] for r in merged] == ["GFX1100"] * 2 + [TARGET] * len(names) + ["POLARIS10"] * 2, "another order"

    # Another compiler, and a file that cannot be read: refused, with a reason, and nothing changed.
    for text, reason in ((json.dumps({**fresh, "compiler": "RADV 1.0"}), "RADV 1.0"), ('{"rows": []', "cannot read")):
        path.write_text(text)
        done = record(path)
        assert done.returncode not in (0, 77) and reason in done.stderr, done.stderr
        assert path.read_text() == text, "the file has changed"
