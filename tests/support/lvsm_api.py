"""Reads the public functions, types and constants of one of lvsm's source files, in any of its languages.

It knows only what these files are made of: functions, types and constants at the scope of the file (in C++ of namespace
lvsm, with namespace detail left out), a /// comment directly above each function and type, // comments elsewhere. What
it cannot read is a ValueError, so that nothing is overlooked. Types and names come out in one canonical form, so that
the languages can be compared: `float2`, `float[]`, `inout float[]`, LVSM_TINY.
"""
import dataclasses
import pathlib
import re

from wgsl_declarations import glsl_of_wgsl

LANGUAGES = {"C++": ("include/lvsm", ".hpp"), "GLSL": ("glsl/lvsm", ".glsl"), "HLSL": ("hlsl/lvsm", ".hlsli"),
             "WGSL": ("wgsl/lvsm", ".wgsl")}
UMBRELLA = "lvsm"
# Such a line in the first comment of a header makes its topic one of C++ alone: what no shader runs.
HOST_ALONE = "On the host alone"


@dataclasses.dataclass
class Function:
    name: str
    result: str
    parameters: list  # of (type, name)
    doc: str
    # As written, for generated C++.
    template: str
    declaration: tuple


@dataclasses.dataclass
class Type:
    name: str
    members: list  # of (type, name), where canonical and a struct
    doc: str


@dataclasses.dataclass
class Declaration:
    """One thing at the scope of a file: what stands before its body or semicolon, its body, and its /// comment."""
    text: str
    body: str  # None where it has none
    doc: str


def source(root, language, topic):
    folder, suffix = LANGUAGES[language]
    return pathlib.Path(root) / folder / (topic + suffix)


def read(root, language, topic):
    """The text of a file; that of WGSL with its declarations as GLSL would have them."""
    text = source(root, language, topic).read_text()
    return glsl_of_wgsl(text) if language == "WGSL" else text


def topics(root, language):
    folder, suffix = LANGUAGES[language]
    return {path.stem for path in (pathlib.Path(root) / folder).glob("*" + suffix)}


def files(root):
    """Every file that users copy, with the folder lvsm that it lies in."""
    for folder, _ in LANGUAGES.values():
        for path in sorted((pathlib.Path(root) / folder).rglob("*.*")):
            yield path, pathlib.Path(root) / folder


def needs(path, folder):
    """What a file includes and these include in turn, each after what it needs itself: the order in which to paste.

    WGSL includes nothing, and a file needs what it does in GLSL, but for what asks GLSL ES for highp; a pass that has all
    of its entry points in one file needs what it does in HLSL, where they are, too."""
    if path.suffix == ".wgsl":
        own = path.relative_to(folder)
        suffixes = ([".hlsl"] if "@compute" in path.read_text() else []) + [".glsl", ".comp", ".frag"]
        roots = [folder.parents[1] / LANGUAGES["HLSL" if suffix == ".hlsl" else "GLSL"][0] for suffix in suffixes]
        twins = [(root / own.with_suffix(suffix), root) for root, suffix in zip(roots, suffixes)]
        found = next((needs(twin, root) for twin, root in twins if twin.exists()), [])
        return [name for name in found if name not in ("sampling/highp", own.with_suffix("").as_posix())]
    found = []
    for bracket, name in re.findall(r'^#include ([<"])([^>"]+)', path.read_text(), re.MULTILINE):
        if bracket == "<":
            found += ["GLM"] if name.startswith("glm/") else []
            continue
        included = (path.parent / name).resolve()
        stem = included.relative_to(folder.resolve()).with_suffix("").as_posix()
        found += ([] if stem == UMBRELLA else needs(included, folder)) + [stem]
    return list(dict.fromkeys(found))


def host_alone(root):
    """The topics of C++ alone."""
    def says_so(topic):
        comment = re.match(r"(?://[^\n]*\n|\n)*", source(root, "C++", topic).read_text()).group()
        return topic != UMBRELLA and HOST_ALONE in comment

    return {topic for topic in topics(root, "C++") if says_so(topic)}


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def file_scope(text):
    """The text with each body as `{}` and no comments, the doc comments, each of which `@NUMBER@` stands for, and the
    bodies in their order."""
    docs = []

    def keep(match):
        docs.append(" ".join(line.strip().lstrip("/").strip() for line in match.group().splitlines()))
        return f"@{len(docs) - 1}@\n"

    text = re.sub(r"(?:^///[^\n]*\n)+", keep, text, flags=re.MULTILINE)
    text = re.sub(r"\s*=\s*\{\}", "", text)  # default arguments
    text = re.sub(r"\bnamespace lvsm\s*\{(.*)\}", r"\1", without_comments(text), flags=re.DOTALL)
    flat, bodies, depth = [], [], 0
    for character in text:
        depth -= character == "}"
        if depth == 0:
            flat.append(character)
            if character == "{":
                bodies.append("")
        else:
            bodies[-1] += character
        depth += character == "{"
    return "".join(flat), docs, bodies


def declarations(root, language, topic):
    """What a file declares at its scope, in its order, but for namespace detail."""
    flat, docs, bodies = file_scope(read(root, language, topic))
    flat = re.sub(r"^\s*#(?:[^\n]*\\\n)*.*", "", flat, flags=re.MULTILINE)
    found, at, bodies = [], 0, iter(bodies)
    while flat[at:].strip():
        match = re.compile(r"\s*(?:@(?P<doc>\d+)@)?(?P<text>[^@;{}]*)(?P<end>\{\}\s*;?|;)").match(flat, at)
        if not match:
            raise ValueError(f"a part that the mirror cannot read: {' '.join(flat[at:].split())[:60]}")
        at = match.end()
        body = next(bodies) if match["end"] != ";" else None
        words = " ".join(match["text"].split())
        if words != "namespace detail":
            found.append(Declaration(words, body, canonical_doc(docs[int(match["doc"])]) if match["doc"] else ""))
    return found


def canonical_type(text):
    written = text
    text = re.sub(r"\bT\b", "float", text)
    if re.fullmatch(r"(const )?float\*", text):
        return "float[]" if text.startswith("const") else "inout float[]"
    if text.endswith("&") and not text.startswith("const "):
        text = "inout " + text
    text = re.sub(r"^const |&$", "", text).strip()
    text = re.sub(r"\bstd::uint32_t\b", "uint", text)
    text = re.sub(r"glm::vec<(\d), (\w+)(?:, \w+)?>", r"\2\1", text)
    text = re.sub(r"(?:glm::)?\b([iu]?)vec(\d)\b", lambda m: {"i": "int", "u": "uint", "": "float"}[m[1]] + m[2], text)
    text = re.sub(r"\b(?:lvsm_)?([A-Z]\w*)(?:<[^<>]*>)?", r"\1", text)  # a struct of the library
    if not re.fullmatch(r"(inout )?((float|u?int|bool)\d?|[A-Z]\w*)(\[\])?|void", text):
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


def is_constant(text):
    return re.match(r"(template <[^<>]*> )?((inline|static) )*const(expr)? [^()]*=", text) or re.match(
        r"(template <[^<>]*> )?((inline|static) )*const(expr)? [\w:]+ \w+(\[[^\]]*\])*$", text)


def type_name(text):
    match = re.match(r"(?:template <.*?> )?(?:struct|class|enum class|enum|union|using|typedef) (\w+)", text)
    return match and match[1]


def without_template(text):
    """The parameters of a template, and the text after them."""
    if not text.startswith("template <"):
        return "", text
    depth = 0
    for i, character in enumerate(text):
        depth += (character == "<") - (character == ">")
        if character == ">" and depth == 0:
            return text[len("template <"):i], text[i + 1:].strip()
    raise ValueError(f"a template that the mirror cannot read: {text}")


def parse_function(declaration, canonical):
    template, text = without_template(declaration.text)
    text = re.sub(r"\[\[.*?\]\]", "", text)
    match = re.fullmatch(r"(?P<result>[\w:][\w:<>,*& ]*?)\s+(?P<name>\w+)\((?P<parameters>.*?)\)"
                         r"(?:\s*noexcept(?:\(.*\))?)?(?:\s*->\s*(?P<trailing>.+))?", text)
    if not match or match["result"] == "auto" and not match["trailing"]:
        raise ValueError(f"a declaration that the mirror cannot read: {declaration.text}")
    result = match["trailing"] or re.sub(r"\b(inline|constexpr|static) ", "", match["result"])
    parameters = split_parameters(match["parameters"])
    return Function(
        name=match["name"].removeprefix("lvsm_"),
        result=canonical_type(result) if canonical else result,
        parameters=[canonical_parameter(p) for p in parameters] if canonical else [],
        doc=declaration.doc,
        template=template,
        declaration=(result, match["name"], parameters))


def functions(root, language, topic, canonical=True):
    """The public functions of a topic in the order of the file. Not canonical: as written, for files of host types.

    Shaders have no namespace for what is internal: there a function with a // comment in place of /// is a helper, and
    likewise a type.
    """
    return [parse_function(declaration, canonical) for declaration in declarations(root, language, topic)
            if not is_constant(declaration.text) and not type_name(declaration.text)
            and (language == "C++" or declaration.doc)]


def types(root, language, topic, canonical=True):
    """The public types of a topic in the order of the file."""
    found = []
    for declaration in declarations(root, language, topic):
        name = type_name(declaration.text)
        if name and (language == "C++" or declaration.doc):
            members = without_comments(declaration.body or "").split(";") if canonical else []
            found.append(Type(name.removeprefix("lvsm_"),
                              [canonical_parameter(" ".join(m.split())) for m in members if m.strip()], declaration.doc))
    return found


def constants(root, language, topic):
    """The values of a topic's constants, rounded to float, by canonical name."""
    text = file_scope(read(root, language, topic))[0]
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
