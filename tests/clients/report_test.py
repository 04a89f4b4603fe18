#!/usr/bin/env python3
"""Spoils the reports of all clients in one way, and passes when report.py refuses them:  report_test.py [CASE]

Without CASE, lists the cases.
"""
import sys

import report


def good():
    return {name: {"client": name, "version": "1", "functions": 9, "inputs": 90, "failed": 0,
                   "worst_error": 2e-7, "tolerance": 1e-6} for name in report.CLIENTS}


# Of each case: what it does to the reports, and a part of what must be said; None where nothing is wrong.
CASES = {
    "nothing": (lambda found: None, None),
    "one_failed": (lambda found: found["three"].update(failed=1), "three: 1 functions failed"),
    "functions_missing": (lambda found: found["wgpu"].update(functions=8), "wgpu: 8 functions of 9"),
    "no_inputs": (lambda found: found["naga"].update(inputs=0), "0 inputs"),
    "no_version": (lambda found: found["panda3d"].update(version=""), "panda3d does not say"),
    "client_missing": (lambda found: found.pop("webgpu"), "webgpu has not run"),
    "all_missing": (lambda found: found.clear(), "no client has run"),
    "other_device": (lambda found: found["three"].update(worst_error=6e-7), None),
    "other_magnitude": (lambda found: found["three"].update(worst_error=2.1e-6), "three: worst_error is 2.1e-06, recorded 2e-07"),
}

if len(sys.argv) < 2:
    print(*CASES, sep="\n")
    sys.exit(0)
spoil, expected = CASES[sys.argv[1]]
found = good()
spoil(found)
said = [*report.faults(found, True), *report.outdated(found, good())]
print(*said, sep="\n")
sys.exit(0 if (any(expected in line for line in said) if expected else not said) else 1)
