"""docs/choose.html: page.html with the recorded errors and costs in it, for its script to choose from."""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "quality"))
import choose  # noqa: E402
import recorded  # noqa: E402

WIDTHS = ("3", "7", "15", "25")


def technique(t, width):
    """What the page knows of a technique: errors, and what a lit pixel and a texel of the shadow map cost."""
    scenes = {scene: recorded.rmse(t["name"], scene, width) for scene in recorded.technique_scenes()}
    worst = max(scenes, key=scenes.get)
    return {"name": t["name"], "peer": t["peer"], "bits": t["texel_bits"], "filtered": t["filtered"],
            "error": choose.error_of(t), "worst": round(scenes[worst], 4), "scene": worst, "pixel": t["cost"],
            "texel": t["map_cost"], "bytes": t["map_bytes"]}


def page():
    runs = [f'"{width}": [\n' + ",\n".join(json.dumps(technique(t, width)) for t in choose.techniques(width)) + "\n]"
            for width in WIDTHS]
    head = json.dumps({"target": choose.TARGET, "compiler": json.loads(choose.COSTS.read_text())["compiler"],
                       "seed": recorded.whole()["seed"]})
    data = head[:-1] + ', "runs": {\n' + ",\n".join(runs) + "\n}}"
    return (HERE / "page.html").read_text().replace("<!-- the recorded figures -->", data)


FILES = {"docs/choose.html": page}
