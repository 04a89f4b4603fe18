#!/usr/bin/env python3
"""The rows in Panda3D, a game engine:  panda3d_rows.py FOLDER SINGLE

FOLDER: where `lvsm_client_rows write` has put them. SINGLE: of the one-file versions, on the engine's search path: its own
preprocessor includes the unchanged lvsm_all.glsl by `#pragma include`.
"""
import array
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import pypi  # noqa: E402

pypi.add("panda3d", ["panda3d==1.10.16"])
try:
    import panda3d.core as p3d
except (ImportError, OSError) as error:
    pypi.skip(f"cannot load Panda3D: {error}")

folder, single = map(pathlib.Path, sys.argv[1:])
INPUTS_PER_ROW, WORDS, TARGETS = 64, 24, 3
BLUE_FIRST = (2, 1, 0, 3)  # as the engine keeps pixels
VERTEX = "#version 330\nin vec4 p3d_Vertex;\nvoid main() { gl_Position = vec4(p3d_Vertex.xz * 2.0 - 1.0, 0.0, 1.0); }\n"
SETTINGS = f"""load-display p3headlessgl
gl-version 3 3
textures-power-2 none
notify-level-display error
notify-level-egldisplay error
model-path {single.resolve()}
"""


class Screen:
    """Draws a shader over three targets of 32-bit floats, an input's results a pixel."""

    def __init__(self, height):
        properties = p3d.FrameBufferProperties()
        properties.set_float_color(True)
        properties.set_rgba_bits(32, 32, 32, 32)
        properties.set_aux_float(TARGETS - 1)
        self.height = height
        self.engine = p3d.GraphicsEngine.get_global_ptr()
        pipe = p3d.GraphicsPipeSelection.get_global_ptr().make_default_pipe()
        off_screen = p3d.GraphicsPipe.BF_refuse_window
        host = pipe and self.engine.make_output(pipe, "host", 0, p3d.FrameBufferProperties.get_default(),
                                                p3d.WindowProperties.size(1, 1), off_screen)
        size = p3d.WindowProperties.size(INPUTS_PER_ROW, height)
        self.output = host and self.engine.make_output(pipe, "rows", 0, properties, size, off_screen, host.gsg, host)
        if not self.output:
            pypi.skip("Panda3D has no such target")
        places = [p3d.GraphicsOutput.RTP_color, p3d.GraphicsOutput.RTP_aux_float_0, p3d.GraphicsOutput.RTP_aux_float_1]
        self.targets = [p3d.Texture(f"results{i}") for i in range(TARGETS)]
        for place, texture in zip(places, self.targets):
            self.output.add_render_texture(texture, p3d.GraphicsOutput.RTM_copy_ram, place)
        card = p3d.CardMaker("card")
        card.set_frame(0, 1, 0, 1)
        self.scene = p3d.NodePath(card.generate())
        self.scene.node().set_bounds(p3d.OmniBoundingVolume())
        self.scene.node().set_final(True)
        camera = p3d.Camera("camera", p3d.OrthographicLens())
        camera.set_scene(self.scene)
        self.output.make_display_region().set_camera(p3d.NodePath(camera))

    def draw(self, fragment, words):
        """The four numbers of each pixel, for each target."""
        inputs = p3d.Texture("inputs")
        inputs.setup_2d_texture(INPUTS_PER_ROW * WORDS // 4, self.height, p3d.Texture.T_unsigned_int, p3d.Texture.F_rgba32i)
        inputs.set_ram_image(words)
        inputs.set_minfilter(p3d.SamplerState.FT_nearest)
        inputs.set_magfilter(p3d.SamplerState.FT_nearest)
        shader = p3d.Shader.make(p3d.Shader.SL_GLSL, VERTEX, fragment)
        self.scene.set_shader(shader)
        self.scene.set_shader_input("lvsm_inputs", inputs)
        self.engine.render_frame()
        return [array.array("f", texture.get_ram_image().get_data()) for texture in self.targets]


def main():
    p3d.load_prc_file_data("", SETTINGS)
    rows = json.loads((folder / "rows.json").read_text())
    screen = Screen(rows[0]["inputs"] // INPUTS_PER_ROW)
    for row in rows:
        words = (folder / f"{row['function']}.inputs").read_bytes()
        results = array.array("f", bytes(4 * row["numbers"] * row["inputs"]))
        for first in range(0, row["numbers"], 4 * TARGETS):
            fragment = f'#version 330\n#pragma include "lvsm_all.glsl"\n#define FIRST {first}\n{row["kernel"]}'
            for target, pixels in enumerate(screen.draw(fragment, words)):
                for c in range(min(4, row["numbers"] - first - 4 * target)):
                    results[first + 4 * target + c::row["numbers"]] = pixels[BLUE_FIRST[c]::4]
        (folder / f"{row['function']}.results").write_bytes(results.tobytes())
    gsg = screen.output.get_gsg()
    (folder / "version").write_text(f"Panda3D {p3d.PandaSystem.version_string}, {gsg.get_driver_renderer()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
