// Runs the rows of tests/parity in three.js: lvsm_all.glsl in ShaderChunk, unchanged, and #include <lvsm>.
import * as THREE from "three";
import {runRows, text} from "./rows_page.js";

const WORDS = 24;
const INPUTS_PER_ROW = 64;

function inputTexture(words) {
    const width = INPUTS_PER_ROW * WORDS / 4;
    const texture = new THREE.DataTexture(words, width, words.length / (4 * width), THREE.RGBAIntegerFormat,
                                          THREE.UnsignedIntType);
    texture.internalFormat = "RGBA32UI";
    texture.needsUpdate = true;
    return texture;
}

// Three targets hold twelve numbers of an input's result: those from first on go to their places in results.
function runPart(renderer, row, words, first, results) {
    const height = row.inputs / INPUTS_PER_ROW;
    const target = new THREE.WebGLRenderTarget(INPUTS_PER_ROW, height, {
        count: 3, type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
        depthBuffer: false,
    });
    const material = new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3,
        defines: {FIRST: first},
        vertexShader: "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n",
        fragmentShader: `precision highp float;\n#include <lvsm>\n${row.kernel}`,
        uniforms: {lvsm_inputs: {value: inputTexture(words)}},
        depthTest: false,
    });
    const triangle = new THREE.BufferGeometry();
    triangle.setAttribute("position", new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const mesh = new THREE.Mesh(triangle, material);
    mesh.frustumCulled = false;
    renderer.setRenderTarget(target);
    renderer.render(mesh, new THREE.Camera());

    for (let part = 0; part < 3; ++part) {
        const four = new Float32Array(4 * row.inputs);
        renderer.readRenderTargetPixels(target, 0, 0, INPUTS_PER_ROW, height, four, undefined, part);
        for (let i = 0; i < row.inputs; ++i) {
            for (let c = 0; c < 4 && first + 4 * part + c < row.numbers; ++c)
                results[row.numbers * i + first + 4 * part + c] = four[4 * i + c];
        }
    }
    material.dispose();
    target.dispose();
}

// The results of each input, in the order of the inputs.
function run(renderer, row, words) {
    const results = new Float32Array(row.numbers * row.inputs);
    for (let first = 0; first < row.numbers; first += 12)
        runPart(renderer, row, words, first, results);
    return results;
}

export async function main() {
    THREE.ShaderChunk.lvsm = await text("/single/lvsm_all.glsl");
    const renderer = new THREE.WebGLRenderer();
    await runRows((row, words) => run(renderer, row, words));
    return {client: "three.js, WebGL2", version: `r${THREE.REVISION}`};
}
