"""What docs/mixtures.md shows, from the recorded output of lvsm_mixture_windows."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import importlib.util

spec = importlib.util.spec_from_file_location("mixtures_recorded", pathlib.Path(__file__).resolve().parent / "recorded.py")
mixtures = importlib.util.module_from_spec(spec)
spec.loader.exec_module(mixtures)

TABLES = {"mixtures.windows": lambda: mixtures.tables("windows.txt")[0]}
