// The one-file version in plain WebGL2, after the three lines that GLSL ES 3.00 asks of a user, and its constants
// read back.
const HEAD = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
const VERTEX = "#version 300 es\nvoid main() { gl_PointSize = 1.0; gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }\n";

function program(gl, fragment) {
    const made = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS))
        throw new Error(`does not link: ${fragment.slice(0, 400)}`);
    return made;
}

const text = async (file) => (await fetch(`/single/${file}`)).text();

// The bits of each constant of the text, by name, as a shader has them. The wrappers and the passes for WebGL2 compile
// beside that, with what their first lines ask for.
export async function main() {
    const library = await text("lvsm_all.glsl");
    const names = [...library.matchAll(/^const float (\w+) =/gm)].map((match) => match[1]);
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    program(gl, `${HEAD}${await text("lvsm_combined.glsl")}
        out vec4 result;
        void main() { result = vec4(1.0); }`);
    for (const pass of ["lvsm_blur.frag", "lvsm_store.frag"])
        program(gl, (await text(pass)).replace("#version 450\n", HEAD));
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
