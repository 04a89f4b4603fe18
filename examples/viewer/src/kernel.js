// The blur's kernel: its taps, and as the fetches that the library's blur pass takes, two taps to each. And the blocks of
// the library's passes, which C++ has from include/lvsm/passes.hpp.
const MAX_FETCHES = 66;

const SHAPES = {
    binomial: (i, taps) => {
        let weight = 0.5 ** (taps - 1);
        for (let j = 1; j <= Math.min(i, taps - 1 - i); ++j)
            weight *= (taps - j) / j;
        return weight;
    },
    // As wide as the binomial of as many taps.
    gaussian: (i, taps) => Math.exp(-2 * (i - (taps - 1) / 2) ** 2 / Math.max(taps - 1, 1)),
    box: (i, taps) => 1 / taps,
    // That of mixtures where there are 3, 7 or 15 taps.
    triangle: (i, taps) => Math.min(i, taps - 1 - i) + 1,
};

// shape: of SHAPES. taps: an odd number. Result: weights that add up to 1, their standard deviation, and the width of
// a box of the same deviation.
export function makeKernel(shape, taps) {
    const raw = Array.from({length: taps}, (_, i) => SHAPES[shape](i, taps));
    const sum = raw.reduce((total, weight) => total + weight, 0);
    const weights = raw.map((weight) => weight / sum);
    const middle = (taps - 1) / 2;
    const variance = weights.reduce((total, weight, i) => total + weight * (i - middle) ** 2, 0);
    return {weights, taps, radius: middle, deviation: Math.sqrt(variance), matchingBox: Math.sqrt(12 * variance + 1)};
}

// What binomialKernel and its like of include/lvsm/passes.hpp give: [offset, weight] of each fetch.
export function fetchesOf({weights, radius}) {
    const fetches = [];
    for (let i = 0; i < weights.length; i += 2) {
        const [first, second] = [weights[i], weights[i + 1] ?? 0];
        fetches.push([i - radius + second / (first + second), first + second]);
    }
    return fetches;
}

// The block lvsm_Blur, as BlurBlock of include/lvsm/passes.hpp.
export function blurBlock(fetches, size, direction, border, slice) {
    const data = new ArrayBuffer(80 + 8 * MAX_FETCHES);
    new Float32Array(data, 0, 4).set(border);
    new Int32Array(data, 16, 8).set([0, 0, size, size, 0, 0, size, size]);
    new Float32Array(data, 48, 2).set(direction);
    new Int32Array(data, 56, 2).set([slice, fetches.length]);
    new Float32Array(data, 64, 2 * MAX_FETCHES).set(fetches.flat());
    return data;
}

// The block lvsm_Mip, as MipBlock of include/lvsm/passes_mip.hpp.
export function mipBlock(size, level, slice) {
    const [before, own] = [level - 1, level].map((number) => Math.max(size >> number, 1));
    return new Int32Array([0, 0, before, before, 0, 0, own, own, slice, level - 1, 0, 0]).buffer;
}

// The block lvsm_Store, as StoreBlock of include/lvsm/passes.hpp. The viewer's store functions have their splits as
// uniforms; of the block they need the slice alone.
export function storeBlock(size, slice) {
    const data = new ArrayBuffer(32 + 4 * 68);
    new Int32Array(data, 0, 4).set([0, 0, size, size]);
    new Int32Array(data, 28, 1).set([slice]);
    return data;
}
