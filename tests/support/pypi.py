"""Packages of PyPI that no Debian package has, pinned, fetched with pip once for each version of Python."""
import fcntl
import os
import pathlib
import shutil
import subprocess
import sys

UNAVAILABLE = 77


def skip(message):
    """Exit status 77: a test that meets it is skipped."""
    print(f"skipped: {message}", file=sys.stderr)
    sys.exit(UNAVAILABLE)


def add(name, packages):
    """Puts the folder of the packages on Python's path and returns it: in $XDG_CACHE_HOME/lvsm-NAME."""
    cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / f"lvsm-{name}"
    folder = cache / "-".join([f"python{sys.version_info[0]}.{sys.version_info[1]}", *packages])
    try:
        cache.mkdir(parents=True, exist_ok=True)
        with open(cache / "lock", "w") as lock:  # several tests may start at once
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not folder.exists():
                partial = cache / "partial"
                shutil.rmtree(partial, ignore_errors=True)
                subprocess.run([sys.executable, "-m", "pip", "install", "-q", "--disable-pip-version-check", "--no-deps",
                                "--only-binary", ":all:", "--target", partial, *packages],
                               check=True, stdout=sys.stderr, env={**os.environ, "PIP_ROOT_USER_ACTION": "ignore"})
                partial.rename(folder)
    except (OSError, subprocess.SubprocessError) as error:
        skip(f"cannot get {name}: {error}")
    sys.path.insert(0, str(folder))
    return folder
