// Each technique draws a picture, and errs by what the gallery measures in the same scenes: techniques.mjs PAGE GALLERY
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {runCases} from "./page.mjs";

const [path, gallery] = process.argv.slice(2);

// The gallery counts four samples a pixel, moves receivers by 4 mm towards the light, and stores 16-bit fixed point, which
// SwiftShader does not have: floats of 32 bits take its place. That moves the figures by a few percent.
const TOLERANCE = 0.15;

// The gallery's settings and splits, where they are not the viewer's defaults.
const SAME = {
    basic: "left=basic",
    vsm: "left=vsm&left.format=fp32&left.slope=off",
    lvsm2: "left=lvsm&left.layers=2&left.overlap=0.01&left.format=fp32&left.slope=off",
    lvsm4: "left=lvsm&left.layers=4&left.overlap=0.01&left.format=fp32&left.slope=off",
    evsm4: "left=evsm4&left.exponent=43.3&left.slope=off",
    mixture2: "left=mixture2&kernel=triangle&taps=7",
};

function measuredByGallery() {
    const folder = mkdtempSync(join(tmpdir(), "lvsm-viewer-"));
    const asked = ["bench", "planes"].flatMap((scene) => ["--scene", scene])
        .concat(Object.keys(SAME).flatMap((technique) => ["--technique", technique]));
    const done = spawnSync(gallery, ["--full", "--size", "256", ...asked, "--output", join(folder, "gallery")], {encoding: "utf8"});
    if (done.status === 77) {
        console.log("skipped: no Vulkan device for the gallery");
        process.exit(77);
    }
    assert.equal(done.status, 0, done.stderr);
    const rows = JSON.parse(readFileSync(join(folder, "reports/gallery.json"), "utf8"));
    rmSync(folder, {recursive: true});
    return (scene, light, technique) => rows.find((row) => row.scene === scene && row.light === light &&
                                                           row.technique === technique);
}

// The grey of UNLIT in show.frag.glsl.
const SLATE = 110;

const measured = measuredByGallery();
const cases = {};
for (const [scene, light] of [["bench", "directional"], ["planes", "spot"]]) {
    cases[`${scene}, ${light} light: as the gallery`] = async (viewer) => {
        for (const [technique, settings] of Object.entries(SAME)) {
            // SwiftShader takes its time for mixtures.
            if (technique === "mixture2" && scene !== "bench")
                continue;
            const {rmse: theirs, splits} = measured(scene, light, technique);
            // The same splits: a placement of its own, from another map, can be better or worse.
            const placed = splits ? `&left.placement=manual&left.splits=${splits.join()}` : "";
            await viewer.go(`#scene=${scene}&light=${light}&right=vsm&${settings}${placed}`);
            const {rmse} = await viewer.figures("left");
            console.log(`     ${technique}: ${rmse.toFixed(4)}, the gallery ${theirs.toFixed(4)}`);
            // What is as small as an edge's antialiasing is not worth a comparison.
            assert.ok(Math.abs(rmse - theirs) <= TOLERANCE * theirs + 0.002, `${technique} errs ${rmse}, in the gallery ${theirs}`);
        }
    };
}

cases["relaxed splits lie where the gallery has them, on the host and by steps of the device"] = async (viewer) => {
    for (const [scene, technique, layers] of [["bench", "lvsm4", 4], ["planes", "lvsm2", 2]]) {
        const theirs = measured(scene, "directional", technique).splits;
        for (const placement of ["relaxed", "steps"]) {
            await viewer.go(`#scene=${scene}&size=256&taps=1&left=lvsm&left.layers=${layers}&left.placement=${placement}&right=vsm`);
            const splits = await viewer.tab.evaluate(() => window.lvsmViewer.loop.splits.left);
            const shown = (list) => list.map((split) => split.toFixed(3)).join(" ");
            console.log(`     ${placement}: ${shown(splits)}, the gallery ${shown(theirs)}`);
            // The viewer places by a map of half the gallery's size, whose texels hold the leaves' edges elsewhere.
            assert.ok(splits.every((split, i) => Math.abs(split - theirs[i]) < 0.01));
        }
    }
};

// VSM lets light through the bench, which all others are there to mend; a hard edge errs more than any soft one.
const WORSE = ["basic"];
// A bound from above is dark only where rounding, or the plane that the receiver is on, makes it no bound.
const BOUNDS = ["vsm", "lvsm", "bracketed", "layers4", "evsm2", "evsm4", "msm4", "trigonometric"];

// A small map and the least window of mixtures, which is the blur's here: SwiftShader takes its time for them.
const LEAST = "&size=256&kernel=triangle&taps=3";
const SMALL = {mixture2: LEAST, mixture4: LEAST};

cases["every technique draws, and errs less than VSM where that bleeds"] = async (viewer) => {
    const names = await viewer.tab.locator("#right option").evaluateAll((options) => options.map(({value}) => value));
    assert.ok(names.length >= 16, names.join());
    for (const technique of names) {
        await viewer.go(`#right=${technique}&view=visibility&divider=0${SMALL[technique] ?? ""}`);
        const [vsm, figures] = [await viewer.figures("left"), await viewer.figures("right")];
        const {rmse, lighter, darker} = figures;
        console.log(`     ${technique}: ${rmse.toFixed(4)}, light by ${lighter.toFixed(4)}, dark by ${darker.toFixed(4)}`);
        const greys = await viewer.greys();
        const share = (test) => greys.filter(test).length / greys.length;
        assert.ok(share((grey) => grey > 240) > 0.1, `${technique} is not lit anywhere`);
        assert.ok(share((grey) => grey < 40) > 0.02, `${technique} has no shadow`);
        assert.ok(new Set(greys).size > (technique === "basic" ? 3 : 30), `${technique} has no penumbra`);
        if (technique === "exact")
            assert.equal(figures.rmse, 0);
        else if (WORSE.includes(technique))
            assert.ok(figures.rmse > vsm.rmse, `${technique} errs ${figures.rmse}`);
        else if (technique !== "vsm")
            assert.ok(figures.rmse > 1e-4 && figures.rmse < vsm.rmse, `${technique} errs ${figures.rmse}, VSM ${vsm.rmse}`);
        assert.ok(!BOUNDS.includes(technique) || figures.darker < 0.003, `${technique} is too dark by ${figures.darker}`);
    }
};

cases["six faces of a point light, and levels of a map"] = async (viewer) => {
    // From both sides, so that every face around sees some of the ground. A face that is drawn the wrong way leaves all of
    // it slate, which else are only surfaces turned away; what is left of error is what light bleeds.
    for (const azimuth of [45, -135]) {
        await viewer.go(`#scene=blocks&light=point&elevation=30&azimuth=${azimuth}&view=visibility&left=vsm&right=bracketed`);
        const errors = [(await viewer.figures("left")).rmse, (await viewer.figures("right")).rmse];
        const greys = await viewer.greys();
        const slate = greys.filter((grey) => Math.abs(grey - SLATE) < 5).length / greys.length;
        console.log(`     point light: VSM ${errors[0].toFixed(4)}, bracketed ${errors[1].toFixed(4)}, ${slate.toFixed(2)} turned away`);
        assert.ok(Math.max(...errors) < 0.08 && slate < 0.2, `${errors}, ${slate}`);
    }
    // Without levels this picture reads level 0 alone; with them and samples along the footprint it blurs a little more.
    await viewer.go("#left=bracketed&right=bracketed");
    const plain = (await viewer.figures("left")).rmse;
    const levels = {};
    for (const anisotropy of [1, 16]) {
        await viewer.go(`#left=bracketed&right=bracketed&mipmaps=on&anisotropy=${anisotropy}`);
        levels[anisotropy] = (await viewer.figures("left")).rmse;
    }
    console.log(`     bracketed: ${plain.toFixed(4)}, with levels ${levels[1].toFixed(4)}, anisotropic ${levels[16].toFixed(4)}`);
    assert.ok(plain < levels[16] && levels[16] < levels[1] && levels[1] < 0.1, JSON.stringify([plain, levels]));
};

cases["leaves are cut out of their cards, and a large scene draws"] = async (viewer) => {
    await viewer.go("#scene=foliage&left=exact&right=vsm&view=visibility&divider=1&size=512");
    const lightOf = async () => (await viewer.greys()).reduce((sum, grey, _, {length}) => sum + grey / length, 0);
    const cut = await lightOf();
    await viewer.tab.evaluate(() => {
        const {picture, loop} = window.lvsmViewer;
        picture.scene.children.forEach((mesh) => mesh.userData.cutoff = 0);
        loop.invalidate();
    });
    await viewer.settled();
    const whole = await lightOf();
    console.log(`     foliage: mean grey ${cut.toFixed(1)} with the leaves cut out, ${whole.toFixed(1)} with whole cards`);
    assert.ok(cut > whole + 5, `${cut}, ${whole}`);
    await viewer.go("#scene=yard&left=vsm&right=bracketed&size=512&taps=5");
    const triangles = await viewer.tab.evaluate(() => window.lvsmViewer.picture.scene.children.reduce(
        (sum, {geometry}) => sum + geometry.getAttribute("position").count / 3, 0));
    const [vsm, {rmse}] = [await viewer.figures("left"), await viewer.figures("right")];
    console.log(`     yard: ${triangles} triangles, bracketed ${rmse.toFixed(4)}, VSM ${vsm.rmse.toFixed(4)}`);
    assert.ok(Math.abs(triangles - 300000) < 3000 && rmse > 0 && rmse < vsm.rmse, `${triangles}, ${rmse}, ${vsm.rmse}`);
};

cases["every view shows something of its own"] = async (viewer) => {
    const seen = new Set();
    for (const view of ["shaded", "visibility", "error", "layers", "mean", "spread"]) {
        await viewer.go(`#size=256&view=${view}`);
        const greys = await viewer.greys();
        assert.ok(new Set(greys).size > 8, `${view} is blank`);
        seen.add(greys.join());
    }
    assert.equal(seen.size, 6);
};

const opening = {"opens": (viewer) => viewer.open("#right=vsm")};
const options = {viewport: {width: 390, height: 844}, colorScheme: "dark"};
process.exit(await runCases(path, options, {...opening, ...cases}) ? 1 : 0);
