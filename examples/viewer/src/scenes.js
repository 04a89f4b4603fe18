// The scenes, those of the gallery with its cameras and lights first. A scene is a list of meshes, where the camera
// stands, what the lights must cover (focus), and the way the directional light travels.
import {makeCards} from "./foliage.js";
import {MeshBuilder, unit} from "./mesh.js";
import {addTree} from "./tree.js";

const GROUND = [0.62, 0.60, 0.56];
const WOOD = [0.60, 0.43, 0.27];
const PAINT = [0.80, 0.79, 0.75];
const BRICK = [0.66, 0.40, 0.32];
const GROUND_HALF_WIDTH = 40;

// Numbers in [0,1) that are the same on every machine.
function* numbers(seed) {
    for (let state = seed;;) {
        state = Math.imul(state, 1664525) + 1013904223 >>> 0;
        yield (state >>> 8) / 2 ** 24;
    }
}

function planes(builder) {
    builder.addBox([-2.2, 2.6, -1.6], [-0.1, 2.64, 0.6], [0.30, 0.45, 0.62]);
    builder.addBox([-1.0, 0.55, -0.7], [1.0, 0.59, 0.7], [0.75, 0.55, 0.35]);
}

function bench(builder) {
    builder.addBox([-0.9, 0.5, -0.24], [0.9, 0.56, 0.24], WOOD);
    for (const x of [-0.7, 0.7])
        builder.addBox([x - 0.04, 0, -0.2], [x + 0.04, 0.5, 0.2], WOOD);
    addTree(builder, [-1.1, 0, -1.7], 11);
}

function fence(builder) {
    const [pickets, spacing, x] = [13, 0.22, -1];
    for (let i = 0; i < pickets; ++i) {
        const z = spacing * (i - Math.floor(pickets / 2));
        builder.addBox([x, 0, z - 0.05], [x + 0.03, 1.1, z + 0.05], PAINT);
    }
    const half = spacing * pickets / 2;
    for (const y of [0.3, 0.8])
        builder.addBox([x - 0.04, y, -half], [x, y + 0.08, half], PAINT);
}

// Something curved that shadows itself, behind the fence: a stack of rings.
function fencedVase(builder) {
    fence(builder);
    const profile = [[0.22, 0], [0.34, 0.15], [0.4, 0.35], [0.3, 0.6], [0.16, 0.78], [0.2, 0.9], [0.26, 1.0]];
    for (let i = 0; i + 1 < profile.length; ++i)
        builder.addBar([0, profile[i][1], 0], [0, profile[i + 1][1], 0], profile[i][0], profile[i + 1][0],
                       [0.72, 0.68, 0.62]);
}

function blocks(builder) {
    const random = numbers(7);
    const next = () => random.next().value;
    for (let i = 0; i < 26; ++i) {
        const [x, z] = [5 * next() - 2.5, 5 * next() - 2.5];
        const [wide, deep, lift] = [0.2 + 0.5 * next(), 0.2 + 0.5 * next(), i % 3 ? 0 : 0.4 + 4.5 * next()];
        const shade = 0.7 + 0.5 * next();
        builder.addBox([x - wide, lift, z - deep], [x + wide, lift + 0.15 + (i % 3 ? 0.9 * next() : 0), z + deep],
                       BRICK.map((value) => value * shade));
    }
}

function slope(builder) {
    // A long ramp that rises away from the light, and poles that throw shadows along it.
    builder.addQuad([-1.6, 0.02, 3], [1.6, 0.02, 3], [1.6, 2.2, -4], [-1.6, 2.2, -4], PAINT);
    for (let i = 0; i < 6; ++i) {
        const z = 2.2 - i;
        builder.addBar([i % 2 ? -0.8 : 0.8, 0.02 + 2.18 * (3 - z) / 7, z], [i % 2 ? -0.8 : 0.8, 3.2, z], 0.06, 0.06, WOOD);
    }
    builder.addBox([-1.2, 3.2, -3.5], [1.2, 3.26, 2.5], [0.30, 0.45, 0.62]);
}

// A bush of leaves on cards over a table, and its stem.
function bush(builder) {
    builder.addBar([0, 0, 0], [0, 1.5, 0], 0.06, 0.03, WOOD);
    builder.addBox([0.5, 0.42, -0.5], [1.6, 0.48, 0.5], [0.75, 0.55, 0.35]);
    for (const x of [0.58, 1.46])
        builder.addBox([x, 0, -0.4], [x + 0.06, 0.42, 0.4], [0.75, 0.55, 0.35]);
    const random = numbers(3);
    return [makeCards(() => random.next().value, [0, 1.7, 0], 0.75, 0.62, 90)];
}

// A walled yard with trees and a lawn of single blades: about 300 000 triangles.
const BLADES = 103000;
function yard(builder) {
    const random = numbers(5);
    const next = () => random.next().value;
    for (const [x, z, wide, deep] of [[0, -5, 5.2, 0.15], [-5, 0, 0.15, 5], [5, 0, 0.15, 5]])
        builder.addBox([x - wide, 0, z - deep], [x + wide, 1.2, z + deep], BRICK);
    for (let tree = 0; tree < 8; ++tree)
        addTree(builder, [-3.6 + 2.4 * (tree % 4), 0, tree < 4 ? -3.2 : 0.4 + 0.5 * (tree % 2)], 20 + tree);
    for (let blade = 0; blade < BLADES; ++blade) {
        const [x, z, turn] = [9.4 * next() - 4.7, 9 * next() - 4.6, 2 * Math.PI * next()];
        const [lean, high] = [0.05 * next(), 0.06 + 0.1 * next()];
        const [across, down] = [0.008 * Math.cos(turn), 0.008 * Math.sin(turn)];
        const shade = 0.7 + 0.6 * next();
        const [a, b] = [[x - across, 0, z - down], [x + across, 0, z + down]];
        builder.addQuad(a, b, [x + 0.5 * across + lean, high, z + 0.5 * down], [x - 0.5 * across + lean, high, z - 0.5 * down],
                        [0.3 * shade, 0.45 * shade, 0.18 * shade]);
    }
}

// Each: what the list shows, a sentence, what fills the mesh (and gives others), camera, focus, light.
export const SCENES = {
    bench: {
        title: "A tree over a bench",
        line: "Figure 3 of the paper: a tree far above a bench close to the ground, which makes variance bleed most.",
        fill: bench,
        camera: {eye: [1.3, 1.75, 4.4], target: [-0.15, 0.45, 0], fieldOfView: 32},
        focus: {low: [-3.1, 0, -3.0], high: [2.4, 5.5, 2.0]},
        light: [0.12, -1, 0.34],
    },
    planes: {
        title: "Three planes",
        line: "Figure 2 of the paper: no trace of the upper plane's edge may show inside the lower one's shadow.",
        fill: planes,
        camera: {eye: [2.5, 3.7, 6.0], target: [-0.25, 1.15, 0], fieldOfView: 33},
        focus: {low: [-2.3, 0, -1.7], high: [2.0, 2.7, 2.4]},
        light: [0.15, -1, 0.45],
    },
    fence: {
        title: "A vase behind a fence",
        line: "Many thin occluders over a curved receiver that shadows itself.",
        fill: fencedVase,
        camera: {eye: [1.1, 1.55, 4.6], target: [0.05, 0.45, 0], fieldOfView: 28},
        focus: {low: [-1.1, 0, -1.5], high: [1.6, 1.1, 1.5]},
        light: [0.85, -0.52, -0.42],
    },
    blocks: {
        title: "Overlapping blocks",
        line: "Blocks at many heights over each other: every window holds several depths.",
        fill: blocks,
        camera: {eye: [4.2, 5.2, 6.4], target: [0, 0.8, 0], fieldOfView: 36},
        focus: {low: [-3.2, 0, -3.2], high: [3.2, 5.2, 3.2]},
        light: [0.35, -1, 0.25],
    },
    slope: {
        title: "A long slope",
        line: "A receiver along the light: the plane that it is on has variance of its own.",
        fill: slope,
        camera: {eye: [4.6, 3.6, 5.4], target: [0, 1.1, -0.5], fieldOfView: 38},
        focus: {low: [-1.7, 0, -4.1], high: [1.7, 3.3, 3.1]},
        light: [0.1, -0.75, -0.66],
    },
    foliage: {
        title: "Leaves on cards",
        line: "Alpha-tested leaves over a table: holes of every size, and depths all through the bush.",
        fill: bush,
        camera: {eye: [3.0, 2.6, 5.6], target: [0.2, 1.15, 0], fieldOfView: 33},
        focus: {low: [-1.3, 0, -1.3], high: [1.9, 2.9, 1.3]},
        light: [0.35, -1, 0.25],
    },
    yard: {
        title: "A yard of 300 000 triangles",
        line: "Eight trees over a lawn of single blades between walls: how fast a map is made, not how it is filtered.",
        fill: yard,
        camera: {eye: [3.2, 5.6, 11.0], target: [0, 1.6, -0.8], fieldOfView: 40},
        focus: {low: [-5.2, 0, -5.2], high: [5.2, 5.5, 5]},
        light: [0.45, -1, -0.35],
    },
};

export function makeScene(id) {
    const {title, fill, camera, focus, light} = SCENES[id];
    const builder = new MeshBuilder();
    builder.addGround(GROUND_HALF_WIDTH, GROUND);
    const others = fill(builder) ?? [];
    return {id, title, meshes: [builder.mesh(), ...others], camera, focus, lightDirection: unit(light)};
}

// A model that the user has given, fitted to a cube of about 1.3 on the ground: meshes in its own units and box.
export function makeModelScene(title, meshes, size) {
    const builder = new MeshBuilder();
    builder.addGround(GROUND_HALF_WIDTH, GROUND);
    const [x, y, z] = size.map((length) => length / 2);
    return {id: "model", title, meshes: [builder.mesh(), ...meshes],
            camera: {eye: [1.5, 1.5, 3.4], target: [0, y, 0], fieldOfView: 32},
            focus: {low: [-x - 0.2, 0, -z - 0.2], high: [x + 0.6, 2 * y, z + 0.4]}, lightDirection: unit([0.45, -1, 0.3])};
}
