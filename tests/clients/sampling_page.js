// Links the one-file passes and the wrappers in WebGL2, and samples a map of 8 x 8 dark texels at and beyond its edge.
import {HEAD, program, text} from "./webgl.js";

// What is read, and what it has to be. A box of 9 texels around the middle of the edge covers 4.5 of them across and all
// 8 down. A gather between rows 3 and 4 has the border left, in its texels (0,0) and (0,1), and the map right.
const SAMPLES = [
    ["samplePcf, 9 wide, at the edge",
     "lvsm_samplePcf(slices, lvsm_mapPoint(vec2(0.0, 0.5), vec2(0.0), vec2(0.0), 0), 0.5, vec2(0.0), 9.0, 0.0, 0.0)",
     1 - 4.5 * 8 / 81],
    ["sampleVariance a quarter texel off",
     "lvsm_sampleVariance(slices, lvsm_mapPoint(vec2(-0.03125, 0.5), vec2(0.0), vec2(0.0), 0), 1.0, 0.0)", 0.75],
    ["sampleMap at the edge", "lvsm_sampleMap(map, vec2(0.0, 0.5), vec2(0.0), vec2(0.0), vec4(1.0)).x", 0.5],
    ["sampleMap a quarter texel off",
     "lvsm_sampleMap(map, vec2(-0.03125, 0.5), vec2(0.0), vec2(0.0), vec4(1.0)).x", 0.75],
    ["gatherMap at the edge", "dot(lvsm_gatherMap(map, vec2(0.0, 0.5), 1.0), vec4(0.1, 0.2, 0.3, 0.4))", 0.1 + 0.3],
];

function makeTexture(gl, format, kind = gl.TEXTURE_2D) {
    const texture = gl.createTexture();
    gl.bindTexture(kind, texture);
    if (kind === gl.TEXTURE_2D)
        gl.texStorage2D(kind, 1, format, 8, 8);
    else
        gl.texStorage3D(kind, 1, format, 8, 8, 1);
    for (const [name, value] of [["MIN_FILTER", "LINEAR"], ["MAG_FILTER", "LINEAR"], ["WRAP_S", "CLAMP_TO_EDGE"],
                                 ["WRAP_T", "CLAMP_TO_EDGE"]])
        gl.texParameteri(kind, gl[`TEXTURE_${name}`], gl[value]);
    return texture;
}

// What was sampled, the answer, and the answer that is right.
export async function main() {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    gl.getExtension("EXT_color_buffer_float");
    for (const name of ["lvsm_blur.frag", "lvsm_store.frag", "lvsm_mixture.frag"])
        program(gl, HEAD + (await text(name)).replace(/^[^\n]*\n/, ""));

    const wrappers = await text("lvsm_combined.glsl");
    const target = makeTexture(gl, gl.RGBA32F);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    gl.viewport(0, 0, 1, 1);
    makeTexture(gl, gl.R16F);
    gl.activeTexture(gl.TEXTURE1);
    makeTexture(gl, gl.RG16F, gl.TEXTURE_2D_ARRAY);
    const answers = [];
    for (const [what, call, expected] of SAMPLES) {
        const made = program(gl, `${HEAD}${wrappers}
            uniform highp sampler2D map;
            uniform highp sampler2DArray slices;
            out vec4 result;
            void main() { result = vec4(${call}); }`);
        gl.useProgram(made);
        gl.uniform1i(gl.getUniformLocation(made, "slices"), 1);
        gl.drawArrays(gl.POINTS, 0, 1);
        const pixel = new Float32Array(4);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, pixel);
        answers.push([what, pixel[0], expected]);
    }
    return answers;
}
