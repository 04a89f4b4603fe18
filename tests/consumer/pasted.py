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


def failures(language, pasted, options):
    """The topics whose file does not compile; pasted: the file of each."""
    if language == "WGSL":
        # At once: its compiler takes longer to start than for all of them. It says which it was.
        commands = {"see above": [ROOT / "tests/support/wgsl", "compile", *pasted.values()]}
    else:
        commands = {topic: [sys.executable, ROOT / "tests/compile/shaders.py", language, topic, TARGET[language],
                            "--single", path, *options] for topic, path in pasted.items()}
    statuses = {topic: subprocess.run(command).returncode for topic, command in commands.items()}
    if 77 in statuses.values():
        sys.exit(77)
    return [topic for topic, status in statuses.items() if status != 0]


def main():
    way, language, *options = sys.argv[1:]
    topics = sorted(lvsm_api.topics(ROOT, language) - {lvsm_api.UMBRELLA})
    with tempfile.TemporaryDirectory() as folder:
        pasted = {topic: pathlib.Path(folder) / topic for topic in topics}
        for topic, path in pasted.items():
            {"by_hand": by_hand, "one_file": one_file}[way](language, topic, path)
        failed = failures(language, pasted, options)
    print(f"{len(topics)} topics pasted, failed: {', '.join(failed) or 'none'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
