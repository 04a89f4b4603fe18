// What each view shows, for the line below it.
import {element} from "./panel.js";

const ERROR = "linear-gradient(90deg, #214099, #92c4de, #f7f7f7, #fcb863, #b35905)";
const RAMP = "linear-gradient(90deg, #450054, #3b528c, #21918c, #5ec962, #fde724)";

const ramp = (background) => element("span", {className: "ramp", style: `background: ${background}`, "aria-hidden": "true"});

// Those of show.frag.glsl.
const LAYERS = ["#e69e00", "#57b5e8", "#009e73", "#f0e342", "#2680cc", "#d65e00", "#cc78a6", "#bfbfbf"];
const swatch = (colour, i) => element("span", {className: "swatch", style: `background: ${colour}`, textContent: i + 1});

const VIEWS = {
    shaded: () => ["As lit, with a little light from all around."],
    visibility: () => ["Share of the light that arrives: white all, black none. Slate: turned away, or off the map."],
    error: () => ["Against exact filtered visibility: 0.5 too dark", ramp(ERROR), "0.5 too light"],
    layers: () => ["The layer that judges each receiver, from the light on: ", ...LAYERS.map(swatch), " and so on."],
    mean: () => ["Mean of the depths in the map at each receiver: 0", ramp(RAMP), "1"],
    spread: () => ["Standard deviation of the depths in the map at each receiver: 0", ramp(RAMP), "0.25"],
};

export const describeView = (view) => VIEWS[view]();
