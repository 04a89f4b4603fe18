#!/usr/bin/env python3
"""`conan create` with the system's GLM, and a project that takes the package:  conan.py FOLDER BUILT

FOLDER: of this test's own; Conan is put there first, from PyPI. Status 77 says that it cannot be had. BUILT: the build
folder; where it holds lvsm.mjs this machine can make it, and so the package has to hold it.
"""
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).parent
# The GLM that CMake finds on this machine stands for any version that Conan may ask for.
PROFILE = "include(default)\n[platform_requires]\nglm/1.0.0\n"

folder = pathlib.Path(sys.argv[1]).resolve()
packages, requirements = folder / "packages", HERE / "conan/requirements.txt"
stamp = packages / "requirements.txt"
if not stamp.exists() or stamp.read_text() != requirements.read_text():
    shutil.rmtree(folder, ignore_errors=True)
    pip = subprocess.run([sys.executable, "-m", "pip", "install", "-q", "--disable-pip-version-check", "--no-deps",
                          "--target", packages, "-r", requirements])
    if pip.returncode != 0:
        print("skipped: pip cannot fetch Conan")
        sys.exit(77)
    shutil.copy(requirements, stamp)

# Conan builds in the folder of the test project, and keeps its packages in its home.
for name in ("conan", "project", "home"):
    shutil.rmtree(folder / name, ignore_errors=True)
for name in ("conan", "project"):
    shutil.copytree(HERE / name, folder / name)
environment = {**os.environ, "PYTHONPATH": str(packages), "CONAN_HOME": str(folder / "home")}


def conan(*words):
    command = [sys.executable, "-c", "import sys; from conan.cli.cli import main; main(sys.argv[1:])", *map(str, words)]
    if subprocess.run(command, env=environment, cwd=folder).returncode != 0:
        sys.exit(1)


conan("profile", "detect")
(folder / "profile").write_text(PROFILE)
conan("create", ROOT, "--profile:all", folder / "profile", "--test-folder", folder / "conan", "--no-remote")
if (pathlib.Path(sys.argv[2]) / "wasm/lvsm.mjs").exists():
    for name in ("lvsm.mjs", "lvsm.d.mts"):
        if not list((folder / "home/p").glob(f"**/p/share/lvsm/host/{name}")):
            sys.exit(f"the package lacks {name}")
