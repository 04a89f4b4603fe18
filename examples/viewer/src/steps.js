// Splits relaxed on the device, the paper's way: two move with each frame, by fragment passes and levels of a map. The
// state stays a texture; only what the uniforms need of it is read back.
import * as THREE from "three";
import move from "lvsm/shaders/lvsm_step_move.frag";
import sums from "lvsm/shaders/lvsm_step_sums.frag";
import {withoutVersion} from "./glsl.js";
import {uniformsOf} from "./passes.js";
import {RELAX} from "./splits.js";

const [MOVE, SUMS] = [move, sums].map(withoutVersion);
const FLOATS = {type: THREE.FloatType, depthBuffer: false, minFilter: THREE.NearestFilter,
                magFilter: THREE.NearestFilter};
const MAX_LAYERS = 16;
const WIDTH = (MAX_LAYERS + 4) / 4;
// What moves less is at rest, and after so many frames whatever it does.
const REST = 2 ** -16;
const MOST_FRAMES = 200;
// Of the six faces of a point light the one below.
const FACE_BELOW = 3;

// The block lvsm_Step, as StepBlock of include/lvsm/passes_step.hpp.
function stepBlock(size, layers, frame, level) {
    const data = new ArrayBuffer(48);
    new Int32Array(data, 0, 8).set([0, 0, size, size, layers, frame, 0, level]);
    new Float32Array(data, 32, 2).set([RELAX.minVariance, 1]);
    return data;
}

// Uniform splits, as startPlaceState has them.
function startState(layers) {
    const state = new Float32Array(8 * WIDTH).fill(1);
    for (let i = 0; i < layers; ++i)
        state[i] = i / layers;
    state[4 * WIDTH] = -(2 * (layers - 1) + 1);
    const texture = new THREE.DataTexture(state, WIDTH, 2, THREE.RGBAFormat, THREE.FloatType);
    texture.needsUpdate = true;
    return texture;
}

export class Steps {
    // maps: a MapMaker, which makes the levels.
    constructor(passes, maps, name) {
        Object.assign(this, {passes, maps, name});
    }

    // From uniform splits on.
    restart(layers) {
        this.layers = layers;
        this.frame = 0;
        this.restingFrames = 0;
        this.splits = undefined;
        this.state = startState(layers);
    }

    // Every split has had its turn, and none has moved.
    get isAtRest() {
        return this.restingFrames > this.layers || this.frame > MOST_FRAMES;
    }

    // One step; targets: of linear depths, one for each face of the light. Gives the splits.
    step(targets, layers) {
        if (this.layers !== layers)
            this.restart(layers);
        const depths = targets[FACE_BELOW] ?? targets[0];
        const size = depths.width;
        const last = Math.log2(size);
        const block = stepBlock(size, layers, this.frame, last);
        const plain = {width: size, height: size, slices: 1, ...FLOATS};
        const sumsTarget = this.passes.target(`${this.name}.sums`, {...plain, levels: last + 1});
        this.draw(sumsTarget, SUMS, {lvsm_depths: depths.texture}, block);
        this.maps.makeLevels(sumsTarget, plain, 1);
        const next = this.passes.target(`${this.name}.state${this.frame % 2}`, {width: WIDTH, height: 2, ...FLOATS});
        this.draw(next, MOVE, {lvsm_sums: sumsTarget.texture}, block);
        this.state = next.texture;
        ++this.frame;

        const splits = [...this.passes.read(next, WIDTH, 2).subarray(0, layers + 1)];
        const movement = Math.max(...splits.map((split, i) => Math.abs(split - (this.splits?.[i] ?? 0))));
        this.restingFrames = movement < REST ? this.restingFrames + 1 : 0;
        this.splits = splits;
        return splits;
    }

    draw(target, fragment, textures, block) {
        const material = this.passes.material(fragment, uniformsOf({...textures, lvsm_state: this.state}),
                                              {defines: {LVSM_MAX_LAYERS: MAX_LAYERS}});
        this.passes.drawOver(target, material, {block});
    }
}
