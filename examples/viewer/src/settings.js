// Every setting of the viewer: what the panel shows, what the address may hold, and the line that explains it. Those of a
// technique are named by techniques.js, which has their defaults, and exist once for each side of the divider.
import {SCENES} from "./scenes.js";
import {FORMATS} from "./formats.js";
import {MIXTURE_WIDTHS} from "./mixtures.js";
import {TECHNIQUES} from "./techniques.js";

const named = (table, key = "name") => Object.entries(table).map(([id, row]) => [id, row[key]]);
const numbered = (...values) => values.map((value) => [value, String(value)]);

const choice = (label, line, options, initial) => ({kind: "choice", label, line, options, initial});
const toggle = (label, line, initial) => ({kind: "toggle", label, line, initial});
const range = (label, line, min, max, step, initial) => ({kind: "range", label, line, min, max, step, initial});
// A range by factors, from a least value on, with 0 in front of it.
const scale = (label, line, min, max) => ({kind: "scale", label, line, min, max});

export const SETTINGS = {
    scene: choice("Scene", "What casts and receives.", named(SCENES, "title"), "bench"),
    light: choice("Light", "A directional light is far away; a spot light has a place and a cone, a point light six faces.",
                  [["directional", "Directional"], ["spot", "Spot"], ["point", "Point"]], "directional"),
    azimuth: range("Azimuth", "From where the light comes, in degrees around the vertical.", -180, 180, 1),
    elevation: range("Elevation", "How high the light stands, in degrees above the horizon.", 15, 90, 1),
    moving: toggle("Moving light", "The light swings to and fro; relaxed splits follow it.", false),
    size: choice("Map size", "Texels along each side of the shadow map; half as many for each face of a point light.",
                 numbered(256, 512, 1024, 2048), 512),
    kernel: choice("Blur", "Weights of the blur, which both sides and the exact answer share.",
                   [["binomial", "Binomial"], ["gaussian", "Gaussian"], ["box", "Box"], ["triangle", "Triangle"]], "binomial"),
    taps: choice("Blur width", "Texels in each direction; 1 leaves the map as it was drawn.",
                 numbered(1, 3, 5, 7, 9, 13, 17), 9),
    mipmaps: toggle("Mip maps", "Smaller levels of the map, for receivers far from the eye.", false),
    anisotropy: choice("Anisotropy", "Most samples along a stretched footprint, where there are mip maps.",
                       numbered(1, 2, 4, 8, 16), 1),
    view: choice("Show", "What the picture shows on both sides.",
                 [["shaded", "Shaded"], ["visibility", "Visibility"], ["error", "Error"], ["layers", "Layers"],
                  ["mean", "Mean depth"], ["spread", "Spread of depth"]], "shaded"),
    divider: range("Divider", "Where the left technique ends and the right one begins.", 0, 1, 0.01, 0.5),
    left: choice("Technique", "Left of the divider.", named(TECHNIQUES), "vsm"),
    right: choice("Technique", "Right of the divider.", named(TECHNIQUES), "bracketed"),
};

export const SIDE_SETTINGS = {
    format: choice("Format", "What a component of the map is stored in; fewer bits round more.", named(FORMATS)),
    layers: choice("Layers", "How many parts the depths are cut into; two share a texel of four components.",
                   numbered(2, 4, 6, 8, 12, 16)),
    placement: choice("Splits", "Where the layers are cut.",
                      [["uniform", "Equal lengths"], ["relaxed", "Relaxed: second occluders (lloydRelax)"],
                       ["steps", "The same on the device, two a frame"],
                       ["optimal", "Optimal: least spread (optimalSplits)"], ["manual", "By hand"]]),
    overlap: range("Overlap", "How far layers reach into each other, in depth: hides the seam at a split.",
                   0, 0.1, 0.005),
    transition: range("Transition", "Where two layers are blended, in depth, within the overlap.", 0, 0.1, 0.005),
    minVariance: scale("Least variance", "Floor in depth squared: covers rounding; too much of it leaks light.",
                       1e-9, 1e-2),
    slope: toggle("Slope in the floor",
                  "Adds what the receiver's own plane varies by over the blur (receiverMinVariance).", true),
    reduction: range("Light bleeding reduction", "Visibility that counts as none: cuts bleeding and darkens penumbrae.",
                     0, 0.9, 0.01),
    contact: range("Contact reduction", "The same within the receiver's own layer; 0.15 suits meshes.", 0, 0.9, 0.01),
    shift: range("Receiver shift", "Moves slanted receivers towards the light, in texels; up to 0.3 suits meshes.",
                 0, 2, 0.05),
    bias: scale("Depth bias", "Moves receivers towards the light, in depth: less acne, more light at contact.", 1e-5, 0.1),
    width: range("Filter width", "Texels along each side of the box; the default spreads as much as the blur.", 1, 21, 0.1),
    window: choice("Window", "Texels in each direction of the mixtures' own filter; the default spreads most like the blur.",
                   numbered(...MIXTURE_WIDTHS)),
    half: toggle("Half resolution", "One code for 2 x 2 depths: a fourth of the storage.", false),
    plane: toggle("Receiver plane", "Compares each texel with the receiver's plane there, not with its depth.", true),
    exponent: range("Exponent", "Of the positive warp: more of it bleeds less; formats bear 5.54 (16) and 43.3 (32 bits).",
                    1, 43.3, 0.1),
    negative: range("Negative exponent", "Of the negative warp, which helps where the positive one leaks.", 1, 43.3, 0.1),
    term: range("Exponent", "How steep the test is; formats bear 11 (16 bits) and 87 (32 bits).", 1, 87, 0.5),
    threshold: range("Threshold", "Excess over full light from which four texels are judged apart.", 0, 1, 0.01),
    momentBias: scale("Moment bias", "Share of a wide distribution mixed in against rounding; the default is the format's.",
                      1e-8, 1e-1),
    order: choice("Terms", "Of the Fourier series, four sines or cosines to a slice.", numbered(4, 8, 16)),
    strength: range("Attenuation", "Damps the high terms: less ringing, a softer step.", 0, 6, 0.25),
    contactScale: toggle("Scale, not offset",
                         "Doubles and clamps the light of lit surfaces instead of shifting them.", true),
};

// Settings that the address has in another shape than the panel: where the camera stands, and splits set by hand.
export const LISTS = {camera: 6, "left.splits": 17, "right.splits": 17};
