"""The library's own constants, for the figures of documents."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import lvsm_api  # noqa: E402


def constant(topic, name):
    return lvsm_api.constants(ROOT, "C++", topic)[name]


NAMES = {"constant": constant}
