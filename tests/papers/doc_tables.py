"""The papers' claims beside our figures, as tests/docs/documents.py shows them."""
import importlib.util
import json
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
spec = importlib.util.spec_from_file_location("papers_recorded", HERE / "recorded.py")
recorded = importlib.util.module_from_spec(spec)
spec.loader.exec_module(recorded)
ROWS = recorded.claims.rows(recorded.values())


def agreement(row):
    if row["agrees"] is None:
        return "not reproduced"
    return f"{'yes' if row['agrees'] else '**no**'}: `{row['criterion']}`"


def table(paper):
    def lines():
        cells = [[row["item"], row["claim"], row["theirs"], row["ours"], agreement(row), row["why"]]
                 for row in ROWS if row["paper"] == paper.NAME]
        return [["item", "claim", "theirs", "ours", "agrees, if", "why"], *cells]

    return lines


def count(agrees, paper=None):
    return sum(row["agrees"] is agrees for row in ROWS if paper in (None, row["paper"]))


def run():
    made_on = recorded.whole()["run"]["run"]
    return [list(made_on), [str(value) for value in made_on.values()]]


TABLES = {"papers.run": run,
          **{f"papers.{paper.__name__.removeprefix('claims_')}": table(paper) for paper in recorded.claims.papers()}}
NAMES = {"claims": count}
# For the gallery, which shows them.
FILES = {"docs/papers.json": lambda: json.dumps(ROWS, indent=1) + "\n"}
