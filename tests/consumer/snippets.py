#!/usr/bin/env python3
"""Compiles the code that a document shows:  snippets.py DOCUMENT --include FOLDER... --cxx COMPILER --dxc DXC

In Markdown the blocks fenced as ```cpp, ```glsl, ```hlsl and ```wgsl; in an umbrella file those under a line `// C++`,
`// GLSL`, `// HLSL` or `// WGSL`. WGSL, and GLSL that includes nothing, stand after the one-file version. C++ statements stand in a function, after
the names of snippet_names.hpp; a shader gets a #version and an empty main where it has none.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LANGUAGES = {"C++": "cpp", "GLSL": "glsl", "HLSL": "hlsl", "WGSL": "wgsl"}


def snippets(document):
    """Yields (language, code)."""
    text = document.read_text()
    if document.suffix == ".md":
        yield from re.findall(r"^```(cpp|glsl|hlsl|wgsl)\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        return
    manual = re.match(r"(//.*\n)+", text).group()
    parts = re.split(r"^// (C\+\+|GLSL|HLSL|WGSL)\n", manual, flags=re.MULTILINE)[1:]
    for heading, part in zip(parts[::2], parts[1::2]):
        yield LANGUAGES[heading], re.sub(r"^// {0,3}", "", part, flags=re.MULTILINE)


def program(language, code, pasted):
    if language == "cpp":
        if "main(" in code:
            return code
        lines = code.splitlines(keepends=True)
        includes = [line for line in lines if line.startswith("#include")]
        names = f'#include "{pathlib.Path(__file__).with_name("snippet_names.hpp")}"\n'
        statements = [line for line in lines if line not in includes]
        return "".join([*includes, names, "void snippet()\n{\n", *statements, "}\n"])
    if language == "glsl":
        end = "" if "main(" in code else "void main() {}\n"
        if "#include" not in code:
            code = (pasted / "lvsm_all.glsl").read_text() + code
        if "#version" not in code:
            code = "#version 450\n#extension GL_GOOGLE_include_directive : require\n" + code
        return code + end
    if language == "wgsl":
        return (pasted / "lvsm_all.wgsl").read_text() + code
    return code if "main(" in code else code + "float4 main() : SV_Target { return float4(0, 0, 0, 0); }\n"


def command(language, options, path, output):
    if language == "cpp":
        glm = ["-isystem", options.glm] if options.glm != "/usr/include" else []
        return [options.cxx, "-std=c++17", "-fsyntax-only", "-Wall", "-Werror", "-Wno-unused-variable",
                f"-I{ROOT / 'include'}", *glm, path]
    if language == "glsl":
        return [options.glslang, "-V", "-S", "frag", *[f"-I{folder}" for folder in options.include], "-o", output, path]
    if language == "wgsl":
        return [str(ROOT / "tests/support/wgsl"), "compile", path]
    return [options.dxc, "-T", "ps_6_0", "-E", "main", *[word for folder in options.include for word in ("-I", folder)], "-Fo",
            output, path]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("document", type=pathlib.Path)
    parser.add_argument("--languages", nargs="+", choices=LANGUAGES.values(), help="of which it must have a snippet")
    parser.add_argument("--include", nargs="+", default=[], help="folders of shader files")
    parser.add_argument("--pasted", type=pathlib.Path, help="the folder of the one-file versions")
    parser.add_argument("--cxx", default="c++")
    parser.add_argument("--glm", default="/usr/include", help="include folder of GLM")
    parser.add_argument("--glslang", default="glslangValidator")
    parser.add_argument("--dxc", default="dxc")
    options = parser.parse_args()

    status, seen = 0, []
    for language, code in snippets(options.document):
        seen.append(language)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / f"snippet.{language}"
            path.write_text(program(language, code, options.pasted))
            words = command(language, options, str(path), folder + "/out")
            if not shutil.which(words[0]):
                print(f"skipped: no {words[0]}")
                return status or 77
            result = subprocess.run(words)
        if result.returncode == 77:
            return 77
        if result.returncode != 0:
            print(f"{options.document}: this {language} snippet does not compile:\n{code}")
            status = 1
    for language in options.languages:
        if language not in seen:
            print(f"{options.document}: no {language} snippet")
            status = 1
    print(f"{len(seen)} snippets: {', '.join(seen)}")
    return status


if __name__ == "__main__":
    sys.exit(main())
