"""wgpu's devices, by the package of PyPI: WGSL and GLSL by naga, its compiler, on Vulkan."""
import os
import tempfile

import pypi

# All that is needed for computing; what wgpu names besides is for windows.
PACKAGES = ["wgpu==0.32.0", "cffi==2.1.1", "pycparser==3.0"]
SWIFTSHADER = "/usr/lib/chromium/vk_swiftshader_icd.json"


def load():
    """The module wgpu; exit status 77 where it cannot be had."""
    pypi.add("wgpu", PACKAGES)
    chosen_by_user = {"VK_ADD_DRIVER_FILES", "VK_DRIVER_FILES", "VK_ICD_FILENAMES"} & set(os.environ)
    if not chosen_by_user and os.path.exists(SWIFTSHADER):
        os.environ["VK_ADD_DRIVER_FILES"] = SWIFTSHADER
    os.environ.setdefault("XDG_RUNTIME_DIR", tempfile.gettempdir())  # drivers for windows complain without
    try:
        import wgpu
        from wgpu.backends.wgpu_native.extras import set_instance_extras
    except (ImportError, OSError) as error:
        pypi.skip(f"cannot load wgpu: {error}")
    set_instance_extras(backends=["Vulkan"])
    return wgpu


def adapters(wgpu):
    """At least one; exit status 77 where there is none."""
    found = wgpu.gpu.enumerate_adapters_sync()
    if not found:
        pypi.skip("no Vulkan device")
    return found


def run(wgpu, device, text, words, size, groups):
    """The bytes that the compute shader `main` makes of the words: they are at @group(0) @binding(0), `size` bytes of
    results at @binding(1)."""
    module = device.create_shader_module(code=text, label="comp")  # which tells GLSL's stage
    pipeline = device.create_compute_pipeline(layout="auto", compute={"module": module, "entry_point": "main"})
    inputs = device.create_buffer_with_data(data=words, usage=wgpu.BufferUsage.STORAGE)
    outputs = device.create_buffer(size=size, usage=wgpu.BufferUsage.STORAGE | wgpu.BufferUsage.COPY_SRC)
    entries = [{"binding": i, "resource": {"buffer": buffer}} for i, buffer in enumerate((inputs, outputs))]
    bound = device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=entries)
    encoder = device.create_command_encoder()
    compute = encoder.begin_compute_pass()
    compute.set_pipeline(pipeline)
    compute.set_bind_group(0, bound)
    compute.dispatch_workgroups(groups)
    compute.end()
    device.queue.submit([encoder.finish()])
    return bytes(device.queue.read_buffer(outputs))
