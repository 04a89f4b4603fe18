#!/usr/bin/env python3
"""Compares every table and figure in README.md and docs/ with what it was measured from, or with --write renews them.

    tests/docs/documents.py [--write]

A document marks what is made:

    <!-- table: cost.estimates -->     a table, up to the next  <!-- end -->
    0.93<!--= rmse("LVSM-8") / 2 -->   a figure in a sentence: the number in front of the comment is the value of the
                                       expression, to as many decimals as are written; .93 and 93% are numbers, too
    <!-- holds: cost("VSM") < 9 -->    a claim in words: the expression is true
    <!-- given -->                     somewhere in a paragraph: its other figures are chosen or derived, not measured

A table with decimals that is not marked is a fault, and so is a decimal or percentage in a sentence; code, headings
and the names of versions and sections are let be. A heading that a maker needs and does not find is one, too.

To add a table: a module tests/FOLDER/doc_tables.py with any of

    TABLES = {"FOLDER.name": function}      the table's lines, each a list of cells, the first of them the heading
    NAMES = {"rmse": function or value}     what expressions may use
    FILES = {"docs/name.svg": function}     a whole file's text

They read the figures of a recorded run (JSON, committed beside the module), never a document; and a test compares what
is recorded with a run of now: of all of it, or of a part that is small enough to be run each time.
"""
import argparse
import importlib.util
import math
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"(?P<head><!-- table: (?P<name>[\w.]+) -->\n)(?P<body>.*?)(?P<end><!-- end -->)", re.DOTALL)
FIGURE = re.compile(r"(?P<number>-?[\d.]*\d)(?P<unit>%?)<!--= (?P<expression>.*?) -->", re.DOTALL)
CLAIM = re.compile(r"<!-- holds: (?P<expression>.*?) -->", re.DOTALL)
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
# A decimal or a percentage that no marker explains.
LOOSE = re.compile(r"(?<![\w.])(?:\d*\.\d+|\d+%|\d+e-?\d+)(?![\w.]*\w)")
NUMERIC_CELL = re.compile(r"(?<=\| )-?\d[\d., ]*(?= \|)")
# What is no figure: code, the target of a link, a version, the place in a paper.
QUOTED = re.compile(r"`[^`]*`|\]\([^)]*\)|\b[A-Z]\w*\+* \d+\.\d+(\.\d+)*|\d+\.\d+\.\d+|\b[vV]\d\S*|"
                    r"\b(sections?|chapters?|equations?|figures?|ch\.) [\d.]+( and [\d.]+)?")


class Fault(Exception):
    pass


def documents(root):
    return [root / "README.md", *sorted((root / "docs").glob("*.md"))]


def makers(root):
    """TABLES, NAMES and FILES of all modules doc_tables.py."""
    tables, names, files = {}, {"ln": math.log, "sqrt": math.sqrt, "min": min, "max": max, "sum": sum, "len": len, "all": all, "any": any, "abs": abs}, {}
    for path in sorted((root / "tests").glob("*/doc_tables.py")):
        spec = importlib.util.spec_from_file_location(f"doc_tables_of_{path.parent.name}", path)
        module = importlib.util.module_from_spec(spec)
        sys.path.insert(0, str(path.parent))
        spec.loader.exec_module(module)
        sys.path.pop(0)
        for all_, name in ((tables, "TABLES"), (names, "NAMES"), (files, "FILES")):
            all_.update(getattr(module, name, {}))
    return tables, names, files


def markdown(lines):
    """A table of cells; the line under the heading is made here."""
    rows = ["| " + " | ".join(line) + " |\n" for line in lines]
    return rows[0] + "|" + "---|" * len(lines[0]) + "\n" + "".join(rows[1:])


def like(written, value):
    """The value, written as the number that stands there is."""
    if isinstance(value, str):
        return value
    decimals = len(written.partition(".")[2])
    text = f"{value:.{decimals}f}"
    return re.sub(r"^(-?)0\.", r"\1.", text) if re.match(r"-?\.", written) else text


def evaluated(match, names):
    expression = " ".join(match["expression"].split())
    try:
        return eval(expression, {"__builtins__": {}, **names})
    except Exception as error:
        raise Fault(f"cannot evaluate {expression}: {error!r}") from error


def renewed(text, tables, names):
    """The document with every table and figure as they are now."""
    def table(match):
        if match["name"] not in tables:
            raise Fault(f"there is no table {match['name']}; there are {', '.join(sorted(tables))}")
        try:
            made = tables[match["name"]]()
        except (KeyError, StopIteration) as error:
            raise Fault(f"the recorded run lacks what table {match['name']} shows: {error!r}") from error
        return match["head"] + (made if isinstance(made, str) else markdown(made)) + match["end"]

    def figure(match):
        return like(match["number"], evaluated(match, names)) + match.group()[len(match["number"]):]

    return FIGURE.sub(figure, BLOCK.sub(table, text))


def loose_ends(text):
    """Yields what has no marker: tables with numbers in cells of their own, and figures in sentences."""
    text = re.sub(r"^```.*?^```\n|^#[^\n]*\n", "\n", text, flags=re.DOTALL | re.MULTILINE)
    if not text.count("<!-- table:") == text.count("<!-- end -->") == len(BLOCK.findall(text)):
        yield "a table has a beginning and no end, or an end and no beginning"
    text = BLOCK.sub("", text)
    for paragraph in re.split(r"\n(?:\s*\n|(?=- ))", text):
        if "<!-- given -->" in paragraph:
            continue
        plain = QUOTED.sub("", COMMENT.sub("", FIGURE.sub("", paragraph)))
        is_table = re.search(r"^\|[-|:]+\|$", plain, re.MULTILINE)
        found = LOOSE.findall(plain) + (NUMERIC_CELL.findall(plain) if is_table else [])
        if found:
            yield (f"no marker at {', '.join(found[:8])} in a {'table' if is_table else 'sentence'}: "
                   f"{' '.join(plain.split())[:70]}...")


def first_difference(old, new):
    pairs = zip(old.splitlines() + [""], new.splitlines() + [""])
    return next((f"has\n    {a}\nand should have\n    {b}" for a, b in pairs if a != b), "")


def faults(text, tables, names):
    """Yields what is wrong with a document's text."""
    try:
        new = renewed(text, tables, names)
        if new != text:
            yield f"{first_difference(text, new)}\n    tests/docs/documents.py --write mends it"
        for match in CLAIM.finditer(text):
            if not evaluated(match, names):
                yield f"does not hold: {' '.join(match['expression'].split())}"
    except Fault as fault:
        yield str(fault)
    yield from loose_ends(text)


def check(root):
    """Yields the faults of all documents and made files, and the tables that are in none."""
    tables, names, files = makers(root)
    texts = {path: path.read_text() for path in documents(root)}
    for path, text in texts.items():
        for fault in faults(text, tables, names):
            yield f"{path.relative_to(root)}: {fault}"
    used = {match["name"] for text in texts.values() for match in BLOCK.finditer(text)}
    for name in sorted(set(tables) - used):
        yield f"no document has the table {name}:  <!-- table: {name} -->"
    for name, make in files.items():
        if not (root / name).exists() or (root / name).read_text() != make():
            yield f"{name} is not what tests/docs/documents.py --write makes"


def write(root):
    """Renews all documents and made files."""
    tables, names, files = makers(root)
    for path in documents(root):
        try:
            path.write_text(renewed(path.read_text(), tables, names))
        except Fault as fault:
            print(f"{path.relative_to(root)}: {fault}")
    for name, make in files.items():
        (root / name).write_text(make())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    if parser.parse_args().write:
        write(ROOT)
    found = list(check(ROOT))
    print(*found, f"{len(found)} faults", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
