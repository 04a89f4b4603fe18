"""The library's own constants, for the figures of documents, and the list of its functions."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import lvsm_api  # noqa: E402


def constant(topic, name):
    return lvsm_api.constants(ROOT, "C++", topic)[name]


def links(topic):
    """To the topic's file in each language that has it, and to its tests."""
    found = []
    for language in lvsm_api.LANGUAGES:
        path = lvsm_api.source(ROOT, language, topic)
        if path.exists():
            found.append(f"[{language}](../{path.relative_to(ROOT)})")
    tests = [path for path in (ROOT / f"tests/unit/{topic}_test.cpp", ROOT / "tests/parity/functions.def")
             if path.exists() and (len(found) > 1 or path.suffix == ".cpp")]
    return ", ".join(found + [f"[{path.stem}](../{path.relative_to(ROOT)})" for path in tests])


def title(topic):
    text = lvsm_api.source(ROOT, "C++", topic).read_text()
    comment = re.search(r"^(?!// (?:SPDX|Copyright|Needs))// ((?:.*\n)(?:// .*\n)*)", text, re.MULTILINE)[1]
    return re.split(r"(?<=\.)\s", " ".join(comment.replace("\n// ", "\n").split()))[0]


def functions():
    """docs/functions.md: each public function in a line, topic by topic in the order of pasting."""
    order = [name for name in lvsm_api.needs(lvsm_api.source(ROOT, "C++", lvsm_api.UMBRELLA), ROOT / "include/lvsm")
             if name != "GLM"]
    lines = ["# Functions", "",
             "Each public function, by its name in C++; in shaders it begins with `lvsm_`. Made by "
             "`tests/docs/documents.py --write`", "from the headers. <!-- given -->", ""]
    for topic in order:
        rows = []
        for function in lvsm_api.functions(ROOT, "C++", topic, canonical=False):
            if function.doc:
                names = ", ".join(re.search(r"(\w+)(?:\s*=.*)?$", parameter)[1] for parameter in function.declaration[2])
                what = re.split(r"(?<=\.)\s|:\s", function.doc)[0].rstrip(".")
                rows.append(f"| `{function.name}({names})` | {what} |")
        if rows:
            lines += [f"## {topic}", "", title(topic), "", f"In {links(topic)}.", "", "<!-- given -->",
                      "| function | what |", "|---|---|", *rows, ""]
    return "\n".join(lines)


NAMES = {"constant": constant}
FILES = {"docs/functions.md": functions}
