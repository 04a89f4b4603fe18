#!/usr/bin/env python3
"""Fails when the languages have drifted apart, or a shader file holds what some client refuses.

Compares functions, parameters, types, doc comments and constants topic by topic, and the rows of functions.def; then
the lists that a new function, test or topic has to be on, see lists.py.
Prints every difference, one a line:  check.py [ROOT]
"""
import fractions
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import lists  # noqa: E402
import lvsm_api  # noqa: E402
import ranges  # noqa: E402
import wgsl  # noqa: E402
from lvsm_api import LANGUAGES, UMBRELLA, source, topics  # noqa: E402

SHADERS = [language for language in LANGUAGES if language != "C++"]

# What clients refuse (naga most of all), and what would tie a maths file to a pipeline. LVSM_PRECISE hides `precise`.
REFUSED = re.compile(r"\b(precise|isnan|isinf|switch|lowp|mediump|highp|precision|[iu]?sampler\w*|[iu]?texture\w*|"
                     r"Texture\w+|Sampler\w+|uniform|cbuffer|layout|register)\b|#\s*(version|extension|pragma)")
# The words of the languages that stand at the scope of a file beside the names that it declares.
LANGUAGE_WORDS = re.compile(r"const|static|inline|void|struct|in|out|inout|((float|int|uint|bool|[iub]?vec)\d?(x\d)?)")


def compare_functions(root, topic):
    """Yields the differences of the shader languages from C++, which is the reference."""
    api = {language: {f.name: f for f in lvsm_api.functions(root, language, topic)} for language in LANGUAGES}
    names = {language: list(functions) for language, functions in api.items()}
    for language in SHADERS:
        for name in sorted(set(names["C++"]) ^ set(names[language])):
            missing = language if name in names["C++"] else "C++"
            yield f"{topic}: {name} is missing in {missing}"
        if sorted(names["C++"]) == sorted(names[language]) and names["C++"] != names[language]:
            yield f"{topic}: the functions stand in another order in {language}"
    for name, reference in api["C++"].items():
        for language in SHADERS:
            other = api[language].get(name)
            if other is None:
                continue
            if [n for _, n in reference.parameters] != [n for _, n in other.parameters]:
                yield f"{topic}: {name}'s parameters differ in {language}, by name or order"
            elif reference.parameters != other.parameters:
                yield f"{topic}: {name}'s parameter types differ in {language}"
            if reference.result != other.result:
                yield f"{topic}: {name}'s result is {reference.result} in C++, {other.result} in {language}"
            if reference.doc != other.doc:
                yield f"{topic}: {name}'s doc comment differs in {language} {first_difference(reference.doc, other.doc)}"


def compare_types(root, topic):
    """Likewise: a struct has the same members in each language."""
    api = {language: {t.name: t for t in lvsm_api.types(root, language, topic)} for language in LANGUAGES}
    for language in SHADERS:
        for name in sorted(set(api["C++"]) | set(api[language])):
            reference, other = api["C++"].get(name), api[language].get(name)
            if reference is None or other is None:
                yield f"{topic}: type {name} is missing in {'C++' if reference is None else language}"
            elif reference.members != other.members:
                yield f"{topic}: {name}'s members differ in {language}"
            elif reference.doc != other.doc:
                yield f"{topic}: {name}'s doc comment differs in {language} {first_difference(reference.doc, other.doc)}"


def check_docs(root, topic):
    """Whatever C++ makes public is said to be so: by a /// comment, and once, since there are no overloads."""
    found = [*lvsm_api.functions(root, "C++", topic, canonical=False),
             *lvsm_api.types(root, "C++", topic, canonical=False)]
    for thing in found:
        if not thing.doc:
            yield f"{topic}: {thing.name} has no /// comment in C++ (what is not public belongs into namespace detail)"
    for name in sorted({thing.name for thing in found if sum(other.name == thing.name for other in found) > 1}):
        yield f"{topic}: {name} is there twice, and the shader languages disagree about overloads"


def first_difference(a, b):
    words = [text.split() for text in (a, b)]
    at = next((i for i, (x, y) in enumerate(zip(*words)) if x != y), min(map(len, words)))
    return "from: '{}' / '{}'".format(*(" ".join(w[max(at - 1, 0):at + 3]) for w in words))


def compare_constants(root, topic):
    values = {language: lvsm_api.constants(root, language, topic) for language in LANGUAGES}
    for name in sorted(set().union(*values.values())):
        of = {language: values[language].get(name) for language in LANGUAGES}
        if len(set(of.values())) > 1:
            yield f"{topic}: {name} differs: " + ", ".join(f"{value} in {language}" for language, value in of.items())


def check_literals(root):
    """A larger literal than the largest float is infinite to some compilers, though it would round to that float."""
    largest = fractions.Fraction(2) ** 128 - fractions.Fraction(2) ** 104
    for path, _ in lvsm_api.files(root):
        for literal in re.findall(r"(?<![\w.])\d+\.?\d*(?:[eE][+-]?\d+)?", lvsm_api.without_comments(path.read_text())):
            if fractions.Fraction(literal.rstrip(".")) > largest:
                yield f"{path.relative_to(root)}: {literal} is more than the largest float"


def check_precise(root, topic):
    """What rounds where terms cancel does so: LVSM_PRECISE in shaders but WGSL's, detail::rounded in C++."""
    marked = {}
    for language in ("C++", "GLSL", "HLSL"):
        mark = r"\brounded\(" if language == "C++" else r"\bLVSM_PRECISE\b"
        parts = re.split(r"^\w[^\n#;=]*?\b(?:lvsm_)?(\w+)\(", lvsm_api.without_comments(source(root, language, topic).read_text()),
                         flags=re.MULTILINE)
        marked[language] = {name for name, body in zip(parts[1::2], parts[2::2]) if re.search(mark, body)}
    for name in sorted(marked["GLSL"] ^ marked["HLSL"]):
        yield f"{topic}: {name} says LVSM_PRECISE in one of GLSL and HLSL alone"
    for name in sorted((marked["GLSL"] | marked["HLSL"]) - marked["C++"]):
        yield f"{topic}: {name} says LVSM_PRECISE in shaders, and not detail::rounded in C++"


def check_shader(root, language, topic):
    path = source(root, language, topic)
    text = lvsm_api.read(root, language, topic)
    where = f"{topic} in {language}"
    code = lvsm_api.without_comments(text)

    guard = f"LVSM_{topic.upper()}_{path.suffix[1:].upper()}"
    if language != "WGSL" and not re.match(rf"\s*#ifndef {guard}\n#define {guard}\n.*\n#endif\s*$", code, re.DOTALL):
        yield f"{where}: the include guard is not {guard}"
    for match in REFUSED.finditer(re.sub(r"#define LVSM_PRECISE precise\n", "", code)):
        yield f"{where}: clients refuse '{match.group()}'"
    for name in sorted(set(re.findall(r"\b\w*__\w*\b", code)) - {"__VERSION__"}):
        yield f"{where}: {name} has two underscores in a row, which GLSL reserves"

    macros = re.findall(r"^\s*#\s*define\s+(\w+)", code, re.MULTILINE)
    flat = lvsm_api.file_scope(text)[0]
    flat = re.sub(r"^\s*#.*|@\d+@|\([^()]*\)|=[^;]*|\[[^\]]*\]", " ", flat, flags=re.MULTILINE)
    for name in macros + re.findall(r"[A-Za-z_]\w*", flat):
        if not re.match(r"lvsm_|LVSM_", name) and not LANGUAGE_WORDS.fullmatch(name):
            yield f"{where}: {name} could collide with a client's name: it has no lvsm_ or LVSM_ in front"


def check_needs(root):
    """The third line of each file names the others that it needs."""
    for path, folder in lvsm_api.files(root):
        needed = "every topic" if path.stem == UMBRELLA else ", ".join(lvsm_api.needs(path, folder)) or "no other"
        if f"// Needs: {needed}." not in path.read_text().splitlines()[:4]:
            yield f"{path.relative_to(root)} is to say in its first lines:  // Needs: {needed}."


def check_rows(root, public):
    path = pathlib.Path(root) / "tests/parity/functions.def"
    if not path.exists():
        yield "tests/parity/functions.def is missing"
        return
    text = lvsm_api.without_comments(path.read_text())
    rows = re.findall(r"^FUNCTION\((\w+),[^\n]*\)$", text, re.MULTILINE)
    if len(rows) != len(re.findall(r"\bFUNCTION\b", text)) or re.search(r"^\s*#", text, re.MULTILINE):
        yield "tests/parity/functions.def: a row stands in one line, from its beginning, and outside #if: the build reads it so"
    for function in public:
        if function.name not in rows:
            yield f"{function.name} has no row in tests/parity/functions.def"
    for name in sorted(set(rows) - {function.name for function in public}):
        yield f"tests/parity/functions.def has a row for {name}, which is no public function"
    for name in sorted({name for name in rows if rows.count(name) > 1}):
        yield f"tests/parity/functions.def has two rows for {name}"
    yield from ranges.check(text, public)


def readable(topic, check):
    """The differences that a check finds, and what in the files it cannot read."""
    try:
        yield from check
    except ValueError as error:
        yield f"{topic}: {error}"


def differences(root):
    host = lvsm_api.host_alone(root)
    shared = topics(root, "C++") - host
    for language in SHADERS:
        for topic in sorted(shared - topics(root, language)):
            yield (f"topic {topic} is missing in {language}; the header of one for C++ alone has a line "
                   f"'// {lvsm_api.HOST_ALONE}' in its first comment")
        for topic in sorted(topics(root, language) - shared):
            yield f"topic {topic} is missing in C++" if topic not in host else f"topic {topic} is not for C++ alone"
    for language in ("C++", "GLSL", "HLSL"):
        included = set(re.findall(r'#include "(?:lvsm/)?(\w+)\.', source(root, language, UMBRELLA).read_text()))
        for topic in sorted(topics(root, language) - included - {UMBRELLA, "config"}):
            yield f"the umbrella does not include {topic} in {language}"

    for topic in sorted(topics(root, "C++")):
        yield from readable(topic, check_docs(root, topic))
    public = []
    for topic in sorted(set.intersection(*(topics(root, language) for language in LANGUAGES))):
        for compare in (compare_functions, compare_types, compare_constants, check_precise):
            yield from readable(topic, compare(root, topic))
        try:
            public += lvsm_api.functions(root, "C++", topic)
        except ValueError:
            pass  # said already
    for language in SHADERS:
        for topic in sorted(topics(root, language)):
            yield from check_shader(root, language, topic)
    yield from check_needs(root)
    yield from check_literals(root)
    yield from check_rows(root, public)
    yield from wgsl.differences(pathlib.Path(root))
    yield from lists.differences(root)


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2]
    found = list(differences(root))
    print(*found, f"{len(found)} differences", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
