#!/usr/bin/env python3
"""Writes the rows, runs a client on them and judges what it leaves:  judged.py ROWS FOLDER NAME REPORT CLIENT [WORD...]

Sums may come in another order: the language has no `precise`, or the driver keeps it for what says so.

ROWS: the program lvsm_client_rows. FOLDER: of this test's own. NAME: of the client, for the report.
"""
import pathlib
import shutil
import subprocess
import sys

rows, folder, name, report, *client = sys.argv[1:]
pathlib.Path(report).unlink(missing_ok=True)  # what an earlier run wrote says nothing about this one
shutil.rmtree(folder, ignore_errors=True)
pathlib.Path(folder).mkdir(parents=True)
for command in ([rows, "write", folder], client, [rows, "judge", folder, name, report, "imprecise"]):
    status = subprocess.run(command).returncode
    if status != 0:
        sys.exit(status)
