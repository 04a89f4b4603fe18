// Constants that many techniques have, and their defaults.
import {depthErrorOf} from "./formats.js";

// recommendedMinVariance of three roundings, storing and two passes of a blur, and a hundredth of light; 6e-8 covers a
// compiler without `precise`.
export function floorOf(format) {
    return Math.max(99 * (3 * depthErrorOf(format)) ** 2, 6e-8);
}

// In texels; what shiftReceiver says suits meshes.
export const SHIFT = 0.3;

export const SHIFTED = [["float", "shift", (side) => side.shift]];
export const REDUCED = [["float", "amount", (side) => side.reduction]];
// With no deviation the floor is the same for every slope.
export const FLOORED = [["float", "minVariance", (side) => side.minVariance],
                        ["float", "deviation", (side, frame) => (side.slope ? frame.kernel.deviation : 0)]];

