// The one-file versions in plain WebGL2, after the three lines that GLSL ES 3.00 asks of a user.
export const HEAD = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
const POINT = `${HEAD}void main() { gl_PointSize = 1.0; gl_Position = vec4(0.0, 0.0, 0.0, 1.0); }\n`;

// A fragment shader's program, which draws one point over the whole of a target of one texel, or what else the vertex
// shader says.
export function program(gl, fragment, vertex = POINT) {
    const made = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS))
        throw new Error(`does not link: ${gl.getProgramInfoLog(made)}`);
    return made;
}

export async function text(name) {
    return (await fetch(`/single/${name}`)).text();
}
