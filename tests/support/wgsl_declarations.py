"""The declarations of a WGSL file in the words of GLSL, which lvsm_api.py reads; bodies stay as they are."""
import re

WORDS = {"f32": "float", "i32": "int", "u32": "uint", "f": "", "i": "i", "u": "u"}
# Macros in the other languages.
MACROS = re.compile(r"^const (LVSM_VERSION|LVSM_MAX_LAYERS): \w+ = (\w+);", re.MULTILINE)
CONSTANT = re.compile(r"^const (\w+): (\w+)", re.MULTILINE)
FUNCTION = re.compile(r"^fn (\w+)\(([^{}]*)\)(?: -> (\w+))?\n\{", re.MULTILINE)
MEMBER = re.compile(r"^    (\w+: [^\n]*),$", re.MULTILINE)


def type_of(text):
    text = re.sub(r"\bvec(\d)([fiu])\b", lambda m: f"{WORDS[m[2]]}vec{m[1]}", text)
    return re.sub(r"\b[fiu]32\b", lambda m: WORDS[m[0]], text)


def variable(text):
    """`float splits[8]` for `splits: array<f32, 8>`."""
    name, type_ = " ".join(text.split()).split(": ", 1)
    pointer = re.fullmatch(r"ptr<function, (.*)>", type_)
    type_ = pointer[1] if pointer else type_
    array = re.fullmatch(r"array<(\w+), (.*)>", type_)
    return type_of(("inout " if pointer else "") + (f"{array[1]} {name}[{array[2]}]" if array else f"{type_} {name}"))


def function(match):
    parameters = [variable(p) for p in re.split(r",\s+(?=\w+: )", match[2]) if p]
    return f"{type_of(match[3] or 'void')} {match[1]}({', '.join(parameters)})\n{{"


def glsl_of_wgsl(text):
    text = MACROS.sub(r"#define \1 \2", text)
    text = CONSTANT.sub(lambda m: f"const {type_of(m[2])} {m[1]}", text)
    return MEMBER.sub(lambda m: f"    {variable(m[1])};", FUNCTION.sub(function, text))
