// Runs the rows of tests/parity in WebGPU: lvsm_all.wgsl, unchanged, and a compute shader after it.
import {runRows, text} from "./rows_page.js";

// The numbers that the shader makes of the words.
async function run(device, library, row, words) {
    const module = device.createShaderModule({code: library + row.wgsl});
    const {messages} = await module.getCompilationInfo();
    for (const message of messages)
        console.warn(`${row.function}, line ${message.lineNum}: ${message.message}`);
    const pipeline = await device.createComputePipelineAsync({layout: "auto", compute: {module, entryPoint: "main"}});
    const size = 4 * row.numbers * row.inputs;
    const buffers = [[words.byteLength, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST],
                     [size, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC],
                     [size, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST]]
                        .map(([bytes, usage]) => device.createBuffer({size: bytes, usage}));
    const [inputs, outputs, readable] = buffers;
    device.queue.writeBuffer(inputs, 0, words);
    const entries = [inputs, outputs].map((buffer, binding) => ({binding, resource: {buffer}}));
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries}));
    pass.dispatchWorkgroups(row.inputs / 64);
    pass.end();
    encoder.copyBufferToBuffer(outputs, 0, readable, 0, size);
    device.queue.submit([encoder.finish()]);
    await readable.mapAsync(GPUMapMode.READ);
    const results = new Float32Array(readable.getMappedRange().slice(0));
    buffers.forEach((buffer) => buffer.destroy());
    return results;
}

export async function main() {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter)
        throw new Error("this browser has no WebGPU");
    const device = await adapter.requestDevice();
    device.addEventListener("uncapturederror", (event) => console.error(event.error.message));
    const library = await text("/single/lvsm_all.wgsl");
    await runRows((row, words) => run(device, library, row, words));
    return {client: "WebGPU, WGSL", version: `${adapter.info.vendor} ${adapter.info.architecture}`};
}
