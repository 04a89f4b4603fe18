// Where the layers are cut: equal, placed by the library's host functions, or by hand on the histogram of the depths.
import {element} from "./panel.js";

const BINS = 128;
const LEAST_GAP = 0.002;

// Splits relaxed on second occluders leave out what hardly bleeds, as the gallery does: depths that differ by less than
// a fifth of the range.
export const RELAX = {minVariance: 0.01};

export function uniformSplits(layers) {
    return Array.from({length: layers + 1}, (_, i) => i / layers);
}

// host: lloydRelax and optimalSplits. image: depths, width, height. previous: splits of the last frame, or undefined.
export function placeSplits(placement, layers, byHand, host, {depths, width, height}, previous) {
    if (placement === "uniform")
        return uniformSplits(layers);
    if (placement === "manual")
        return byHand?.length === layers + 1 ? byHand : uniformSplits(layers);
    const kept = previous?.length === layers + 1 ? {keepSplits: true, splits: new Float32Array(previous)} : {};
    const {splits} = placement === "relaxed" ? host.lloydRelax(depths, width, height, layers, {...RELAX, ...kept})
                                             : host.optimalSplits(depths, width, height, layers);
    return [...splits];
}

export function histogramOf(depths) {
    const counts = new Float32Array(BINS);
    // At the ends lies what is beyond the range, too.
    for (const depth of depths)
        if (depth > 0 && depth < 1)
            ++counts[Math.floor(depth * BINS)];
    const most = Math.max(...counts, 1);
    // Small peaks matter as much as the ground's large one.
    return counts.map((count) => Math.cbrt(count / most));
}

// The drawn histogram with a handle at each inner split.
export class SplitEditor {
    constructor(state, side) {
        Object.assign(this, {state, side});
        this.bars = element("div", {className: "bars", "aria-hidden": "true"});
        this.track = element("div", {className: "track"});
        const line = "Depths that the light sees, near to far. Drag a split, or focus it and use the arrow keys.";
        this.root = element("div", {className: "splits", role: "group", "aria-label": "The splits between the layers"},
                            this.bars, this.track, element("p", {className: "line", textContent: line}));
    }

    update(splits, histogram) {
        this.splits = splits;
        this.bars.style.background = gradientOf(histogram);
        const inner = splits.slice(1, -1);
        while (this.track.children.length > inner.length)
            this.track.lastChild.remove();
        while (this.track.children.length < inner.length)
            this.track.append(this.handle(this.track.children.length + 1));
        inner.forEach((split, i) => {
            const handle = this.track.children[i];
            handle.style.left = `${100 * split}%`;
            handle.setAttribute("aria-valuenow", split.toFixed(3));
        });
    }

    handle(index) {
        const made = element("div", {className: "split", tabIndex: 0, role: "slider", "aria-label": `Split ${index}`,
                                     "aria-valuemin": 0, "aria-valuemax": 1});
        made.addEventListener("keydown", (event) => {
            const step = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10}[event.key];
            if (!step)
                return;
            event.preventDefault();
            this.move(index, this.splits[index] + 0.005 * step);
        });
        made.addEventListener("pointerdown", (event) => {
            made.setPointerCapture(event.pointerId);
            event.preventDefault();
            made.focus();
        });
        made.addEventListener("pointermove", (event) => {
            if (!made.hasPointerCapture(event.pointerId))
                return;
            const {left, width} = this.track.getBoundingClientRect();
            this.move(index, (event.clientX - left) / width);
        });
        return made;
    }

    // A split stays between its neighbours.
    move(index, to) {
        const splits = [...this.splits];
        splits[index] = Math.min(Math.max(to, splits[index - 1] + LEAST_GAP), splits[index + 1] - LEAST_GAP);
        this.splits = splits;
        this.state.set(`${this.side}.splits`, splits);
        this.state.set(`${this.side}.placement`, "manual");
    }
}

// The histogram as bars of one background image, which scales with the page.
function gradientOf(histogram) {
    const bar = (height, i) => `<rect x="${i}" y="${(40 * (1 - height)).toFixed(2)}" width="1" height="40"/>`;
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${histogram.length} 40" fill="#888" ` +
        `preserveAspectRatio="none">${[...histogram].map(bar).join("")}</svg>`;
    return `url("data:image/svg+xml,${encodeURIComponent(svg)}") 0 0 / 100% 100%`;
}
