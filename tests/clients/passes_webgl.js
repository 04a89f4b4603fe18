// Plays the script in WebGL2: every pass is drawn.
import {levelsOf, playScript} from "./script_page.js";
import {program} from "./webgl.js";

const CORNERS = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }
`;

class Player {
    constructor(gl) {
        this.gl = gl;
        this.textures = [];
        this.programs = [];
        this.framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        gl.enable(gl.SCISSOR_TEST);
    }

    kind(texture) {
        return texture.array ? this.gl.TEXTURE_2D_ARRAY : this.gl.TEXTURE_2D;
    }

    texture(command, data) {
        const gl = this.gl;
        const kind = this.kind(command);
        const object = gl.createTexture();
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(kind, object);
        const {words} = command;
        const size = [command.levels, words ? gl.RGBA32UI : gl.RGBA32F, command.width, command.height];
        const [layout, type, Texels] = words ? [gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array]
                                             : [gl.RGBA, gl.FLOAT, Float32Array];
        if (command.array)
            gl.texStorage3D(kind, ...size, command.slices);
        else
            gl.texStorage2D(kind, ...size);
        for (const {level, at, width, height, floats} of levelsOf(command)) {
            const texels = new Texels(data, command.at + 4 * at, floats);
            if (command.array)
                gl.texSubImage3D(kind, level, 0, 0, 0, width, height, command.slices, layout, type, texels);
            else
                gl.texSubImage2D(kind, level, 0, 0, width, height, layout, type, texels);
        }
        const filter = words ? gl.NEAREST : gl.LINEAR;
        gl.texParameteri(kind, gl.TEXTURE_MIN_FILTER, command.levels > 1 ? gl.LINEAR_MIPMAP_NEAREST : filter);
        gl.texParameteri(kind, gl.TEXTURE_MAG_FILTER, filter);
        gl.texParameteri(kind, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(kind, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        this.textures.push({...command, object});
    }

    program(command) {
        this.programs.push(program(this.gl, command.text, CORNERS));
    }

    attach(texture, slice, level) {
        const gl = this.gl;
        if (texture.array)
            gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, texture.object, level, slice);
        else
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture.object, level);
    }

    run({program: number, sources, blocks, target: [target, slice, level], region}, data) {
        const gl = this.gl;
        const made = this.programs[number];
        gl.useProgram(made);
        sources.forEach(([name, , texture, only], unit) => {
            const source = this.textures[texture];
            const kind = this.kind(source);
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(kind, source.object);
            gl.texParameteri(kind, gl.TEXTURE_BASE_LEVEL, Math.max(only, 0));
            gl.texParameteri(kind, gl.TEXTURE_MAX_LEVEL, only < 0 ? source.levels - 1 : only);
            gl.uniform1i(gl.getUniformLocation(made, name), unit);
        });
        blocks.forEach(([name, binding, at, size]) => {
            const buffer = gl.createBuffer();
            gl.bindBufferBase(gl.UNIFORM_BUFFER, binding, buffer);
            gl.bufferData(gl.UNIFORM_BUFFER, new Uint8Array(data, at, size), gl.STREAM_DRAW);
            gl.uniformBlockBinding(made, gl.getUniformBlockIndex(made, name), binding);
        });
        const texture = this.textures[target];
        this.attach(texture, slice, level);
        gl.viewport(0, 0, Math.max(texture.width >> level, 1), Math.max(texture.height >> level, 1));
        gl.scissor(...region);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    read({texture: number}) {
        const gl = this.gl;
        const texture = this.textures[number];
        const levels = levelsOf(texture);
        const floats = new Float32Array(levels.reduce((sum, level) => sum + level.floats, 0));
        for (const {level, at, width, height} of levels) {
            for (let slice = 0; slice < texture.slices; ++slice) {
                this.attach(texture, slice, level);
                gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, floats, at + 4 * width * height * slice);
            }
        }
        return floats;
    }
}

export async function main() {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    for (const name of ["EXT_color_buffer_float", "OES_texture_float_linear"]) {
        if (!gl.getExtension(name))
            throw new Error(`this browser has no ${name}`);
    }
    await playScript(new Player(gl));
    const error = gl.getError();
    if (error !== gl.NO_ERROR)
        throw new Error(`WebGL's error ${error}`);
    return gl.getParameter(gl.VERSION);
}
