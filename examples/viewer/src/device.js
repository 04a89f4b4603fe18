// What the browser's WebGL has.
import {FORMATS} from "./formats.js";

// A sentence that says what is missing, or an empty one.
export function describeLack() {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl)
        return "This browser has no WebGL2, which the viewer draws with. A current Chrome, Edge, Firefox or Safari has it, " +
            "unless hardware acceleration is off in its settings.";
    const lack = gl.getExtension("EXT_color_buffer_float") ? ""
        : "This browser's WebGL2 cannot draw into floating-point textures (EXT_color_buffer_float), which shadow maps of " +
          "depths and moments are.";
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return lack;
}

export function deviceOf(canvas) {
    const gl = canvas.getContext("webgl2");
    const formats = Object.keys(FORMATS).filter((format) => !FORMATS[format].needs || gl.getExtension(FORMATS[format].needs));
    const filter = gl.getExtension("EXT_texture_filter_anisotropic");
    const anisotropy = filter ? gl.getParameter(filter.MAX_TEXTURE_MAX_ANISOTROPY_EXT) : 1;
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return {formats: new Set(formats), anisotropy};
}
