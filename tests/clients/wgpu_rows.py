#!/usr/bin/env python3
"""The rows in wgpu, by naga:  wgpu_rows.py FOLDER wgsl|glsl SINGLE

FOLDER: where `lvsm_client_rows write` has put them. SINGLE: of the one-file versions, which are taken unchanged; GLSL's
naga knows no `precise`, so LVSM_PRECISE is defined empty before it.
"""
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import wgpu_device  # noqa: E402

DEVICE = "llvmpipe"
GROUP = 64


def run(folder, shader, through=""):
    """The status. shader: makes the text of a row; what it cannot is a RuntimeError. through: what the text has gone
    through, and its version."""
    wgpu = wgpu_device.load()
    adapter = next((a for a in wgpu_device.adapters(wgpu) if DEVICE in a.info["device"]), None)
    if not adapter:
        wgpu_device.pypi.skip(f"no {DEVICE}")
    device, status = adapter.request_device_sync(), 0
    for row in json.loads((folder / "rows.json").read_text()):
        name = row["function"]
        words = (folder / f"{name}.inputs").read_bytes()
        try:
            size = 4 * row["numbers"] * row["inputs"]
            results = wgpu_device.run(wgpu, device, shader(row), words, size, row["inputs"] // GROUP)
            (folder / f"{name}.results").write_bytes(results)
        except (RuntimeError, wgpu.GPUError) as error:
            print(f"FAIL {name}: {error}")
            status = 1
    (folder / "version").write_text(f"{through}wgpu {wgpu.__version__}, {adapter.info['device']}")
    return status


def main():
    folder, language, single = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    library = (single / f"lvsm_all.{language}").read_text()

    def shader(row):
        if language == "wgsl":
            return library + row["wgsl"]
        version, kernel = row["compute"].split("\n", 1)
        return f"{version}\n#define LVSM_PRECISE\n{library}{kernel}"

    return run(folder, shader)


if __name__ == "__main__":
    sys.exit(main())
