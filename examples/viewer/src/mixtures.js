// The windows of the library's pass passes/mixture and what it draws, as C++ has them from include/lvsm/passes_mixture.hpp.
const WIDEST = 25;

// width: odd, in texels of the codes. half: whether a texel of the codes is one of 2 x 2 depths.
// Result: steps of the rounds, and the deviation in texels of the depths.
export function mixtureWindow(width, half) {
    const steps = [];
    for (let left = (width - 1) / 2; left > 0; left -= steps[0])
        steps.unshift(Math.min(Math.ceil(left / 2), 5));
    const variance = steps.reduce((sum, step) => sum + step * step * (half ? 2 : 0.5), half ? 0.25 : 0);
    return {steps, deviation: Math.sqrt(variance)};
}

export const MIXTURE_WIDTHS = Array.from({length: (WIDEST + 1) / 2}, (_, i) => 2 * i + 1);

// The width whose window spreads most like the blur.
export function matchingWidth(half, kernel) {
    const distance = (width) => Math.abs(mixtureWindow(width, half).deviation - kernel.deviation);
    return MIXTURE_WIDTHS.reduce((best, width) => (distance(width) < distance(best) ? width : best));
}

// The draws of a whole map: their blocks, the side of the codes, and that of what lies between the draws.
export function mixtureDraws(width, half, size) {
    const {steps, deviation} = mixtureWindow(width, half);
    const texels = half ? 2 : 1;
    const coded = size / texels;
    const stages = steps.length > 0 ? steps.flatMap((step) => [[step, 0], [0, step]]) : [[0, 0]];
    const marginOf = (after) => [0, 1].map((axis) => stages.slice(after).reduce((sum, stage) => sum + stage[axis], 0));
    const margin = marginOf(1);
    const blocks = stages.map((stage, i) => {
        const isLast = i + 1 === stages.length;
        const [x, y] = marginOf(i + 1);
        const from = i > 0 ? margin : [0, 0];
        const to = isLast ? [0, 0] : margin;
        const data = new ArrayBuffer(80);
        new Int32Array(data).set([0, 0, size, size, -x, -y, coded + x, coded + y, ...from.map((reach) => -reach),
                                  ...to.map((reach) => -reach), ...stage, 1, texels]);
        new Float32Array(data, 64, 1).set([deviation]);
        new Float32Array(data, 72, 2).set([0.25, 0.25]); // what each outer texel of a round gets, as in mixtureWindow
        return data;
    });
    return {blocks, coded, between: coded + 2 * Math.max(...margin)};
}
