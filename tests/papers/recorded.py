#!/usr/bin/env python3
"""The recorded figures of the papers, and the test that they are what is measured now.

    recorded.py --check LVSM_PAPERS REPORT                  measures all errors and pictures anew, and writes the rows
    recorded.py --record LVSM_PAPERS [LVSM_PAPERS_TIME]     records errors and pictures, with the second program the
                                                            times too, and renews docs/papers.md

Times depend on the machine, so no test compares them; what is shown are ratios within the recorded run.

REPORT is build/reports/papers.json, a list of rows: paper, item, claim, theirs, ours, criterion, agrees, why.
"""
import datetime
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tests/papers"), str(ROOT / "tests/gallery")]
import claims
import recorded_run
from readme_picture import difference, read_png

FILE = pathlib.Path(__file__).with_name("recorded.json")
PICTURES = ROOT / "docs/papers"
# A value that is compared with a threshold many times over may count one of them differently.
RELATIVE, ABSOLUTE = 2e-3, 1e-4
# Mean difference of a channel, of 255.
PICTURE_DIFFERENCE = 0.1


def measure(program, *options):
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "values.json"
        subprocess.run([program, "--output", str(output), *options], check=True)
        return json.loads(output.read_text())


def measure_errors(program, pictures):
    return measure(program, "--pictures", str(pictures))


def rounded(values):
    return {item: {name: float(f"{value:.6g}") for name, value in figures.items()} for item, figures in values.items()}


def with_run(times):
    """Times with what they were measured on."""
    run = {**times.pop("run"), "date": datetime.date.today().isoformat(), "machine": recorded_run.processor(),
           "load": recorded_run.load()}
    return {"run": {"run": run}, "times": rounded(times)}


def write(record_):
    parts = [f"{json.dumps(part)}: {{\n" + ",\n".join(f"{json.dumps(item)}: {json.dumps(figures)}"
                                                     for item, figures in values.items()) + "\n}"
             for part, values in record_.items()]
    FILE.write_text("{\n" + ",\n".join(parts) + "\n}\n")


def whole():
    return json.loads(FILE.read_text())


def values(record_=None):
    """Everything that claims are judged by."""
    record_ = record_ or whole()
    times = {item: claims.derived(figures) for item, figures in record_["times"].items()}
    return {**record_["errors"], **record_["run"], **times}


def record(program, timer=None):
    write({**(whole() if FILE.exists() else {}), "errors": rounded(measure_errors(program, PICTURES)),
           **(with_run(measure(timer)) if timer else {})})
    subprocess.run([sys.executable, str(ROOT / "tests/docs/documents.py"), "--write"], check=False)


def differing_values(was, now):
    for item in sorted(set(was) ^ set(now)):
        yield f"{item} is {'not recorded' if item in now else 'recorded, but not measured'}"
    for item in sorted(set(was) & set(now)):
        for name in sorted(set(was[item]) | set(now[item])):
            before, is_ = was[item].get(name), now[item].get(name)
            if before is None or is_ is None or abs(is_ - before) > ABSOLUTE + RELATIVE * abs(before):
                yield f"{item}.{name}: {is_}, recorded {before}"


def differing_pictures(folder):
    names = {path.name for path in folder.glob("*.png")}
    for name in sorted(names ^ {path.name for path in PICTURES.glob("*.png")}):
        yield f"{name} is {'not in' if name in names else 'in'} {PICTURES.relative_to(ROOT)}, and {'' if name in names else 'not '}made"
    for name in sorted(names):
        if (PICTURES / name).exists() and (PICTURES / name).read_bytes() != (folder / name).read_bytes():
            was, is_ = read_png(PICTURES / name), read_png(folder / name)
            same_size = [len(row) for row in was] == [len(row) for row in is_]
            if not same_size or difference(was, is_) > PICTURE_DIFFERENCE:
                yield f"{name} is another picture"


def check(program, report):
    with tempfile.TemporaryDirectory() as folder:
        now = rounded(measure_errors(program, folder))
        yield from differing_values(whole()["errors"], now)
        yield from differing_pictures(pathlib.Path(folder))
    before, rows = claims.rows(values()), claims.rows(values({**whole(), "errors": now}))
    for was, row in zip(before, rows):
        if was["agrees"] != row["agrees"]:
            yield f"{row['paper']}, {row['item']}: {row['ours']}: agrees {row['agrees']}, recorded {was['agrees']}"
    yield from claims.faults(rows)
    pathlib.Path(report).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(report).write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    recorded_run.main(__doc__, check, record,
                      "If they are meant: tests/papers/recorded.py --record build/tests/papers/lvsm_papers")
