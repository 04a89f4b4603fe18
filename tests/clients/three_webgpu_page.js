// Runs the rows of tests/parity in three.js on WebGPU: lvsm_all.wgsl, unchanged, as code that a wgslFn includes.
import * as THREE from "three/webgpu";
import {code, instanceIndex, storage, wgslFn} from "three/tsl";
import {runRows, text} from "./rows_page.js";

const WORDS = 24;

// The row's kernel as a function of the invocation and of three.js' buffers, whose names it chooses: the kernel's own are
// copies for one invocation.
function functionOf(library, {wgsl, numbers}) {
    const [helpers, main] = wgsl.replace(/@group.*inputs.*\n/, `var<private> inputs: array<u32, ${WORDS}>;\n`)
        .replace(/@group.*outputs.*\n/, `var<private> outputs: array<f32, ${numbers}>;\n`).split("@compute");
    const body = main.slice(main.indexOf("{") + 1, main.lastIndexOf("}")).replace(/id\.x/g, "0u");
    return wgslFn(`
fn runRow(index: u32, given: ptr<storage, array<u32>, read_write>, made: ptr<storage, array<f32>, read_write>) -> void
{
    for (var i = 0u; i < ${WORDS}u; i++) { inputs[i] = (*given)[${WORDS}u * index + i]; }
    ${body}
    for (var i = 0u; i < ${numbers}u; i++) { (*made)[${numbers}u * index + i] = outputs[i]; }
}`, [library, code(helpers, [], "wgsl")]);
}

async function run(renderer, library, row, words) {
    const given = new THREE.StorageBufferAttribute(words, 1);
    const made = new THREE.StorageBufferAttribute(new Float32Array(row.numbers * row.inputs), 1);
    const call = functionOf(library, row)({index: instanceIndex, given: storage(given, "uint", words.length),
                                           made: storage(made, "float", made.array.length)});
    const node = call.compute(row.inputs);
    await renderer.computeAsync(node);
    const results = await renderer.getArrayBufferAsync(made);
    node.dispose();
    return results;
}

export async function main() {
    const renderer = new THREE.WebGPURenderer();
    await renderer.init();
    if (!renderer.backend.isWebGPUBackend)
        throw new Error("three.js has no WebGPU here");
    const library = code(await text("/single/lvsm_all.wgsl"), [], "wgsl");
    await runRows((row, words) => run(renderer, library, row, words));
    return {client: "three.js, WebGPU", version: `r${THREE.REVISION}`};
}
