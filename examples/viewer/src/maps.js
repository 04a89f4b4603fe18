// From the light's depths to what a technique reads: the library's passes store.frag, blur.frag and mip.frag over every
// slice, or mixture.frag.
import * as THREE from "three";
import store from "lvsm/shaders/lvsm_store.frag";
import blur from "lvsm/shaders/lvsm_blur.frag";
import mip from "lvsm/shaders/lvsm_mip.frag";
import mixture from "lvsm/shaders/lvsm_mixture.frag";
import {largestOf, FORMATS, textureOptions} from "./formats.js";
import {codeText, constantsOf, maxLayersFor, storeText, uniformDeclarations, withoutVersion} from "./glsl.js";
import {blurBlock, fetchesOf, mipBlock, storeBlock} from "./kernel.js";
import {mixtureDraws} from "./mixtures.js";
import {uniformsOf} from "./passes.js";
import {formatOfMap, sliceCount, TECHNIQUES} from "./techniques.js";

const STORE = withoutVersion(store);
const BLUR = withoutVersion(blur);
const MIP = withoutVersion(mip);
const MIXTURE = withoutVersion(mixture);
const NEAREST = {minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter};

export function valuesOf(technique, side, frame) {
    const maxLayers = maxLayersFor(side, technique);
    return constantsOf(technique, side, frame).map(([type, name, value]) => {
        const padded = type === "splits" ? Array.from({length: maxLayers + 1}, (_, i) => value[i] ?? 1) : value;
        return [name, type === "vec2" ? new THREE.Vector2(...padded) : padded];
    });
}

export class MapMaker {
    #borders = new Map();

    constructor(passes, timer) {
        this.passes = passes;
        this.timer = timer;
    }

    storeMaterial(technique, side, frame, depths) {
        const constants = constantsOf(technique, side, frame);
        const fragment = `#include <lvsm>\n${uniformDeclarations(constants)}${storeText(technique)}
            #define LVSM_STORE(depth, slice) store(depth, slice)
            #define LVSM_STORE_LARGEST float(${largestOf(formatOfMap(TECHNIQUES[technique], side))})\n${STORE}`;
        const uniforms = uniformsOf(Object.fromEntries(valuesOf(technique, side, frame)));
        return this.passes.material(fragment, {...uniforms, lvsm_depths: {value: depths}},
                                    {defines: {LVSM_MAX_LAYERS: maxLayersFor(side, technique)}});
    }

    // What an empty texel of each slice holds: what is stored for depth 1.
    borders(technique, side, frame) {
        const count = sliceCount(TECHNIQUES[technique], side);
        const key = JSON.stringify([technique, side.format, valuesOf(technique, side, frame)]);
        if (!this.#borders.has(key)) {
            this.#borders.clear();
            const one = new THREE.DataTexture(new Float32Array([1]), 1, 1, THREE.RedFormat, THREE.FloatType);
            one.needsUpdate = true;
            const target = this.passes.target("border", {width: 1, height: 1, type: THREE.FloatType, depthBuffer: false,
                                                          minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
            const material = this.storeMaterial(technique, side, frame, one);
            const read = Array.from({length: count}, (_, slice) => {
                this.passes.drawOver(target, material, {block: storeBlock(1, slice)});
                return [...this.passes.read(target, 1, 1)];
            });
            one.dispose();
            this.#borders.set(key, read);
        }
        return this.#borders.get(key);
    }

    // The map of a side, stored and blurred, and the unblurred one, all slices of a face of the light one after the other.
    // depths: for each face a target of linear depths. frame: what it knows of kernel, splits, mip maps and anisotropy.
    make(name, technique, side, frame, depths) {
        const {channels, filtered, unfiltered, coded, planes} = TECHNIQUES[technique];
        if (planes) {
            const codes = this.timer.measured(`${name} mixtures`, () => this.makeMixtures(name, planes, side, depths));
            return {map: codes, unfiltered: codes};
        }
        const own = sliceCount(TECHNIQUES[technique], side);
        const slices = own * depths.length;
        const size = frame.size;
        const optionsOf = (format, filter) => ({width: size, height: size, slices, normalized: FORMATS[format].normalized,
                                                ...textureOptions(format, channels), minFilter: filter, magFilter: filter});
        const plain = optionsOf(formatOfMap(TECHNIQUES[technique], side), filtered ? THREE.LinearFilter : THREE.NearestFilter);
        const hasLevels = filtered && !coded && frame.mipmaps;
        const last = hasLevels ? {...plain, levels: Math.log2(size) + 1, minFilter: THREE.LinearMipmapLinearFilter,
                                  anisotropy: frame.anisotropy} : plain;
        const isBlurred = filtered && frame.kernel.taps > 1;

        const stored = this.passes.target(`${name}.stored`, isBlurred ? plain : last);
        this.timer.measured(`${name} store`, () => depths.forEach(({texture}, face) => {
            const material = this.storeMaterial(technique, side, frame, texture);
            for (let slice = 0; slice < own; ++slice)
                this.passes.drawOver(stored, material, {slice: own * face + slice, block: storeBlock(size, slice)});
        }));
        let map = stored;
        if (isBlurred) {
            map = this.passes.target(`${name}.blurred`, last);
            const halfway = this.passes.target(`${name}.halfway`, {...plain, slices: 1});
            const borders = depths.flatMap(() => this.borders(technique, side, frame));
            this.timer.measured(`${name} blur`, () => this.blur(stored, halfway, map, borders, frame));
        }
        if (coded) {
            const codes = this.passes.target(`${name}.coded`, optionsOf(side.format, THREE.NearestFilter));
            this.timer.measured(`${name} code`, () => this.code(map, codes, technique, side, frame, slices));
            return {map: codes.texture, unfiltered: codes.texture};
        }
        if (hasLevels)
            this.timer.measured(`${name} levels`, () => this.makeLevels(map, plain, slices));
        return {map: map.texture, unfiltered: unfiltered ? stored.texture : map.texture};
    }

    // The codes of every face, one slice each. planes: two or four.
    makeMixtures(name, planes, {window: width, half, format}, depths) {
        const {blocks, coded, between} = mixtureDraws(width, half, depths[0].width);
        const target = (part, side, slices, channels) => this.passes.target(
            `${name}.${part}`, {width: side, height: side, slices, ...textureOptions(format, channels), ...NEAREST});
        const codes = target("codes", coded, depths.length, planes);
        const mixtures = blocks.slice(1).map((_, i) => target(`mixtures${i % 2}`, between, planes, 4));
        depths.forEach((depth, face) => blocks.forEach((block, i) => {
            const [source, next] = [mixtures[i - 1] ?? depth, mixtures[i]];
            const defines = {LVSM_MIXTURE_COUNT: planes, ...(source !== depth && {LVSM_MIXTURE_FROM_MIXTURES: ""}),
                             ...(next && {LVSM_MIXTURE_TO_MIXTURES: ""})};
            const material = this.passes.material(MIXTURE, {lvsm_source: {value: source.texture}}, {defines});
            this.passes.drawOver(next ?? codes, material, next ? {block, layers: planes} : {block, slice: face});
        }));
        return codes.texture;
    }

    blur(stored, halfway, blurred, borders, {kernel, size}) {
        const fetches = fetchesOf(kernel);
        borders.forEach((border, slice) => {
            for (const [from, to, direction, source, target] of [[stored, halfway, [1, 0], slice, 0],
                                                                 [halfway, blurred, [0, 1], 0, slice]]) {
                const material = this.passes.material(BLUR, {lvsm_source: {value: from.texture}});
                this.passes.drawOver(to, material, {slice: target, block: blurBlock(fetches, size, direction, border, source)});
            }
        });
    }

    code(from, to, technique, side, frame, slices) {
        const fragment = `#include <lvsm>\n${uniformDeclarations(constantsOf(technique, side, frame))}${codeText(technique)}
            uniform highp sampler2DArray moments;
            uniform int slice;
            layout(location = 0) out vec4 result;
            void main() { result = code(texelFetch(moments, ivec3(gl_FragCoord.xy, slice), 0)); }`;
        for (let slice = 0; slice < slices; ++slice) {
            const values = Object.fromEntries(valuesOf(technique, side, frame));
            const uniforms = uniformsOf({...values, moments: from.texture, slice});
            const defines = {LVSM_MAX_LAYERS: maxLayersFor(side, technique)};
            this.passes.drawOver(to, this.passes.material(fragment, uniforms, {defines}), {slice});
        }
    }

    // Drawn beside the map and copied into it: WebGL does not draw to a texture that it reads.
    makeLevels(map, plain, slices) {
        const material = this.passes.material(MIP, {lvsm_source: {value: map.texture}});
        const size = plain.width;
        const beside = this.passes.target("level", {...plain, width: size / 2, height: size / 2, slices: 1});
        for (let level = 1; size >> level > 0; ++level) {
            for (let slice = 0; slice < slices; ++slice) {
                this.passes.drawOver(beside, material, {extent: size >> level, block: mipBlock(size, level, slice)});
                this.passes.copyInto(map, slice, level, size >> level);
            }
        }
    }
}
