"""The lists that a new function, test, wrapper, domain or topic has to be on, as CONTRIBUTING.md says.

Each is read from the files themselves, and a message names the file and what to add to it.
"""
import pathlib
import re

import lvsm_api
from lvsm_api import LANGUAGES, UMBRELLA

# Words of an umbrella's "Topics:" sentence that are no topics.
GLUE = {"on", "the", "host", "also", "and"}


def with_functions(root, language):
    """The topics of a language that have something public."""
    def has_functions(topic):
        try:
            return topic != UMBRELLA and lvsm_api.functions(root, language, topic, canonical=False)
        except ValueError:
            return False  # check.py says so

    return {topic for topic in lvsm_api.topics(root, language) if has_functions(topic)}


def check_names(where, named, topics):
    for topic in sorted(topics - named):
        yield f"{where} does not name the topic {topic}"
    for name in sorted(named - topics):
        yield f"{where} names {name}, which is no topic"


def readme_topics(root):
    text = (root / "README.md").read_text()
    table = re.search(r"^\| topic \| what \|\n\|---\|---\|\n((?:\|.*\n)+)", text, re.MULTILINE)
    if not table:
        yield "README.md has no table '| topic | what |'"
        return
    topics = with_functions(root, "C++")
    named = set(re.findall(r"^\| `(\w+)`", table[1], re.MULTILINE))
    elsewhere = {name for name in re.findall(r"`(\w+)`", table[1]) if name in topics}
    yield from check_names("README.md's table of topics", named | elsewhere, topics)


def manual_topics(root):
    for language in LANGUAGES:
        text = lvsm_api.source(root, language, UMBRELLA).read_text()
        sentence = re.search(r"^// Topics: ([^.]*)\.", text, re.MULTILINE)
        where = f"the sentence '// Topics: ...' of lvsm{LANGUAGES[language][1]}"
        if not sentence:
            yield f"{where} is missing"
            continue
        named = set(re.findall(r"[a-z]\w*", sentence[1])) - GLUE
        yield from check_names(where, named, with_functions(root, language))


def unit_tests(root):
    """A function's meaning is pinned by a unit test; each of their files is built because its name ends so."""
    folder = root / "tests/unit"
    text = lvsm_api.without_comments("".join(path.read_text() for path in sorted(folder.glob("*_test.cpp"))))
    for topic in sorted(with_functions(root, "C++")):
        for function in lvsm_api.functions(root, "C++", topic, canonical=False):
            if not re.search(rf"\b{function.name}\b", text):
                yield f"no test in tests/unit/*_test.cpp calls {function.name} ({topic}): what it means is in no test"
    for path in sorted(folder.glob("*.cpp")):
        if path.name != "main.cpp" and not path.name.endswith("_test.cpp"):
            yield f"tests/unit/{path.name} is not built: the names of test files end in _test.cpp"


def sources(root):
    """Every .cpp file of tests and examples stands in the CMakeLists.txt beside it, or that one takes all."""
    for folder in ("tests", "examples"):
        for path in sorted((root / folder).rglob("*.cpp")):
            lists = path.parent / "CMakeLists.txt"
            text = lists.read_text() if lists.exists() else ""
            globbed = re.search(r"file\(GLOB [^)]*\*(_test)?\.cpp", text)
            if not re.search(rf"(?<![\w.]){re.escape(path.name)}", text) and not globbed:
                yield f"{path.relative_to(root)} is not built: {lists.relative_to(root)} does not name it"
        for path in sorted((root / folder).glob("*/CMakeLists.txt")):
            parent = root / folder / "CMakeLists.txt"
            if f"{path.parent.name})" not in parent.read_text() and path.parent.name != "support":
                yield f"{path.relative_to(root)} is not read: {parent.relative_to(root)} has no add_subdirectory for it"


def wrappers(root):
    """Every sampling wrapper is called by a kernel of its language in tests/sampling, every pass is named there.

    A kernel's .glsl is included by its .hlsl too.
    """
    tests = root / "tests/sampling"
    code = {language: "".join(path.read_text() for path in sorted(tests.glob("kernels/*")) if path.suffix in suffixes)
            for language, suffixes in (("glsl", (".comp", ".frag", ".glsl")), ("hlsl", (".hlsl", ".hlsli", ".glsl")))}
    programs = "".join(path.read_text() for path in sorted(tests.glob("*.cpp")) + sorted(tests.glob("*.py")))
    code["wgsl"] = "".join(path.read_text() for path in sorted(tests.glob("kernels/*.wgsl")))
    for language in ("glsl", "hlsl", "wgsl"):
        for path in sorted(path for path in (root / language / "lvsm/sampling").rglob("*") if path.is_file()):
            names = re.findall(r"^(?:///[^\n]*\n)+[\w<>]+ (lvsm_\w+)\(", path.read_text(), re.MULTILINE)
            for name in names:
                if not re.search(rf"\b{name}\b", code[language]):
                    yield f"no shader in tests/sampling/kernels calls {name} of {path.relative_to(root)}"
        for path in sorted((root / language / "lvsm/sampling").glob("*/*")):
            form = path.parent.with_suffix(path.suffix)
            if language != "wgsl" and f'#include "{form.stem}/{path.name}"' not in form.read_text():
                yield f"{form.relative_to(root)} does not include {path.relative_to(root)}"
        passes = sorted((root / language / "lvsm/passes").glob("*"))
        included = {name for path in passes for name in re.findall(r'#include "(\w+\.\w+)"', path.read_text())}
        needs = "".join(re.search(r"// Needs: .*|$", path.read_text())[0] for path in passes)
        included |= {f"{name}.wgsl" for name in re.findall(r"\bpasses/(\w+)", needs)}
        for path in passes:
            if not re.search(rf"\b{path.stem}\b", programs) and path.name not in included:
                yield f"nothing in tests/sampling runs {path.relative_to(root)}"


def domains(root):
    """Every domain that a row names is defined, and every one that is defined has a row."""
    defined = set(re.findall(r'^ *\{"(\w+)",', (root / "tests/parity/domains.cpp").read_text(), re.MULTILINE))
    rows = re.findall(r"^FUNCTION\((\w+), .*\), (\w+), [^,]+, [^,]+\)$", (root / "tests/parity/functions.def").read_text(),
                      re.MULTILINE)
    for function, domain in rows:
        if domain not in defined:
            yield f"{function}'s row names the domain {domain}, which tests/parity/domains.cpp does not define"
    for domain in sorted(defined - {domain for _, domain in rows}):
        yield f"tests/parity/domains.cpp defines {domain}, which no row of functions.def names"


def estimates(root):
    """Every row of estimates.def begins its line, which is where the documents' tables look for it."""
    text = lvsm_api.without_comments((root / "tests/cost/estimates.def").read_text())
    if len(re.findall(r"^ESTIMATE\(", text, re.MULTILINE)) != len(re.findall(r"\bESTIMATE\b", text)):
        yield "tests/cost/estimates.def: a row begins its line, and one row each"


def differences(root):
    root = pathlib.Path(root)
    for check in (readme_topics, manual_topics, unit_tests, sources, wrappers, domains, estimates):
        try:
            yield from check(root)
        except FileNotFoundError as error:
            yield f"{pathlib.Path(error.filename).relative_to(root)} is missing"
