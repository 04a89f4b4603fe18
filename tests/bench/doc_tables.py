"""The recorded times, as tests/docs/documents.py shows them."""
import json
import pathlib

RECORDED = json.loads(pathlib.Path(__file__).with_name("recorded.json").read_text())
ROWS = {row["name"]: row for row in RECORDED["rows"]}


def label(name):
    """optimalSplits/layers:4/samples:0/manual_time in words."""
    words, *parts = name.removesuffix("/manual_time").split("/")
    values = dict(part.split(":") for part in parts)
    if "layers" in values:
        words += f", {values['layers']} layers"
    if "samples" in values:
        words += ", all texels" if values["samples"] == "0" else f", {values['samples']} samples"
    return words


def times():
    """Ratios first: they hold on other machines, times do not."""
    lines = [["benchmark", "of_bandwidth", "share_sampled", "time"]]
    for name, row in ROWS.items():
        ratios = [f"{row[key]:.2f}" if key in row else "" for key in ("of_bandwidth", "share_sampled")]
        lines.append([label(name), *ratios, f"{row['ms']:.2f} ms"])
    return lines


def bench(name, figure="ms"):
    return next(row[figure] for key, row in ROWS.items() if label(key) == name)


def run():
    return [["machine", "compiler", "date", "load", "command"],
            [*(str(RECORDED[key]) for key in ("machine", "compiler", "date", "load")), f"`{RECORDED['command']}`"]]


TABLES = {"bench.times": times, "bench.run": run}
NAMES = {"bench": bench}
