// Formats of maps: what three.js calls them, what they round by, and what the device must have for them.
import * as THREE from "three";

const CHANNELS = {1: THREE.RedFormat, 2: THREE.RGFormat, 4: THREE.RGBAFormat};
const WORDS = {2: THREE.RGIntegerFormat, 4: THREE.RGBAIntegerFormat};

// error: the largest of a depth in [0,1], LVSM_DEPTH_ERROR of the library.
export const FORMATS = {
    unorm8: {name: "8-bit fixed point", bits: 8, type: THREE.UnsignedByteType, error: 1 / 510},
    unorm16: {name: "16-bit fixed point", bits: 16, type: THREE.UnsignedShortType, normalized: true, error: 1 / 131070,
              needs: "EXT_texture_norm16"},
    fp16: {name: "16-bit float", bits: 16, type: THREE.HalfFloatType, error: 2 ** -12, largest: 65504},
    fp32: {name: "32-bit float", bits: 32, type: THREE.FloatType, error: 2 ** -25, largest: 3.4028234e38,
           needs: "OES_texture_float_linear"},
    words: {name: "32-bit words", bits: 32, type: THREE.UnsignedIntType, isWhole: true},
};

export const depthErrorOf = (format) => FORMATS[format].error;
export const bitsOf = (format, channels, slices) => FORMATS[format].bits * channels * slices;

// What store.frag clamps to.
export const largestOf = (format) => FORMATS[format].largest ?? 1;

// format: a row of FORMATS. Options of a render target for it.
export function textureOptions(format, channels) {
    const {type, isWhole} = FORMATS[format];
    return {type, format: (isWhole ? WORDS : CHANNELS)[channels], depthBuffer: false};
}
