#!/usr/bin/env python3
"""Takes each topic as a user without #include does, and compiles a program that calls its every function.

by_hand: the files that the topic's third line names, pasted in its order, without their #include lines.
one_file: what cmake/single_file.cmake makes of the topic.
    pasted.py by_hand|one_file GLSL|HLSL|WGSL [SHADERS.PY OPTION...]

WGSL's compiler looks at every function without being called.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import lvsm_api  # noqa: E402

TARGET = {"GLSL": "330", "HLSL": "ps_6_0_glslang"}


def by_hand(language, topic, path):
    third = lvsm_api.source(ROOT, language, topic).read_text().splitlines()[2]
    names = re.fullmatch(r"// Needs: (.*)\.", third)[1].split(", ")
    files = [lvsm_api.source(ROOT, language, name) for name in names if name != "no other"]
    files.append(lvsm_api.source(ROOT, language, topic))
    path.write_text("".join(re.sub(r"^#include.*\n", "", file.read_text(), flags=re.MULTILINE) for file in files))


def one_file(language, topic, path):
    subprocess.run(["cmake", "-D", f"SOURCE={lvsm_api.source(ROOT, language, topic)}", "-D", f"OUTPUT={path}",
                    "-P", ROOT / "cmake/single_file.cmake"], check=True)


def compiled(language, topic, path, options):
    """The status of the compiler."""
    if language == "WGSL":
        return subprocess.run([ROOT / "tests/support/wgsl", "compile", path]).returncode
    return subprocess.run([sys.executable, ROOT / "tests/compile/shaders.py", language, topic, TARGET[language], "--single",
                           path, *options]).returncode


def main():
    way, language, *options = sys.argv[1:]
    topics = sorted(lvsm_api.topics(ROOT, language) - {lvsm_api.UMBRELLA})
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "pasted"
        for topic in topics:
            {"by_hand": by_hand, "one_file": one_file}[way](language, topic, path)
            status = compiled(language, topic, path, options)
            if status == 77:
                return 77
            failed += [topic] if status != 0 else []
    print(f"{len(topics)} topics pasted, failed: {', '.join(failed) or 'none'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
