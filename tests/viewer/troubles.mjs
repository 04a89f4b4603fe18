// Models, good and broken; a lost context; browsers that lack something: troubles.mjs PAGE
import assert from "node:assert/strict";
import {withTab} from "../clients/browser.mjs";
import {runCases, Viewer} from "./page.mjs";

const [path] = process.argv.slice(2);
const QUICK = "#size=256&taps=5";

const CUBE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" +
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// A triangle on edge over the ground, red, as glTF with its buffer inside or in a second file.
function gltf(uri) {
    return JSON.stringify({
        asset: {version: "2.0"}, scene: 0, scenes: [{nodes: [0]}], nodes: [{mesh: 0}],
        meshes: [{primitives: [{attributes: {POSITION: 0}, material: 0}]}],
        materials: [{pbrMetallicRoughness: {baseColorFactor: [1, 0, 0, 1]}}],
        accessors: [{bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [2, 2, 0]}],
        bufferViews: [{buffer: 0, byteOffset: 0, byteLength: 36}], buffers: [{uri, byteLength: 36}],
    });
}
const TRIANGLE = Buffer.from(new Float32Array([0, 0, 0, 2, 0, 0, 1, 2, 0]).buffer);
const INSIDE = `data:application/octet-stream;base64,${TRIANGLE.toString("base64")}`;

const file = (name, content) => ({name, mimeType: "application/octet-stream", buffer: Buffer.from(content)});

async function open(viewer, ...files) {
    await viewer.tab.locator("#status").evaluate((status) => status.textContent = "");
    await viewer.tab.locator("#model").setInputFiles(files);
    await viewer.tab.waitForFunction(() => document.getElementById("status").textContent);
    await viewer.settled();
    return viewer.text("#status");
}

const scene = (viewer) => viewer.tab.evaluate(() => window.lvsmViewer.scene.title);

async function drop(viewer, name, content) {
    const transfer = await viewer.tab.evaluateHandle(([title, text]) => {
        const made = new DataTransfer();
        made.items.add(new File([text], title));
        return made;
    }, [name, content]);
    await viewer.tab.dispatchEvent("#canvas", "dragover", {dataTransfer: transfer});
    assert.equal(await viewer.tab.locator("#drop").isVisible(), true);
    await viewer.tab.dispatchEvent("#canvas", "drop", {dataTransfer: transfer});
}

const cases = {
    "a model of the user's is shown and casts a shadow": async (viewer) => {
        await viewer.open(`${QUICK}&view=visibility&left=exact&right=vsm`);
        assert.match(await open(viewer, file("cube.obj", CUBE)), /cube\.obj is shown/);
        const greys = await viewer.greys();
        assert.ok(greys.some((grey) => grey < 10) && greys.some((grey) => grey > 250), "there is no shadow");
        assert.ok((await viewer.figures("right")).rmse > 0);
        assert.match(await open(viewer, file("triangle.gltf", gltf(INSIDE))), /triangle\.gltf is shown/);
        const apart = [file("apart.gltf", gltf("apart.bin")), file("apart.bin", TRIANGLE)];
        assert.match(await open(viewer, ...apart), /apart\.gltf is shown/);
    },

    "a model is dropped on the page": async (viewer) => {
        await drop(viewer, "dropped.obj", CUBE);
        await viewer.tab.waitForFunction(() => document.getElementById("status").textContent.startsWith("dropped.obj is shown"));
        assert.equal(await scene(viewer), "dropped.obj");
        assert.equal(await viewer.tab.locator("#drop").isVisible(), false);
    },

    "a broken model is named, and the old scene stays": async (viewer) => {
        await viewer.settled();
        const before = (await viewer.greys()).join();
        const broken = {"text.obj": "this is no model\n", "points.obj": "v 0 0 0\nv 1 0 0\np 1 2\n",
                        "flat.obj": "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n",
                        "infinite.obj": "v inf 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "cut.glb": "glTF\x02\0",
                        "cut.gltf": "{\"asset\":", "lacking.gltf": gltf("nowhere.bin"), "picture.png": "\x89PNG"};
        for (const [name, content] of Object.entries(broken)) {
            const said = await open(viewer, file(name, content));
            assert.ok(said.startsWith(`${name}: `) && said.length > name.length + 8, said);
            assert.equal(await scene(viewer), "dropped.obj", name);
        }
        assert.ok((await viewer.greys()).join() === before, "the picture is another");
        // What three.js says of a text that is no model.
        viewer.said.splice(0, viewer.said.length, ...viewer.said.filter((line) => !line.includes("OBJLoader: Unexpected line")));
    },

    "a lost context comes back": async (viewer) => {
        await viewer.open(`${QUICK}&right=evsm4`);
        const [before, figures] = [(await viewer.greys()).join(), await viewer.figures("right")];
        await viewer.tab.evaluate(() => window.lvsmViewer.picture.renderer.forceContextLoss());
        await viewer.tab.waitForFunction(() => document.getElementById("status").textContent.includes("is lost"));
        await viewer.tab.locator("#divider").press("ArrowLeft");
        await viewer.tab.evaluate(() => window.lvsmViewer.picture.renderer.forceContextRestore());
        await viewer.tab.waitForFunction(() => document.getElementById("status").textContent.includes("is back"));
        await viewer.tab.locator("#divider").press("ArrowRight");
        await viewer.settled();
        assert.ok((await viewer.greys()).join() === before, "the picture is another");
        assert.deepEqual(await viewer.figures("right"), figures);
        viewer.said.splice(0, viewer.said.length, ...viewer.said.filter((line) => !/Context (Lost|Restored)/.test(line)));
    },
};

// What a browser lacks is taken from it before the page's script runs.
const LACKS = {
    "no WebGL2": [() => {
        const original = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
            return kind === "webgl2" ? null : original.call(this, kind, ...more);
        };
    }, /has no WebGL2/],
    "no float targets": [() => {
        const original = WebGL2RenderingContext.prototype.getExtension;
        WebGL2RenderingContext.prototype.getExtension = function (name) {
            return name === "EXT_color_buffer_float" ? null : original.call(this, name);
        };
    }, /EXT_color_buffer_float/],
};

for (const [lack, [take, sentence]] of Object.entries(LACKS)) {
    cases[`${lack}: a sentence says so`] = async (viewer) => {
        const {result, said} = await withTab({}, async (tab) => {
            await tab.addInitScript(take);
            await tab.goto(viewer.url);
            return {message: await tab.locator("#message").innerText(), isShown: await tab.locator("#viewer").isVisible()};
        });
        assert.match(result.message, sentence);
        assert.equal(result.isShown, false);
        assert.deepEqual(said, []);
    };
}

cases["without filtered floats every technique has another format"] = async (viewer) => {
    const {said} = await withTab({viewport: {width: 390, height: 700}, deviceScaleFactor: 0.5}, async (tab, heard) => {
        await tab.addInitScript(() => {
            const original = WebGL2RenderingContext.prototype.getExtension;
            WebGL2RenderingContext.prototype.getExtension = function (name) {
                return name === "OES_texture_float_linear" ? null : original.call(this, name);
            };
        });
        const poor = new Viewer(tab, path, heard);
        await poor.open(`${QUICK}&left=evsm4&right=msm4`);
        poor.isNorm16 = await tab.evaluate(() => window.lvsmViewer.device.formats.has("unorm16"));
        assert.equal(await poor.state("left.format"), "fp16");
        // Moments in 16 bits are fixed-point, or not at all.
        assert.equal(await poor.state("right"), poor.isNorm16 ? "msm4" : "bracketed");
        assert.equal(await poor.state("left.exponent"), 5.54);
        assert.ok((await poor.figures("left")).rmse < 0.2);
    });
    assert.deepEqual(said, []);
};

process.exit(await runCases(path, {viewport: {width: 1280, height: 800}, deviceScaleFactor: 0.5}, cases) ? 1 : 0);
