// The README's quick start in three.js, and beside it what happens when something in it is another way.
import * as THREE from "three";
import {lloydRelax, optimalSplits} from "/wasm/lvsm.mjs";
import {ShadowScene} from "./shadow_scene.js";

const FLOOR = 1.0e-5;
const HALF = {type: THREE.HalfFloatType};
const FULL = {type: THREE.FloatType};
const BACK = {side: THREE.BackSide};

const bracketed = ({floor = FLOOR, amount = 0} = {}) => `
    vec4 store(float depth, float split)
    {
        return lvsm_packLayers(lvsm_layerMoments(depth, vec2(0.0, split)), lvsm_layerMoments(depth, vec2(split, 1.0)));
    }
    float visibility(vec4 texel, float depth, float split)
    {
        float bound = lvsm_bracketedVisibility2(texel, depth, split, float(${floor}));
        return lvsm_reduceLightBleeding(bound, float(${amount}));
    }`;

const layered = ({floor = FLOOR, overlap = 0.02, amount = 0} = {}) => `
    vec2 interval(int layer, float split)
    {
        return lvsm_layerInterval(layer == 0 ? 0.0 : split, layer == 0 ? split : 1.0, float(${overlap}));
    }
    vec4 store(float depth, float split)
    {
        vec2 near = lvsm_layerMoments(depth, interval(0, split));
        return lvsm_packLayers(near, lvsm_layerMoments(depth, interval(1, split)));
    }
    float visibility(vec4 texel, float depth, float split)
    {
        int layer = depth >= split ? 1 : 0;
        vec2 moments = lvsm_unpackLayer(texel, layer);
        float bound = lvsm_layeredVisibility(moments, depth, interval(layer, split), float(${floor}));
        return lvsm_reduceLightBleeding(bound, float(${amount}));
    }`;

const variance = ({amount = 0} = {}) => `
    vec4 store(float depth, float split) { return vec4(lvsm_depthMoments(depth), 0.0, 0.0); }
    float visibility(vec4 texel, float depth, float split)
    {
        return lvsm_reduceLightBleeding(lvsm_chebyshevUpperBound(texel.xy, depth, ${FLOOR}), float(${amount}));
    }`;

const exponential = (positive, negative, {floor = 1e-6, amount = 0} = {}) => `
    const vec2 exponents = vec2(${positive}, ${negative});
    vec4 store(float depth, float split) { return lvsm_exponentialMoments(depth, exponents); }
    float visibility(vec4 texel, float depth, float split)
    {
        float bound = lvsm_exponentialVisibility4(texel, depth, exponents, float(${floor}));
        return lvsm_reduceLightBleeding(bound, float(${amount}));
    }`;

// What is tried: name, chunk, split, and how the map is drawn.
function* trials(chunk, lloyd, optimal) {
    yield ["quick start", chunk, optimal, HALF];
    yield ["VSM", variance(), 0.5, HALF];
    for (const [name, make] of [["bracketed", bracketed], ["layered", layered]]) {
        for (const [where, split] of [["uniform", 0.5], ["lloydRelax", lloyd], ["optimalSplits", optimal],
                                      ["0.3", 0.3], ["0.4", 0.4], ["0.6", 0.6]])
            yield [`${name}, split ${where}`, make(), split, HALF];
        const best = name === "bracketed" ? optimal : lloyd;
        for (const floor of [0, 1e-6, 1e-4])
            yield [`${name}, minVariance ${floor}`, make({floor}), best, HALF];
        yield [`${name}, reduced by 0.1`, make({amount: 0.1}), best, HALF];
        yield [`${name}, back faces`, make(), best, {...HALF, ...BACK}];
    }
    for (const overlap of [0, 0.005, 0.1])
        yield [`layered, overlap ${overlap}`, layered({overlap}), lloyd, HALF];
    yield ["VSM, reduced by 0.1", variance({amount: 0.1}), 0.5, HALF];
    yield ["EVSM4 40/10 rgba32f", exponential("40.0", "10.0"), 0.5, FULL];
    yield ["EVSM4 40/10 rgba32f, minVariance 0.00001", exponential("40.0", "10.0", {floor: FLOOR}), 0.5, FULL];
    yield ["EVSM4 40/10 rgba32f, reduced by 0.1", exponential("40.0", "10.0", {amount: 0.1}), 0.5, FULL];
    yield ["EVSM4 40/10 rgba32f, back faces", exponential("40.0", "10.0"), 0.5, {...FULL, ...BACK}];
    yield ["EVSM4 40/10 rgba16f", exponential("40.0", "10.0"), 0.5, HALF];
    yield ["EVSM4 5.5/5.5 rgba16f", exponential("5.5", "5.5", {floor: FLOOR}), 0.5, HALF];
    yield ["EVSM4 5.5/5.5 rgba16f, reduced by 0.1", exponential("5.5", "5.5", {floor: FLOOR, amount: 0.1}), 0.5, HALF];
}

// chunk: the README's GLSL. The error of each trial, the splits that were placed, and two pictures.
export async function main(chunk) {
    const scene = new ShadowScene(await (await fetch("/single/lvsm_all.glsl")).text());
    const {depths, width, height} = scene.readDepths();
    const lloyd = lloydRelax(depths, width, height, 2).splits[1];
    const optimal = optimalSplits(depths, width, height, 2).splits[1];
    const errors = {};
    const pictures = {truth: scene.picture(scene.truth)};
    for (const [name, trial, split, how] of trials(chunk, lloyd, optimal)) {
        const pixels = scene.technique(trial, {split}, how);
        errors[name] = scene.error(pixels);
        if (name === "quick start")
            pictures[name] = scene.picture(pixels);
    }
    return {errors, lloyd, optimal, pictures};
}
