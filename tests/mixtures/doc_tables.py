"""What docs/mixtures.md shows, from the recorded output of lvsm_mixture_windows and lvsm_mixture_figures."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import importlib.util

spec = importlib.util.spec_from_file_location("mixtures_recorded", pathlib.Path(__file__).resolve().parent / "recorded.py")
mixtures = importlib.util.module_from_spec(spec)
spec.loader.exec_module(mixtures)

TABLES = {"mixtures.windows": lambda: mixtures.tables("windows.txt")[0],
          "mixtures.width7": lambda: mixtures.tables("figures.txt")[0],
          "mixtures.width15": lambda: mixtures.tables("figures.txt")[1]}
NAMES = {"mixture_rmse": mixtures.rmse}
