#!/usr/bin/env python3
"""Prints "N passed, N failed, N skipped" for a file written by ctest --output-junit.

Skipped are the tests that said so by their exit status; one that could not be started counts as failed.
"""
import sys
import xml.etree.ElementTree

counts = {"passed": 0, "failed": 0, "skipped": 0}
for case in xml.etree.ElementTree.parse(sys.argv[1]).getroot().iter("testcase"):
    skipped = case.find("skipped")
    if case.get("status") == "run":
        counts["passed"] += 1
    elif skipped is not None and skipped.get("message", "").startswith("SKIP_"):
        counts["skipped"] += 1
    else:
        counts["failed"] += 1
print(", ".join(f"{count} {name}" for name, count in counts.items()))
