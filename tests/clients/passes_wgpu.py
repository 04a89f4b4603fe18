#!/usr/bin/env python3
"""The sampling wrappers and the ready passes in wgpu, by naga, on each of its devices, compared with C++:
passes_wgpu.py FOLDER SINGLE KERNELS JUDGE

FOLDER: of this test's own. JUDGE: the program lvsm_web.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import wgpu_device  # noqa: E402

wgpu = wgpu_device.load()
TEXEL = 16


class Player:
    """One method for each kind of command in the script."""

    def __init__(self, device, data):
        self.device, self.data = device, data
        self.textures, self.pipelines, self.buffers, self.reads = [], [], [], []
        self.sampler = device.create_sampler(mag_filter="linear", min_filter="linear")

    def levels(self, texture):
        """Each level's number, size, and bytes."""
        for level in range(texture["levels"]):
            width, height = max(texture["width"] >> level, 1), max(texture["height"] >> level, 1)
            yield level, (width, height, texture["slices"]), TEXEL * width * height * texture["slices"]

    def texture(self, command):
        usage = wgpu.TextureUsage
        made = self.device.create_texture(
            size=(command["width"], command["height"], command["slices"]), mip_level_count=command["levels"],
            format="rgba32uint" if command["words"] else "rgba32float",
            usage=usage.COPY_SRC | usage.COPY_DST | usage.TEXTURE_BINDING | usage.STORAGE_BINDING)
        at = command["at"]
        for level, size, count in self.levels(command):
            self.device.queue.write_texture({"texture": made, "mip_level": level}, self.data[at:at + count],
                                            {"bytes_per_row": TEXEL * size[0], "rows_per_image": size[1]}, size)
            at += count
        self.textures.append((command, made))

    def program(self, command):
        module = self.device.create_shader_module(code=command["text"])
        pipeline = self.device.create_compute_pipeline(
            layout="auto", compute={"module": module, "entry_point": command["entry"]})
        self.pipelines.append((pipeline, re.search(r"^[^/\n]*: sampler;", command["text"], re.MULTILINE)))

    def view(self, number, level):
        command, made = self.textures[number]
        levels = {} if level < 0 else {"base_mip_level": level, "mip_level_count": 1}
        return made.create_view(dimension="2d-array" if command["array"] else "2d", **levels)

    def buffer(self, command):
        usage = wgpu.BufferUsage
        data = self.data[command["at"]:command["at"] + command["bytes"]]
        self.buffers.append(self.device.create_buffer_with_data(data=data, usage=usage.STORAGE | usage.COPY_SRC))

    def readBuffer(self, command):  # as the script calls it
        self.reads.append(bytes(self.device.queue.read_buffer(self.buffers[command["buffer"]])))

    def run(self, command):
        pipeline, filters = self.pipelines[command["program"]]
        bound = {binding: {"buffer": self.buffers[number]} for binding, number in command["buffers"]}
        if "target" in command:
            target, _, level = command["target"]
            bound[1] = self.view(target, level)
        for _, binding, texture, only in command["sources"]:
            bound[binding] = self.view(texture, only)
        for _, binding, at, size in command["blocks"]:
            buffer = self.device.create_buffer_with_data(data=self.data[at:at + size], usage=wgpu.BufferUsage.UNIFORM)
            bound[binding] = {"buffer": buffer}
        if filters:
            bound[3] = self.sampler
        group = self.device.create_bind_group(
            layout=pipeline.get_bind_group_layout(0),
            entries=[{"binding": binding, "resource": resource} for binding, resource in bound.items()])
        encoder = self.device.create_command_encoder()
        compute = encoder.begin_compute_pass()
        compute.set_pipeline(pipeline)
        compute.set_bind_group(0, group)
        compute.dispatch_workgroups(*command["groups"])
        compute.end()
        self.device.queue.submit([encoder.finish()])

    def read(self, command):
        described, made = self.textures[command["texture"]]
        for level, size, _ in self.levels(described):
            texels = self.device.queue.read_texture({"texture": made, "mip_level": level},
                                                    {"bytes_per_row": TEXEL * size[0], "rows_per_image": size[1]}, size)
            self.reads.append(bytes(texels))


def play(adapter, folder):
    device = adapter.request_device_sync(required_features=["float32-filterable"])
    player = Player(device, (folder / "script.data").read_bytes())
    for command in json.loads((folder / "script.json").read_text()):
        getattr(player, command["do"])(command)
    (folder / "results").write_bytes(b"".join(player.reads))


def main():
    folder, single, kernels, judge = sys.argv[1:]
    pathlib.Path(folder).mkdir(exist_ok=True)
    words = ["wgsl", folder, "--single", single, "--kernels", kernels]
    subprocess.run([judge, "write", *words], check=True)
    status = 0
    for adapter in wgpu_device.adapters(wgpu):
        print(f"wgpu {wgpu.__version__}, {adapter.info['device']}", flush=True)
        play(adapter, pathlib.Path(folder))
        status |= subprocess.run([judge, "judge", *words]).returncode
    return status


if __name__ == "__main__":
    sys.exit(main())
