import {HEAD, program, text} from "./webgl.js";

// The bits of each constant of the one-file version, by name, as a shader has them.
export async function main() {
    const library = await text("lvsm_all.glsl");
    const names = [...library.matchAll(/^const float (\w+) =/gm)].map((match) => match[1]);
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, 1, 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const read = {};
    for (const name of names) {
        gl.useProgram(program(gl, `${HEAD}${library}
            uniform float one; // so that no compiler folds the constant before it is a float
            out uvec4 bits;
            void main() { bits = uvec4(floatBitsToUint(${name} * one)); }`));
        gl.uniform1f(gl.getUniformLocation(gl.getParameter(gl.CURRENT_PROGRAM), "one"), 1);
        gl.drawArrays(gl.POINTS, 0, 1);
        const pixel = new Uint32Array(4);
        gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixel);
        read[name] = pixel[0];
    }
    return read;
}
