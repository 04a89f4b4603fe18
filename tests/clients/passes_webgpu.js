// Plays the script in WebGPU: every pass is computed.
import {levelsOf, playScript} from "./script_page.js";

// Rows of a copy to a buffer are so many bytes apart.
const ALIGNED = 256;

class Player {
    constructor(device) {
        this.device = device;
        this.textures = [];
        this.pipelines = [];
        this.buffers = [];
        this.sampler = device.createSampler({magFilter: "linear", minFilter: "linear"});
    }

    texture(command, data) {
        const size = [command.width, command.height, command.slices];
        const usage = GPUTextureUsage.COPY_SRC | GPUTextureUsage.COPY_DST | GPUTextureUsage.TEXTURE_BINDING |
            GPUTextureUsage.STORAGE_BINDING;
        const format = command.words ? "rgba32uint" : "rgba32float";
        const object = this.device.createTexture({size, mipLevelCount: command.levels, format, usage});
        for (const {level, at, width, height, floats} of levelsOf(command))
            this.device.queue.writeTexture({texture: object, mipLevel: level},
                                           new Float32Array(data, command.at + 4 * at, floats),
                                           {bytesPerRow: 16 * width, rowsPerImage: height},
                                           [width, height, command.slices]);
        this.textures.push({...command, object});
    }

    program({text, entry}) {
        const module = this.device.createShaderModule({code: text});
        module.getCompilationInfo().then(({messages}) => {
            for (const message of messages)
                console.warn(`${entry}, line ${message.lineNum}: ${message.message}`);
        });
        const pipeline = this.device.createComputePipeline({layout: "auto", compute: {module, entryPoint: entry}});
        this.pipelines.push({pipeline, filters: /^[^/\n]*: sampler;/m.test(text)});
    }

    view(number, level) {
        const {array, object} = this.textures[number];
        const levels = level < 0 ? {} : {baseMipLevel: level, mipLevelCount: 1};
        return object.createView({dimension: array ? "2d-array" : "2d", ...levels});
    }

    filled(data, at, size, usage) {
        const buffer = this.device.createBuffer({size, usage: usage | GPUBufferUsage.COPY_DST});
        this.device.queue.writeBuffer(buffer, 0, data, at, size);
        return buffer;
    }

    buffer({at, bytes}, data) {
        this.buffers.push(this.filled(data, at, bytes, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC));
    }

    run({program, sources, blocks, buffers, target, groups}, data) {
        const {pipeline, filters} = this.pipelines[program];
        const entries = target ? [{binding: 1, resource: this.view(target[0], target[2])}] : [];
        for (const [binding, number] of buffers)
            entries.push({binding, resource: {buffer: this.buffers[number]}});
        for (const [, binding, texture, only] of sources)
            entries.push({binding, resource: this.view(texture, only)});
        for (const [, binding, at, size] of blocks)
            entries.push({binding, resource: {buffer: this.filled(data, at, size, GPUBufferUsage.UNIFORM)}});
        if (filters)
            entries.push({binding: 3, resource: this.sampler});
        const encoder = this.device.createCommandEncoder();
        const pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, this.device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries}));
        pass.dispatchWorkgroups(...groups);
        pass.end();
        this.device.queue.submit([encoder.finish()]);
    }

    async readBuffer({buffer: number}) {
        const {size} = this.buffers[number];
        const copy = this.device.createBuffer({size, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
        const encoder = this.device.createCommandEncoder();
        encoder.copyBufferToBuffer(this.buffers[number], 0, copy, 0, size);
        this.device.queue.submit([encoder.finish()]);
        await copy.mapAsync(GPUMapMode.READ);
        const words = copy.getMappedRange().slice(0);
        copy.destroy();
        return words;
    }

    async read({texture: number}) {
        const texture = this.textures[number];
        const encoder = this.device.createCommandEncoder();
        const copies = levelsOf(texture).map(({level, at, width, height}) => {
            const bytesPerRow = Math.ceil(16 * width / ALIGNED) * ALIGNED;
            const buffer = this.device.createBuffer({size: bytesPerRow * height * texture.slices,
                                                     usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
            encoder.copyTextureToBuffer({texture: texture.object, mipLevel: level},
                                        {buffer, bytesPerRow, rowsPerImage: height}, [width, height, texture.slices]);
            return {buffer, at, width, rows: height * texture.slices, apart: bytesPerRow / 4};
        });
        this.device.queue.submit([encoder.finish()]);
        const floats = new Float32Array(levelsOf(texture).reduce((sum, level) => sum + level.floats, 0));
        for (const {buffer, at, width, rows, apart} of copies) {
            await buffer.mapAsync(GPUMapMode.READ);
            const copied = new Float32Array(buffer.getMappedRange());
            for (let row = 0; row < rows; ++row)
                floats.set(copied.subarray(row * apart, row * apart + 4 * width), at + 4 * width * row);
            buffer.destroy();
        }
        return floats;
    }
}

export async function main() {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter)
        throw new Error("this browser has no WebGPU");
    const device = await adapter.requestDevice({requiredFeatures: ["float32-filterable"]});
    device.addEventListener("uncapturederror", (event) => console.error(event.error.message));
    await playScript(new Player(device));
    return `WebGPU, ${adapter.info.vendor} ${adapter.info.architecture}`;
}
