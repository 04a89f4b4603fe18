// When what is drawn: a change asks for a frame, and some moments of rest later its error is measured.
import * as THREE from "three";
import * as host from "lvsm/host";
import {makeKernel} from "./kernel.js";
import {directionOf, makeLight} from "./light.js";
import {histogramOf, placeSplits} from "./splits.js";
import {TECHNIQUES} from "./techniques.js";

export const SIDES = ["left", "right"];

const SWING = 30;
const SWING_SECONDS = 8;
const MEASURE_AFTER = 250;
const BACKGROUND = {light: [0.80, 0.84, 0.88], dark: [0.12, 0.14, 0.17]};

export class Loop {
    splits = {};
    // {rmse, lighter, darker} of each side, as long as they are those of what is shown.
    figures = {};
    // Counts the frames, for who waits for the next.
    frames = 0;

    // viewer: state, device, picture, camera, scene, and drawn() and placed(side, splits, histogram), which are told.
    constructor(viewer, stage) {
        Object.assign(this, {viewer, stage, state: viewer.state, picture: viewer.picture});
        this.dark = matchMedia("(prefers-color-scheme: dark)");
        this.dark.addEventListener("change", () => this.invalidate());
        new ResizeObserver(() => this.invalidate()).observe(stage);
        const canvas = this.picture.renderer.domElement;
        canvas.addEventListener("webglcontextlost", () => this.isLost = true);
        canvas.addEventListener("webglcontextrestored", () => {
            this.isLost = false;
            this.invalidate();
        });
    }

    kernel() {
        return makeKernel(this.state.get("kernel"), this.state.get("taps"));
    }

    // onlyShown: that the maps and what is judged by them stay as they are.
    invalidate(onlyShown = false) {
        if (!onlyShown) {
            this.isStale = true;
            this.figures = {};
        }
        this.request ??= requestAnimationFrame((time) => {
            this.request = undefined;
            this.frame(time);
        });
        clearTimeout(this.measureTimer);
        this.isSettled = false;
    }

    // Resolves when all that was asked for is drawn and measured.
    settled() {
        return new Promise((resolve) => {
            const look = () => (this.isSettled ? resolve() : setTimeout(look, 20));
            look();
        });
    }

    resize() {
        const {width, height} = this.stage.getBoundingClientRect();
        const ratio = Math.min(devicePixelRatio, 2);
        const [w, h] = [width, height].map((length) => Math.max(Math.round(length * ratio), 1));
        if (w !== this.picture.width || h !== this.picture.height)
            this.picture.setSize(w, h);
        this.viewer.camera.setAspect(w / h);
    }

    light(time) {
        const {scene} = this.viewer;
        const swing = this.state.get("moving") ? SWING * Math.sin(2 * Math.PI * time / 1000 / SWING_SECONDS) : 0;
        const isOwn = !this.state.isSet("azimuth") && !this.state.isSet("elevation") && swing === 0;
        const direction = isOwn ? new THREE.Vector3(...scene.lightDirection)
                                : directionOf(this.state.get("azimuth") + swing, this.state.get("elevation"));
        const map = {size: this.mapSize(), radius: this.kernel().radius};
        return makeLight(this.state.get("light"), scene.focus, direction, map);
    }

    mapSize() {
        return this.state.get("size") / (this.state.get("light") === "point" ? 2 : 1);
    }

    // What the techniques' constants need to know of the frame, beside the side's settings.
    frameOf(side) {
        return {size: this.mapSize(), kernel: this.kernel(), splits: this.splits[side],
                mipmaps: this.state.get("mipmaps"),
                anisotropy: Math.min(this.state.get("anisotropy"), this.viewer.device.anisotropy)};
    }

    placeLayers() {
        const layered = SIDES.filter((side) => TECHNIQUES[this.state.get(side)].layered);
        if (layered.length === 0)
            return;
        const targets = this.picture.drawPlacement();
        const image = this.picture.readDepths(targets);
        const histogram = histogramOf(image.depths);
        for (const side of layered) {
            const {placement, layers} = this.state.side(side);
            const previous = this.state.get("moving") ? this.splits[side] : undefined;
            this.splits[side] = placement === "steps" ? this.picture.steps[side].step(targets, layers)
                : placeSplits(placement, layers, this.state.get(`${side}.splits`), host, image, previous);
            this.viewer.placed(side, this.splits[side], histogram);
        }
    }

    // Whether a side's splits, which move with each frame, have not come to rest.
    isStepping(side) {
        return TECHNIQUES[this.state.get(side)].layered && this.state.get(`${side}.placement`) === "steps" &&
            !this.picture.steps[side].isAtRest;
    }

    drawAll(time) {
        this.resize();
        this.picture.setLight(this.light(time));
        this.placeLayers();
        const sides = Object.fromEntries(SIDES.map((side) => [
            side, {technique: this.state.get(side), side: this.state.side(side), frame: this.frameOf(side)}]));
        this.picture.draw(this.viewer.camera.camera, this.mapSize(), this.kernel(), sides);
        this.isStale = false;
    }

    show() {
        if (this.state.get("view") === "error")
            this.picture.drawExact();
        const background = new THREE.Vector3(...BACKGROUND[this.dark.matches ? "dark" : "light"]);
        this.picture.show(this.state.get("view"), this.state.get("divider"), background);
    }

    frame(time) {
        if (this.isLost)
            return;
        if (this.isStale)
            this.drawAll(time);
        this.show();
        ++this.frames;
        this.viewer.drawn();
        const isStepping = SIDES.some((side) => this.isStepping(side));
        if (this.state.get("moving") || isStepping)
            this.invalidate();
        else
            this.measureTimer = setTimeout(() => this.measure(), MEASURE_AFTER);
    }

    measure() {
        if (this.isLost)
            return;
        this.picture.drawExact();
        this.figures = Object.fromEntries(SIDES.map((side) => [side, this.picture.measure(side)]));
        this.isSettled = true;
        this.viewer.drawn();
        // Timer queries answer later.
        setTimeout(() => this.viewer.drawn(), 200);
    }
}
