"""What the recorded.py of several folders share: their command line, and the machine that a run was made on."""
import argparse
import os
import pathlib
import re
import sys


def main(description, check, record, mending=""):
    """check(*programs) yields what differs from the record; record(*programs) makes it anew. mending: how to, in words."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("programs", nargs="+", help="as the file's first lines say")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true")
    what.add_argument("--record", action="store_true")
    options = parser.parse_args()
    if options.record:
        record(*options.programs)
        sys.exit(0)
    found = list(check(*options.programs))
    print(*found, f"{len(found)} differences", sep="\n")
    if found and mending:
        print(mending)
    sys.exit(1 if found else 0)


def processor():
    """In words: the processor, and how much of it there is."""
    cpu = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return f"{cpu[1] if cpu else 'unknown'}, {os.cpu_count()} cores"


def load():
    """How much else the machine did: the mean number of running processes in the last minute."""
    return round(os.getloadavg()[0], 1)
