// The techniques as data. The panel shows what `settings` names, the passes store and judge with the GLSL here, and the
// same text with the settings as constants is what the copy buttons give.
//
//   settings    names of rows in settings.js, each with its default: a value, or a function of (side, device)
//   formats     of the map, the first that the device has being the default; channels: how many components it needs
//   slices      of the map, for the side's settings
//   constants   [type, name, value] of what the GLSL names, for the side's settings and what the frame knows
//   store       vec4 store(float depth, int slice): what a slice holds for a depth
//   coded       vec4 code(vec4 filtered): what is written of the map once it is filtered, in floats; no hardware filters it
//   planes      of mixtures: their map is made by passes/mixture, and store is none
//   judge       the rest: float visibility(...), see MAP
//   stored      mean and spread of the stored depths, for the views: vec2 stored(MAP map, lvsm_MapPoint at, float depth)
import {depthErrorOf} from "./formats.js";
import {FLOORED, floorOf, REDUCED, SHIFT, SHIFTED} from "./constants.js";
import {LAYERED_TECHNIQUES} from "./layered.js";
import {matchingWidth, mixtureWindow} from "./mixtures.js";

// What visibility is called with. ESM alone reads the unblurred map too.
export const SIGNATURE = "float visibility(MAP map, lvsm_MapPoint at, float depth, vec2 gradient)";
export const ESM_SIGNATURE = "float visibility(MAP map, MAP unfiltered, lvsm_MapPoint at, float depth, vec2 gradient)";

const STORED_DEPTH = "vec4 store(float depth, int slice)\n{\n    return vec4(depth, depth, depth, depth);\n}\n";

const mixtureOf = (planes) => ({
    source: "this library, mixture",
    formats: ["words"], channels: planes, filtered: false, planes,
    settings: {window: (side, device, kernel) => matchingWidth(side.half, kernel), half: false},
    constants: [["float", "texels", (side) => (side.half ? 2 : 1)],
                ["float", "deviation", (side) => mixtureWindow(side.window, side.half).deviation]],
    judge: `
    return lvsm_sampleMixture${planes}(map, at, depth, gradient, texels, deviation);`,
    stored: `
    uvec4 code = texelFetch(map, ivec3(at.uv * vec2(textureSize(map, 0).xy), at.slice), 0);
    lvsm_MixturePlanes mixture = lvsm_decodeMixture${planes}(code${planes === 2 ? ".xy" : ""}, deviation);
    float mean = 0.0;
    float square = 0.0;
    for (int i = 0; i < ${planes}; ++i)
    {
        lvsm_MixturePlane plane = mixture.planes[i];
        mean += plane.weight * plane.depth;
        square += plane.weight * (plane.depth * plane.depth + plane.deviation * plane.deviation);
    }
    return vec2(mean, sqrt(max(square - mean * mean, 0.0)));`,
});

export const TECHNIQUES = {
    basic: {
        name: "Shadow map",
        line: "One comparison with the nearest texel: hard and jagged edges.",
        source: "Williams 1978",
        formats: ["fp32"], channels: 1, filtered: false,
        settings: {bias: 0.003},
        constants: [["float", "bias", (side) => side.bias]],
        store: STORED_DEPTH,
        judge: `
    vec2 size = lvsm_mapArraySize(map);
    float occluder = lvsm_fetchSlice(map, at, 0, floor(at.uv * size)).x;
    return lvsm_depthTest(occluder, depth, bias);`,
        stored: "return vec2(lvsm_fetchSlice(map, at, 0, floor(at.uv * lvsm_mapArraySize(map))).x, 0.0);",
    },
    pcf: {
        name: "PCF",
        line: "Every texel of a box is compared, then averaged: right, at the price of all those texels.",
        source: "Reeves et al. 1987",
        formats: ["fp32"], channels: 1, filtered: false,
        settings: {width: (side, device, kernel) => Math.round(10 * kernel.matchingBox) / 10, plane: true, bias: 0.001},
        constants: [["float", "width", (side) => side.width], ["float", "bias", (side) => side.bias],
                    ["bool", "followsPlane", (side) => side.plane]],
        store: STORED_DEPTH,
        judge: `
    vec2 slope = followsPlane ? gradient : vec2(0.0, 0.0);
    return lvsm_samplePcf(map, at, depth, slope, width, 0.0, bias);`,
        stored: "return vec2(lvsm_fetchSlice(map, at, 0, floor(at.uv * lvsm_mapArraySize(map))).x, 0.0);",
    },
    vsm: {
        name: "VSM",
        line: "Variance: the bound from two moments. Soft and cheap, but light bleeds where shadows overlap.",
        source: "Donnelly & Lauritzen 2006",
        formats: ["unorm16", "fp16", "fp32"], channels: 2, filtered: true,
        settings: {minVariance: (side) => floorOf(side.format), slope: true, reduction: 0, shift: SHIFT},
        constants: [...FLOORED, ...REDUCED, ...SHIFTED],
        store: "vec4 store(float depth, int slice)\n{\n    return vec4(lvsm_depthMoments(depth), 0.0, 0.0);\n}\n",
        judge: `
    float least = lvsm_receiverMinVariance(minVariance, gradient, deviation);
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_reduceLightBleeding(lvsm_sampleVariance(map, at, receiver, least), amount);`,
        stored: `
    vec2 moments = lvsm_sampleSlice(map, at, 0, vec4(1.0, 1.0, 1.0, 1.0)).xy;
    return vec2(moments.x, sqrt(lvsm_variance(moments, 0.0)));`,
    },
    ...LAYERED_TECHNIQUES,
    evsm2: {
        name: "EVSM2",
        line: "Variance of an exponential warp: little bleeding, but occluders at different depths leak at contact.",
        source: "Lauritzen & McCool 2008, section 7",
        formats: ["fp32", "fp16"], channels: 2, filtered: true,
        settings: {exponent: (side) => (side.format === "fp16" ? 5.54 : 42), minVariance: (side) => floorOf(side.format),
                   slope: true, reduction: 0, shift: SHIFT},
        constants: [["float", "exponent", (side) => side.exponent], ...FLOORED, ...REDUCED, ...SHIFTED],
        store: `vec4 store(float depth, int slice)
{
    return lvsm_exponentialMoments(depth, vec2(exponent, 0.0));
}
`,
        judge: `
    float least = lvsm_receiverMinVariance(minVariance, gradient, deviation);
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_reduceLightBleeding(lvsm_sampleExponential2(map, at, receiver, exponent, least), amount);`,
        stored: `
    vec2 moments = lvsm_sampleSlice(map, at, 0, lvsm_exponentialMoments(1.0, vec2(exponent, 0.0))).xy;
    float spread = sqrt(lvsm_variance(moments, 0.0)) / (2.0 * exponent * moments.x);
    return vec2(0.5 + 0.5 * log(moments.x) / exponent, spread);`,
    },
    evsm4: {
        name: "EVSM4",
        line: "The lesser of the bounds from a positive and a negative warp: two more channels for less leaking.",
        source: "Lauritzen & McCool 2008, section 7",
        formats: ["fp32", "fp16"], channels: 4, filtered: true,
        settings: {exponent: (side) => (side.format === "fp16" ? 5.54 : 42),
                   negative: (side) => (side.format === "fp16" ? 5.54 : 10),
                   minVariance: (side) => floorOf(side.format), slope: true, reduction: 0, shift: SHIFT},
        constants: [["vec2", "exponents", (side) => [side.exponent, side.negative]], ...FLOORED, ...REDUCED, ...SHIFTED],
        store: "vec4 store(float depth, int slice)\n{\n    return lvsm_exponentialMoments(depth, exponents);\n}\n",
        judge: `
    float least = lvsm_receiverMinVariance(minVariance, gradient, deviation);
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_reduceLightBleeding(lvsm_sampleExponential4(map, at, receiver, exponents, least), amount);`,
        stored: `
    vec2 moments = lvsm_sampleSlice(map, at, 0, lvsm_exponentialMoments(1.0, exponents)).xy;
    float spread = sqrt(lvsm_variance(moments, 0.0)) / (2.0 * exponents.x * moments.x);
    return vec2(0.5 + 0.5 * log(moments.x) / exponents.x, spread);`,
    },
    esm: {
        name: "ESM",
        line: "One exponential term: dark contact leaks, and where its test fails, four unblurred texels judge.",
        source: "Annen et al. 2008",
        formats: ["fp32", "fp16"], channels: 1, filtered: true, unfiltered: true,
        settings: {term: (side) => (side.format === "fp16" ? 11 : 80), threshold: 0.02, shift: SHIFT},
        constants: [["float", "exponent", (side) => side.term], ["float", "threshold", (side) => side.threshold],
                    ...SHIFTED],
        store: `vec4 store(float depth, int slice)
{
    float term = lvsm_occluderTerm(depth, exponent);
    return vec4(term, term, term, term);
}
`,
        judge: `
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_sampleEsm(map, unfiltered, at, receiver, exponent, threshold);`,
        stored: "return vec2(log(lvsm_sampleSlice(map, at, 0, store(1.0, 0)).x) / exponent, 0.0);",
    },
    msm4: {
        name: "MSM4",
        line: "Moment shadow map: the bound from four moments, the best that one filtered texel of 64 bits gives.",
        source: "Peters & Klein 2015",
        formats: ["unorm16", "fp32"], channels: 4, filtered: true,
        settings: {momentBias: (side) => (side.format === "unorm16" ? 6e-5 : 3e-7), reduction: 0, shift: SHIFT},
        constants: [["bool", "encoded", (side) => side.format === "unorm16"], ["float", "bias", (side) => side.momentBias],
                    ...REDUCED, ...SHIFTED],
        store: `vec4 store(float depth, int slice)
{
    vec4 moments = lvsm_depthMoments4(depth);
    return encoded ? lvsm_encodeMoments4(moments) : moments;
}
`,
        judge: `
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_reduceLightBleeding(lvsm_sampleMoments4(map, at, receiver, encoded, bias), amount);`,
        stored: `
    vec4 moments = lvsm_sampleFourMoments(map, at, 0, encoded);
    return vec2(0.5 + 0.5 * moments.x, 0.5 * sqrt(max(moments.y - moments.x * moments.x, 0.0)));`,
    },
    quantised: {
        name: "Quantised moments",
        line: "Four moments filtered in floats, then coded in 64 bits; four codes are judged for each pixel.",
        source: "Peters 2017",
        formats: ["unorm16", "fp32"], channels: 4, filtered: true,
        settings: {momentBias: 3e-7, reduction: 0, shift: SHIFT},
        constants: [["float", "bias", (side) => side.momentBias], ...REDUCED, ...SHIFTED],
        store: "vec4 store(float depth, int slice)\n{\n    return lvsm_depthMoments4(depth);\n}\n",
        // Rounded as 16 bits round, so that the 32-bit format shows the same.
        coded: `vec4 code(vec4 filtered)
{
    return floor(65535.0 * lvsm_quantiseMoments4(filtered, bias) + 0.5) / 65535.0;
}
`,
        judge: `
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_reduceLightBleeding(lvsm_sampleQuantised4(map, at, receiver), amount);`,
        stored: `
    vec4 nearest = lvsm_fetchSlice(map, at, 0, floor(at.uv * lvsm_mapArraySize(map)));
    float extent = nearest.y - nearest.x;
    return vec2(nearest.x + nearest.z * extent, extent * sqrt(nearest.z * (1.0 - nearest.z)));`,
    },
    trigonometric: {
        name: "Trigonometric moments",
        line: "Four moments on an arc, on a par with MSM4 in as many bits.",
        source: "this library, trigonometric",
        formats: ["unorm16", "fp32"], channels: 4, filtered: true,
        // recommendedTrigonometricBias of three roundings.
        settings: {momentBias: (side) => 5.14974 * 3 * depthErrorOf(side.format), reduction: 0, shift: SHIFT},
        constants: [["float", "bias", (side) => side.momentBias], ...REDUCED, ...SHIFTED],
        store: "vec4 store(float depth, int slice)\n{\n    return lvsm_trigonometricMoments(depth);\n}\n",
        judge: `
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_reduceLightBleeding(lvsm_sampleTrigonometric(map, at, receiver, bias), amount);`,
        stored: `
    vec4 moments = lvsm_sampleSlice(map, at, 0, lvsm_trigonometricMoments(1.0));
    vec2 mean = vec2(1.5 * moments.x - 0.5, 2.0 * moments.y - 1.0);
    float spread = sqrt(max(-2.0 * log(max(length(mean), 1.0e-6)), 0.0));
    return vec2(0.5 + 0.238732415 * atan(mean.y, mean.x), 0.238732415 * spread);`,
    },
    csm: {
        name: "CSM",
        line: "Convolution: the depth test as a Fourier series in 8-bit terms. Never sharp, and it rings.",
        source: "Annen et al. 2007",
        formats: ["unorm8", "unorm16", "fp16"], channels: 4, filtered: true,
        settings: {order: 8, strength: 1, contactScale: true, shift: SHIFT},
        slices: (side) => side.order / 2,
        constants: [["int", "order", (side) => side.order], ["float", "strength", (side) => side.strength],
                    ["float", "offset", (side) => (side.contactScale ? 0 : 0.5 / side.order)],
                    ["float", "scale", (side) => (side.contactScale ? 2 : 1)], ...SHIFTED],
        store: `vec4 store(float depth, int slice)
{
    int first = 4 * (slice / 2) + 1;
    bool isSine = (slice & 1) == 0;
    return lvsm_encodeFourier(isSine ? lvsm_fourierSines(depth, first, order) : lvsm_fourierCosines(depth, first, order));
}
`,
        judge: `
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_sampleConvolution(map, at, receiver, order, offset, strength, scale);`,
        stored: `
    float sine = lvsm_decodeFourier(lvsm_sampleSlice(map, at, 0, store(1.0, 0))).x;
    float cosine = lvsm_decodeFourier(lvsm_sampleSlice(map, at, 1, store(1.0, 1))).x;
    float spread = sqrt(max(-2.0 * log(max(length(vec2(sine, cosine)), 1.0e-6)), 0.0));
    return vec2(atan(sine, cosine), spread) / (3.14159265 * (1.0 - 1.0 / float(order)));`,
    },
    mixture2: {
        name: "Mixture of two planes",
        line: "What lies under the filter, as two planes in 64 bits: an estimate and no bound, read by one fetch.",
        ...mixtureOf(2),
    },
    mixture4: {
        name: "Mixture of four planes",
        line: "The same as four planes in 128 bits, for windows that see more than two surfaces.",
        ...mixtureOf(4),
    },
    exact: {
        name: "The exact answer",
        line: "Every texel of the unfiltered map compared with the receiver's own plane, by the blur's weights.",
        exact: true, settings: {}, formats: [],
    },
};

// What a map is stored and filtered in before it is coded, if it is.
export const formatOfMap = (technique, side) => (technique.coded ? "fp32" : side.format);

export const sliceCount = (technique, side) => technique.slices?.(side) ?? 1;
