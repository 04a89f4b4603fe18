"""The table of docs/configurations.md, of the run that recorded.json holds."""
import json
import pathlib

from configurations import CONFIGURATIONS

RECORDED = pathlib.Path(__file__).with_name("recorded.json")


def runs():
    rows = {row["name"]: row for row in json.loads(RECORDED.read_text())}
    lines = [["configuration", "for", "built with", "unit tests", "parity", "result"]]
    for configuration in CONFIGURATIONS:
        row = rows[configuration.name]
        if (row["command"], row["runner"]) != (configuration.command, configuration.runner):
            raise KeyError(f"{configuration.name} was recorded with other flags")
        unit = f"{row['cases']} cases" + (f", of which {row['left_out']} are left out" if row["left_out"] else "")
        passed = row["unit_passed"] and row["parity_passed"]
        by = f", run by {configuration.runner}" if configuration.runner else ""
        lines.append([configuration.name, configuration.why, f"`{configuration.command}`{by}", unit,
                      f"{row['functions']} functions, {row['inputs']} inputs", "passed" if passed else "failed"])
    return lines


TABLES = {"configurations.runs": runs}
