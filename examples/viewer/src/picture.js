// One frame: the light's depths, both sides' maps and judgements, the exact answer, and what is shown of them.
import * as THREE from "three";
import library from "lvsm/glsl";
import sampling from "lvsm/shaders/lvsm_combined.glsl";
import sceneVertex from "../shaders/scene.vert.glsl";
import lightGlsl from "../shaders/light.glsl";
import depthFragment from "../shaders/depth.frag.glsl";
import surfaceFragment from "../shaders/surface.frag.glsl";
import judgeFragment from "../shaders/judge.frag.glsl";
import exactFragment from "../shaders/exact.frag.glsl";
import measureFragment from "../shaders/measure.frag.glsl";
import showFragment from "../shaders/show.frag.glsl";
import {constantsOf, judgeText, maxLayersFor, samplerOf, storeText, storedText, uniformDeclarations} from "./glsl.js";
import {MapMaker, valuesOf} from "./maps.js";
import {Passes, uniformsOf} from "./passes.js";
import {sliceCount, TECHNIQUES} from "./techniques.js";
import {Steps} from "./steps.js";
import {Timer} from "./timer.js";

Object.assign(THREE.ShaderChunk, {lvsm: library, lvsm_sampling: sampling, viewer_light: lightGlsl});

const MAX_TAPS = 17;
const BLOCK = 8;
const PLACEMENT_SIZE = 256;
const VIEWS = ["shaded", "visibility", "error", "layers", "mean", "spread"];
const DEPTHS = {type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter};
const JUDGED = {type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter};

export class Picture {
    constructor(canvas) {
        this.renderer = new THREE.WebGLRenderer({canvas, antialias: false, alpha: false, depth: false});
        this.renderer.autoClear = false;
        this.passes = new Passes(this.renderer, sceneVertex);
        this.timer = new Timer(this.renderer.getContext());
        this.maps = new MapMaker(this.passes, this.timer);
        this.steps = {left: new Steps(this.passes, this.maps, "left"), right: new Steps(this.passes, this.maps, "right")};
        this.white = new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
        this.white.needsUpdate = true;
        this.shared = uniformsOf({toLight: null, fromLight: null, lightPosition: null, lightDirection: null, lightRange: null,
                                  lightCone: null, faceCount: 1, tangent: 1, albedo: this.white, cutoff: 0});
        this.scene = new THREE.Scene();
        canvas.addEventListener("webglcontextrestored", () => {
            this.passes.forget();
            this.timer.reset(this.renderer.getContext());
            this.forgetSteps();
        });
    }

    setScene({meshes}) {
        this.scene.traverse((object) => object.geometry?.dispose());
        this.scene.clear();
        for (const mesh of meshes) {
            mesh.frustumCulled = false;
            mesh.onBeforeRender = (renderer, scene, camera, geometry, material) => {
                this.shared.albedo.value = mesh.userData.map ?? this.white;
                this.shared.cutoff.value = mesh.userData.cutoff ?? 0;
                material.uniformsNeedUpdate = true;
            };
            this.scene.add(mesh);
        }
    }

    // The splits that move with each frame begin anew.
    forgetSteps() {
        for (const steps of Object.values(this.steps))
            steps.layers = undefined;
    }

    setSize(width, height) {
        this.renderer.setSize(width, height, false);
        this.width = width;
        this.height = height;
    }

    setLight(light) {
        this.light = light;
        const {toLight, fromLight, position, direction, range, cone, tangent, cameras} = light;
        const values = {toLight, fromLight, lightPosition: position, lightDirection: direction, lightRange: range,
                        lightCone: cone, tangent, faceCount: cameras.length};
        for (const [name, value] of Object.entries(values))
            this.shared[name].value = value;
    }

    clear(target, red, green, blue, alpha, depth) {
        this.renderer.setRenderTarget(target);
        this.renderer.setClearColor(new THREE.Color(red, green, blue), alpha);
        this.renderer.clear(true, depth, false);
    }

    // A texture of depths for each face of the light.
    drawDepths(name, size, format = THREE.RedFormat) {
        const material = this.passes.material(depthFragment, this.shared, {isScene: true});
        return this.light.cameras.map((camera, face) => {
            const target = this.passes.target(`${name}.${face}`, {width: size, height: size, ...DEPTHS, format});
            this.clear(target, 1, 1, 1, 1, true);
            this.passes.drawScene(target, material, this.scene, camera);
            return target;
        });
    }

    // The light's depths for placing splits: a small map tells them as well as a large one. Every device reads back four
    // components, and not every one a single one.
    drawPlacement() {
        const size = this.light.cameras.length > 1 ? PLACEMENT_SIZE / 2 : PLACEMENT_SIZE;
        return this.drawDepths("placement", size, THREE.RGBAFormat);
    }

    // The same, row by row and face by face. targets: of drawPlacement.
    readDepths(targets) {
        const [faces, size] = [targets.length, targets[0].width];
        const depths = new Float32Array(faces * size * size);
        targets.forEach((target, face) => {
            const read = this.passes.read(target, size, size);
            depths.set(read.filter((_, index) => index % 4 === 0), face * size * size);
        });
        return {depths, width: size, height: faces * size};
    }

    drawSurface(camera) {
        const target = this.passes.target("surface", {width: this.width, height: this.height, count: 2, ...JUDGED,
                                                      type: THREE.HalfFloatType});
        this.clear(target, 0, 0, 0, 0, true);
        const material = this.passes.material(surfaceFragment, this.shared, {isScene: true});
        this.passes.drawScene(target, material, this.scene, camera);
        return target;
    }

    drawJudged(name, material, camera) {
        const target = this.passes.target(name, {width: this.width, height: this.height, ...JUDGED});
        this.clear(target, 1, 0, 0, 0, true);
        this.passes.drawScene(target, material, this.scene, camera);
        return target.texture;
    }

    judgeMaterial(technique, side, frame, {map, unfiltered}) {
        const {layered, unfiltered: takesUnfiltered} = TECHNIQUES[technique];
        const constants = constantsOf(technique, side, frame);
        const fragment = `#include <lvsm>\n#include <lvsm_sampling>\n${uniformDeclarations(constants)}
            ${storeText(technique)}${judgeText(technique)}${storedText(technique)}
            #define MAP_SAMPLER ${samplerOf(technique)}
            #define LAYER ${layered ? "float(lvsm_layerIndex(depth, splits, layerCount))" : "0.0"}
            #define VISIBILITY visibility(map, ${takesUnfiltered ? "unfiltered, " : ""}at, depth, gradient)
            ${judgeFragment}`;
        const uniforms = uniformsOf({map, unfiltered, mapSize: frame.size, slicesOfFace: sliceCount(TECHNIQUES[technique], side),
                                     ...Object.fromEntries(valuesOf(technique, side, frame))});
        return this.passes.material(fragment, {...this.shared, ...uniforms},
                                    {isScene: true, defines: {LVSM_MAX_LAYERS: maxLayersFor(side, technique)}});
    }

    // The exact answer for what was drawn last; drawn once for it.
    drawExact() {
        if (this.drawn.exact)
            return;
        const {kernel, camera, depths, size} = this.drawn;
        const weights = Array.from({length: MAX_TAPS}, (_, i) => kernel.weights[i] ?? 0);
        // All faces in one array, which is what a plain shadow map is.
        const {map} = this.maps.make("exact", "basic", {format: "fp32", bias: 0}, {size, kernel}, depths);
        const uniforms = uniformsOf({map, weights, radius: kernel.radius});
        const material = this.passes.material(exactFragment, {...this.shared, ...uniforms},
                                              {isScene: true, defines: {MAX_TAPS}});
        this.drawn.exact = this.timer.measured("exact", () => this.drawJudged("exact", material, camera));
    }

    // sides: {left, right}, each {technique, side, frame}: the settings of a side and what the frame knows.
    draw(camera, size, kernel, sides) {
        this.timer.begin();
        const depths = this.timer.measured("depth", () => this.drawDepths("depths", size));
        const surface = this.timer.measured("surface", () => this.drawSurface(camera));
        const [colours, arriving] = surface.textures;
        this.drawn = {kernel, camera, depths, size, colours, arriving, exact: null};
        for (const [name, {technique, side, frame}] of Object.entries(sides)) {
            if (technique === "exact") {
                this.drawExact();
                this.drawn[name] = this.drawn.exact;
                continue;
            }
            const made = this.maps.make(name, technique, side, frame, depths);
            this.drawn[name] = this.timer.measured(`${name} judge`, () => this.drawJudged(
                `${name}.judged`, this.judgeMaterial(technique, side, frame, made), camera));
        }
    }

    // divider: from 0 to 1 of the width. background: a colour where there is no surface.
    show(view, divider, background) {
        const {colours, arriving, left, right, exact} = this.drawn;
        const uniforms = uniformsOf({colours, arriving, left, right, exact: exact ?? left, view: VIEWS.indexOf(view),
                                     divider: divider * this.width, background});
        this.passes.drawOver(null, this.passes.material(showFragment, uniforms));
    }

    // Root mean square error of a side, and its means of too light and too dark; drawExact before.
    measure(name) {
        const [width, height] = [this.width, this.height].map((length) => Math.ceil(length / BLOCK));
        const target = this.passes.target("sums", {width, height, ...JUDGED, depthBuffer: false});
        const uniforms = uniformsOf({arriving: this.drawn.arriving, exact: this.drawn.exact, judged: this.drawn[name]});
        this.passes.drawOver(target, this.passes.material(measureFragment, uniforms, {defines: {BLOCK}}));
        const read = this.passes.read(target, width, height);
        const sums = [0, 0, 0, 0];
        read.forEach((value, index) => sums[index % 4] += value);
        const [weight, squares, lighter, darker] = sums;
        return weight > 0 ? {rmse: Math.sqrt(squares / weight), lighter: lighter / weight, darker: darker / weight} : null;
    }
}
