"""Reads the public functions and constants of one of lvsm's source files, in any of its three languages.

It knows only what these files are made of: functions and constants at the scope of the file (in C++ of namespace lvsm,
with namespace detail left out), a /// comment directly above each function, // comments elsewhere. Types and names come
out in one canonical form, so that the three languages can be compared: `float2`, `float[]`, `inout float[]`, LVSM_TINY.
"""
import dataclasses
import pathlib
import re

LANGUAGES = {"C++": ("include/lvsm", ".hpp"), "GLSL": ("glsl/lvsm", ".glsl"), "HLSL": ("hlsl/lvsm", ".hlsli")}
UMBRELLA = "lvsm"
# Topics that exist in C++ alone: algorithms over whole images, which no shader runs.
HOST_ONLY = {"lloyd", "optimal", "runs"}


@dataclasses.dataclass
class Function:
    name: str
    result: str
    parameters: list  # of (type, name)
    doc: str
    # As written, for generated C++.
    template: str
    declaration: tuple


def source(root, language, topic):
    folder, suffix = LANGUAGES[language]
    return pathlib.Path(root) / folder / (topic + suffix)


def topics(root, language):
    folder, suffix = LANGUAGES[language]
    return {path.stem for path in (pathlib.Path(root) / folder).glob("*" + suffix)}


def files(root):
    """Every file that users copy, with the folder lvsm that it lies in."""
    for folder, _ in LANGUAGES.values():
        for path in sorted((pathlib.Path(root) / folder).rglob("*.*")):
            yield path, pathlib.Path(root) / folder


def needs(path, folder):
    """What a file includes and these include in turn, each after what it needs itself: the order in which to paste."""
    found = []
    for bracket, name in re.findall(r'^#include ([<"])([^>"]+)', path.read_text(), re.MULTILINE):
        if bracket == "<":
            found += ["GLM"] if name.startswith("glm/") else []
            continue
        included = (path.parent / name).resolve()
        stem = included.relative_to(folder.resolve()).with_suffix("").as_posix()
        found += ([] if stem == UMBRELLA else needs(included, folder)) + [stem]
    return list(dict.fromkeys(found))


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def file_scope(text):
    """The text with each body as `{}` and no comments, and the doc comments, each of which `@NUMBER@` stands for."""
    docs = []

    def keep(match):
        docs.append(" ".join(line.strip().lstrip("/").strip() for line in match.group().splitlines()))
        return f"@{len(docs) - 1}@\n"

    text = re.sub(r"(?:^///[^\n]*\n)+", keep, text, flags=re.MULTILINE)
    text = re.sub(r"\s*=\s*\{\}", "", text)  # default arguments
    text = re.sub(r"\bnamespace lvsm\s*\{(.*)\}", r"\1", without_comments(text), flags=re.DOTALL)
    flat, depth = [], 0
    for character in text:
        depth -= character == "}"
        if depth == 0:
            flat.append(character)
        depth += character == "{"
    return "".join(flat), docs


def canonical_type(text):
    written = text
    text = re.sub(r"\bT\b", "float", text)
    if re.fullmatch(r"(const )?float\*", text):
        return "float[]" if text.startswith("const") else "inout float[]"
    text = re.sub(r"^const |&$", "", text).strip()
    text = re.sub(r"glm::vec<(\d), (\w+)(?:, \w+)?>", r"\2\1", text)
    text = re.sub(r"(?:glm::)?\b(i?)vec(\d)\b", lambda m: ("int" if m[1] else "float") + m[2], text)
    if not re.fullmatch(r"(inout )?(float|int|bool)\d?(\[\])?|void", text):
        raise ValueError(f"a type that the mirror does not know: {written}")
    return text


def canonical_parameter(text):
    text = re.sub(r"\s*=.*", "", text)
    type_, name, array = re.fullmatch(r"(.*[\s&*])(\w+)(\[.*\])?", text).groups()
    return canonical_type(type_.strip() + ("[]" if array else "")), name


def split_parameters(text):
    return [" ".join(p.split()) for p in re.split(r",(?![^<]*>)", text) if p.strip()]


def canonical_constant(name):
    """LVSM_LARGEST_FP16 for kLargestFp16; a shader constant's name is its canonical one."""
    return re.sub(r"\bk([A-Z]\w*)", lambda m: "LVSM" + re.sub("([A-Z])", r"_\1", m[1]).upper(), name)


def canonical_doc(text):
    return canonical_constant(re.sub(r"\blvsm(_|::)", "", text))


def functions(root, language, topic, canonical=True):
    """The public functions of a topic in the order of the file. Not canonical: as written, for files of host types.

    Shaders have no namespace for what is internal: there a function with a // comment in place of /// is a helper.
    """
    text, docs = file_scope(source(root, language, topic).read_text())
    text = re.sub(r"^\s*#.*", "", text, flags=re.MULTILINE)
    pattern = re.compile(r"(?:@(?P<doc>\d+)@\s*)?(?:template <(?P<template>[^{}();]*)>\s*)?"
                         r"(?P<result>[\w:][\w:<>,*& ]*?)\s+(?P<name>\w+)\((?P<parameters>[^(){};]*)\)\s*\{\}")
    found = []
    for match in pattern.finditer(text):
        if language != "C++" and not match["doc"]:
            continue
        result = re.sub(r"\b(inline|constexpr|static)\s+", "", match["result"])
        parameters = split_parameters(match["parameters"])
        found.append(Function(
            name=match["name"].removeprefix("lvsm_"),
            result=canonical_type(result) if canonical else result,
            parameters=[canonical_parameter(p) for p in parameters] if canonical else [],
            doc=canonical_doc(docs[int(match["doc"])]) if match["doc"] else "",
            template=match["template"] or "",
            declaration=(result, match["name"], parameters)))
    return found


def constants(root, language, topic):
    """The values of a topic's constants, rounded to float, by canonical name."""
    text, _ = file_scope(source(root, language, topic).read_text())
    found = {}
    for name, value in re.findall(r"\b(?:const|constexpr) \w+ (\w+) = ([^;]+);", text):
        value = re.sub(r"\b(LVSM_\w+|k[A-Z]\w*)(<T>)?", lambda m: repr(found[canonical_constant(m[1])]), value)
        found[canonical_constant(name)] = evaluate(re.sub(r"\b(?:T|float)\(|f\b", lambda m: "(" if "(" in m[0] else "", value))
    return found


def evaluate(expression):
    import struct
    if not re.fullmatch(r"[\d.eE+\-*/() \n]+", expression):
        raise ValueError(f"a constant that the mirror cannot read: {expression}")
    return struct.unpack("f", struct.pack("f", eval(expression)))[0]
