// The techniques that cut the depths into layers; techniques.js says what a row holds.
import {FLOORED, floorOf, REDUCED, SHIFT, SHIFTED} from "./constants.js";

const floorOfLayer = (side) => floorOf(side.format) / side.layers ** 2;

const LAYERED = [
    ["int", "layerCount", (side) => side.layers],
    ["splits", "splits", (side, frame) => frame.splits],
];

const depthOfLayer = (moments, reach = "0.0") => `
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    vec2 moments = ${moments};
    vec2 interval = lvsm_layerInterval(splits[layer], splits[layer + 1], ${reach});
    return vec2(interval.x, 0.0) + (interval.y - interval.x) * vec2(moments.x, sqrt(lvsm_variance(moments, 0.0)));`;

const STORED_LAYERS = `vec4 store(float depth, int slice)
{
    vec2 even = lvsm_layerMoments(depth, vec2(splits[2 * slice], splits[2 * slice + 1]));
    vec2 odd = lvsm_layerMoments(depth, vec2(splits[2 * slice + 1], splits[2 * slice + 2]));
    return compact ? lvsm_packLayers(lvsm_compactMoments(even), lvsm_compactMoments(odd)) : lvsm_packLayers(even, odd);
}
`;
const COMPACT = [["bool", "compact", (side) => side.format === "unorm8"]];
const STORED_PAIR = depthOfLayer("lvsm_unpackLayer(lvsm_sampleLayerPair(map, at, layer / 2, compact), layer)");

const layerSettings = {layers: 4, placement: "optimal"};

export const LAYERED_TECHNIQUES = {
    lvsm: {
        name: "LVSM",
        line: "Layered variance, as in the paper: the depths cut into layers, and a receiver reads the one it lies in.",
        source: "Lauritzen & McCool 2008",
        formats: ["unorm16", "fp16", "fp32"], channels: 4, filtered: true, layered: true,
        settings: {...layerSettings, placement: "relaxed", overlap: 0.02, transition: 0.01, minVariance: floorOfLayer,
                   slope: true, reduction: 0, shift: SHIFT},
        slices: (side) => side.layers / 2,
        constants: [...LAYERED, ["float", "overlap", (side) => side.overlap],
                    ["float", "transition", (side) => Math.min(side.transition, side.overlap)], ...FLOORED, ...REDUCED,
                    ...SHIFTED],
        store: `vec2 layerMoments(float depth, int layer)
{
    return lvsm_layerMoments(depth, lvsm_layerInterval(splits[layer], splits[layer + 1], overlap));
}

vec4 store(float depth, int slice)
{
    return lvsm_packLayers(layerMoments(depth, 2 * slice), layerMoments(depth, 2 * slice + 1));
}
`,
        judge: `
    float least = lvsm_receiverMinVariance(minVariance, gradient, deviation);
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    float bound = lvsm_sampleLayers(map, at, receiver, splits, layerCount, overlap, transition, least);
    return lvsm_reduceLightBleeding(bound, amount);`,
        stored: depthOfLayer("lvsm_unpackLayer(lvsm_sampleSlice(map, at, layer / 2, vec4(1.0, 1.0, 1.0, 1.0)), layer)",
                             "overlap"),
    },
    bracketed: {
        name: "LVSM, bracketed",
        line: "The same layers without overlap; the neighbours tell what lies in front and behind. Begin with this one.",
        source: "this library, bracket",
        formats: ["unorm16", "fp16", "unorm8", "fp32"], channels: 4, filtered: true, layered: true,
        settings: {...layerSettings, minVariance: floorOfLayer, slope: true, reduction: 0, shift: SHIFT},
        slices: (side) => side.layers / 2,
        constants: [...LAYERED, ...COMPACT, ...FLOORED, ...REDUCED, ...SHIFTED],
        store: STORED_LAYERS,
        judge: `
    float least = lvsm_receiverMinVariance(minVariance, gradient, deviation);
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    float bound = lvsm_sampleBracketed(map, at, receiver, splits, layerCount, compact, least);
    return lvsm_reduceLightBleeding(bound, amount);`,
        stored: STORED_PAIR,
    },
    plane: {
        name: "LVSM, relative to the plane",
        line: "Bracketed layers judged relative to the receiver's plane: the least error of one filtered map.",
        source: "this library, plane",
        formats: ["unorm8", "unorm16", "fp16", "fp32"], channels: 4, filtered: true, layered: true,
        settings: {...layerSettings, layers: 8, minVariance: floorOfLayer, contact: 0.15, shift: SHIFT},
        slices: (side) => side.layers / 2,
        constants: [...LAYERED, ...COMPACT, ["float", "deviation", (side, frame) => frame.kernel.deviation],
                    ["float", "minVariance", (side) => side.minVariance],
                    ["float", "amount", (side) => side.contact], ...SHIFTED],
        store: STORED_LAYERS,
        judge: `
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    return lvsm_samplePlane(map, at, receiver, gradient, splits, layerCount, compact, deviation, minVariance, amount);`,
        stored: STORED_PAIR,
    },
    layers4: {
        name: "MSM4 in layers",
        line: "Four moments a layer, each with its two neighbours: exact for more occluders, for much more storage.",
        source: "this library, moments4",
        formats: ["unorm16", "fp32"], channels: 4, filtered: true, layered: true,
        settings: {...layerSettings, layers: 2, momentBias: 6e-5, reduction: 0, shift: SHIFT},
        slices: (side) => side.layers,
        constants: [...LAYERED, ["bool", "encoded", (side) => side.format === "unorm16"],
                    ["float", "bias", (side) => side.momentBias], ...REDUCED, ...SHIFTED],
        store: `vec4 store(float depth, int slice)
{
    vec4 moments = lvsm_layerMoments4(depth, vec2(splits[slice], splits[slice + 1]));
    return encoded ? lvsm_encodeMoments4(moments) : moments;
}
`,
        judge: `
    float receiver = lvsm_shiftReceiver(depth, gradient, shift);
    float bound = lvsm_sampleLayeredMoments4(map, at, receiver, splits, layerCount, encoded, bias);
    return lvsm_reduceLightBleeding(bound, amount);`,
        stored: `
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    vec4 moments = lvsm_sampleFourMoments(map, at, layer, encoded);
    vec2 depths = vec2(0.5 + 0.5 * moments.x, 0.5 * sqrt(max(moments.y - moments.x * moments.x, 0.0)));
    return vec2(splits[layer], 0.0) + (splits[layer + 1] - splits[layer]) * depths;`,
    },
};
