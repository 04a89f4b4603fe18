#!/usr/bin/env python3
"""A floor of 2^-24 covers what WGSL, which has no `precise`, may make of a flat occluder's variance:  wgsl_floor.py LIBRARY

On each device the variance of 4096 depths whose squares no float holds, with the floor and without, of moments that come out of
memory and of moments from the same expression. With it the floor is what comes out, without it at most the floor.
"""
import array
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import wgpu_device  # noqa: E402

COUNT = 4096
FLOOR = 2.0**-24
KERNEL = """
@group(0) @binding(0) var<storage, read> stored: array<vec2f>;
@group(0) @binding(1) var<storage, read_write> variances: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u)
{
    let memory = stored[id.x];
    let expression = lvsm_depthMoments(memory.x);
    variances[id.x] = vec4f(lvsm_variance(memory, 0x1p-24f), lvsm_variance(expression, 0x1p-24f),
                            lvsm_variance(memory, 0.0), lvsm_variance(expression, 0.0));
}
"""


def main():
    wgpu, library = wgpu_device.load(), pathlib.Path(sys.argv[1]).read_text()
    depths = array.array("f", [(i + 1) / (COUNT + 1) for i in range(COUNT)])
    moments = array.array("f", [x for z in depths for x in (z, array.array("f", [z * z])[0])])
    status = 0
    for adapter in wgpu_device.adapters(wgpu):
        words = wgpu_device.run(wgpu, adapter.request_device_sync(), library + KERNEL, moments.tobytes(), 16 * COUNT, COUNT // 64)
        variances = array.array("f", words)
        floored, plain = [variances[i::4] for i in (0, 1)], [variances[i::4] for i in (2, 3)]
        right = all(v == FLOOR for of in floored for v in of) and all(0.0 <= v <= FLOOR for of in plain for v in of)
        print(f"{'ok  ' if right else 'FAIL'} {adapter.info['device']}: with the floor {max(map(max, floored)):.3g}, without "
              f"{max(plain[0]):.3g} out of memory and {max(plain[1]):.3g} from the same expression, at most")
        status |= not right
    return status


if __name__ == "__main__":
    sys.exit(main())
