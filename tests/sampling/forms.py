#!/usr/bin/env python3
"""Makes the other forms of the sampling wrappers from glsl/lvsm/sampling/combined; without --write, fails where one is
not what it would make.

In GLSL with textures and samplers apart, a sampler follows the maps, in parameters and in calls of lvsm functions, and
the built-ins join the two. HLSL is that with other words, and with a function for each type that the map may have, which
its comment says: "map: of 1 component or more", "of 2 components or more" or "of 4 components"; maps "of codes" are of
whole numbers, and need no sampler there. HLSL's maps.hlsli alone
is written by hand, since built-ins have other arguments there; its comments have to agree.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLING = ROOT / "glsl/lvsm/sampling"
HLSL = ROOT / "hlsl/lvsm/sampling"
WIDTH = 120
WORDS = {"mix": "lerp", "fract": "frac", "texture2D": "Texture2D", "texture2DArray": "Texture2DArray",
         "textureCube": "TextureCube", "utexture2D": "Texture2D", "utexture2DArray": "Texture2DArray",
         "glsl": "hlsli", "GLSL": "HLSLI"}
COMPONENTS = {"of 1 component or more": ["float", "float2", "float4"],
              "of 2 components or more": ["float2", "float4"], "of 4 components": ["float4"],
              "of codes of 64 bits": ["uint2"], "of codes of 128 bits": ["uint4"]}
FUNCTION = re.compile(r"(?:^//[^\n]*\n)*^\w[^\n;{}]*\((?:[^;{}]*)\)\n\{\n.*?^\}\n", re.MULTILINE | re.DOTALL)
MAP = re.compile(r"LVSM_HIGHP (u?)sampler(\w+) (\w+)")


def wrapped(line):
    """A line of code broken at its outermost commas, each part below what follows the parenthesis that it is in."""
    parts, column = [], None
    while len(line) > WIDTH:
        opened, commas = [] if column is None else [column], []
        for at, character in enumerate(line[:WIDTH - 1]):
            if character == "(":
                opened.append(at + 1)
            elif character == ")":
                opened.pop()
            elif character == "," and opened:
                commas.append((-len(opened), at + 1, opened[-1]))
        _, at, column = max(commas)
        parts.append(line[:at])
        line = " " * column + line[at + 1:]
    return parts + [line]


def rewrapped(function):
    lines, whole = [], ""
    for line in function.splitlines():
        if line.lstrip().startswith("//"):
            lines.append(line)
            continue
        whole = f"{whole} {line.strip()}" if whole else line
        if whole.count("(") == whole.count(")"):
            lines += wrapped(whole)
            whole = ""
    return "\n".join(lines) + "\n"


def separate_function(function):
    maps = {name: f"{unsigned}sampler{kind}" for unsigned, kind, name in MAP.findall(function)}
    if not maps:
        return function
    names = "|".join(maps)
    function = re.sub(rf"\b(lvsm_\w+\((?:(?:{names})(?:, )?)+(?<!, ))(?=[,)])", r"\1, filtering", function)
    function = re.sub(rf"\b(texture\w+|texelFetch)\(({names}),",
                      lambda m: f"{m[1]}({maps[m[2]]}({m[2]}, filtering),", function)
    function = re.sub(rf"({MAP.pattern}(?:,\s+{MAP.pattern})*)", r"\1, sampler filtering", function, count=1)
    return rewrapped(MAP.sub(r"\1texture\2 \3", function))


def separate(text):
    text = re.sub(r"^#if __VERSION__[^\n]*\n(.*?)^#else\n.*?^#endif\n", r"\1", text, flags=re.MULTILINE | re.DOTALL)
    return FUNCTION.sub(lambda m: separate_function(m[0]), text.replace("COMBINED", "SEPARATE").replace("sampling/combined", "sampling/separate"))


def hlsl_functions(function):
    """The function for each type of map; only the first has the comment."""
    kinds = [types for phrase, types in COMPONENTS.items() if f"map: {phrase}" in function]
    function = re.sub(r"(lvsm_map\w*Size\(\w+), filtering", r"\1", function)
    if "map: of codes" in function:
        function = re.sub(r", (SamplerState )?filtering\b", "", function)
    if not kinds:
        return rewrapped(function)
    copies = [re.sub(r"\b(Texture\w+) (?=\w+[,)])", rf"\1<{type_}> ", function) for type_ in kinds[0]]
    return "\n".join(rewrapped(copy if i == 0 else re.sub(r"^//.*\n", "", copy, flags=re.MULTILINE))
                     for i, copy in enumerate(copies))


def hlsl(text):
    def word(match):
        vector = re.fullmatch(r"([iu]?)vec([234])", match[0])
        types = {"": "float", "i": "int", "u": "uint"}
        return types[vector[1]] + vector[2] if vector else WORDS.get(match[0], match[0])

    # HLSL has no precision to ask for.
    text = text.replace('#include "highp.glsl"\n\n', "").replace("sampling/highp, ", "")
    text = text.replace("Needs: sampling/highp.", "Needs: no other.")
    text = re.sub(r"^const ", "static const ", text, flags=re.MULTILINE)
    text = re.sub(r"[A-Za-z0-9]+", word, text.replace("sampler filtering", "SamplerState filtering"))
    return FUNCTION.sub(lambda m: hlsl_functions(m[0]), text)


def forms():
    yield HLSL / "common.hlsli", hlsl((SAMPLING / "common.glsl").read_text())
    for source in sorted((SAMPLING / "combined").glob("*.glsl")):
        made = separate(source.read_text())
        yield SAMPLING / "separate" / source.name, made
        if source.stem != "maps":
            yield HLSL / f"separate/{source.stem}.hlsli", hlsl(made)


def docs_of(path):
    """The doc comment of each function; HLSL's copies for other types have none."""
    return dict(re.findall(r"((?:^///[^\n]*\n)+)\w+ (\w+)\(", path.read_text(), re.MULTILINE))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    write = parser.parse_args().write
    differing = [(path, text) for path, text in forms() if not path.exists() or path.read_text() != text]
    for path, text in differing:
        if write:
            path.write_text(text)
        print(f"{path} {'written' if write else 'is not what is made of combined/: tests/sampling/forms.py --write'}")
    docs_agree = docs_of(HLSL / "separate/maps.hlsli") == docs_of(SAMPLING / "combined/maps.glsl")
    if not docs_agree:
        print("the comments in HLSL's maps.hlsli are not those of combined/maps.glsl")
    return 0 if docs_agree and (write or not differing) else 1


if __name__ == "__main__":
    sys.exit(main())
