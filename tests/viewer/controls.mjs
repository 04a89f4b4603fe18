// The panel, the handles and the address, by keyboard and pointer, at two widths: controls.mjs PAGE
import assert from "node:assert/strict";
import {runCases} from "./page.mjs";

const [path] = process.argv.slice(2);
// Small maps: what is looked at here is not their quality.
const QUICK = "size=256&taps=5";

async function isWhole(viewer) {
    const {tab} = viewer;
    const {wide, shown} = await tab.evaluate(() => ({wide: document.documentElement.scrollWidth, shown: innerWidth}));
    assert.ok(wide <= shown, `the page is ${wide} wide and the window ${shown}`);
    assert.equal(await tab.locator("#message").isVisible(), false);
    // Every control has a name and a line that explains it.
    const bare = await tab.locator("#panel :is(input, select)").evaluateAll((inputs) => inputs.filter((input) => {
        const line = document.getElementById(input.getAttribute("aria-describedby"));
        return !input.labels[0]?.textContent || !line?.textContent;
    }).map(({id}) => id));
    assert.deepEqual(bare, []);
    const unnamed = await tab.locator("[role=slider], button, canvas").evaluateAll((parts) => parts.filter(
        (part) => !part.getAttribute("aria-label") && !part.textContent).length);
    assert.equal(unnamed, 0);
}

const namesIn = (viewer, side) => viewer.tab.locator(`#${side}-panel .control :is(input, select)`)
    .evaluateAll((inputs) => inputs.map(({name}) => name.split(".")[1]).filter(Boolean));

const cases = {
    "opens from disk, whole and without a word": async (viewer) => {
        await viewer.open(`#${QUICK}`);
        await isWhole(viewer);
    },

    "a side shows what its technique takes, and nothing else": async (viewer) => {
        assert.deepEqual(await namesIn(viewer, "left"), ["format", "minVariance", "slope", "reduction", "shift"]);
        await viewer.tab.locator("#left").selectOption("evsm4");
        assert.deepEqual(await namesIn(viewer, "left"),
                         ["format", "exponent", "negative", "minVariance", "slope", "reduction", "shift"]);
        await viewer.tab.locator("#left").selectOption("exact");
        assert.deepEqual(await namesIn(viewer, "left"), []);
        assert.equal(await viewer.tab.locator("#copy-left-glsl").isDisabled(), true);
    },

    "a technique is chosen by keys alone": async (viewer) => {
        await viewer.press("#left", "Home", "ArrowDown");
        assert.equal(await viewer.state("left"), "pcf");
        await viewer.press("#left-bias", "End");
        assert.equal(await viewer.state("left.bias"), 0.1);
        await viewer.tab.keyboard.press("Shift+Tab");
        await viewer.tab.keyboard.press("Enter");
        assert.equal(await viewer.state("left.bias"), 0.001, "the button beside it takes it back");
    },

    "the divider moves by key and pointer": async (viewer) => {
        await viewer.press("#divider", "ArrowRight", "ArrowRight");
        assert.equal(await viewer.state("divider"), 0.54);
        const width = (await viewer.tab.locator("#frame").boundingBox()).width;
        await viewer.drag("#divider", -0.3 * width, 0);
        assert.ok(Math.abs(await viewer.state("divider") - 0.24) < 0.02);
    },

    "the light moves by key and pointer": async (viewer) => {
        const [azimuth, elevation] = [await viewer.state("azimuth"), await viewer.state("elevation")];
        await viewer.press("#light-handle", "ArrowRight", "ArrowDown");
        assert.deepEqual([await viewer.state("azimuth"), await viewer.state("elevation")], [azimuth + 5, elevation - 3]);
        await viewer.drag("#light-handle", 60, -20);
        assert.equal(await viewer.state("azimuth"), azimuth + 35);
        assert.ok(Math.abs(await viewer.state("elevation") - (elevation + 3)) <= 1);
    },

    "the camera turns by key and pointer": async (viewer) => {
        const seen = new Set();
        const look = async () => seen.add((await viewer.state("camera")).map((value) => value.toFixed(3)).join());
        await viewer.press("#canvas", "ArrowLeft");
        await look();
        await viewer.press("#canvas", "ArrowUp", "+");
        await look();
        await viewer.drag("#canvas", 80, 20);
        await look();
        assert.equal(seen.size, 3);
    },

    "splits are set by hand on the histogram": async (viewer) => {
        await viewer.go(`#${QUICK}&left=vsm&right=bracketed&right.layers=4`);
        const split = "#right-panel .split:nth-child(2)";
        const before = Number(await viewer.tab.locator(split).getAttribute("aria-valuenow"));
        await viewer.press(split, "ArrowLeft", "ArrowLeft");
        assert.equal(await viewer.state("right.placement"), "manual");
        const after = (await viewer.state("right.splits"))[2];
        assert.ok(Math.abs(after - (before - 0.01)) < 0.002, `${before} became ${after}`);
        await viewer.drag(split, -25, 0);
        const dragged = await viewer.state("right.splits");
        assert.ok(dragged[2] < after && dragged[2] > dragged[1], dragged.join());
    },

    "the address holds all of it": async (viewer) => {
        const {tab} = viewer;
        await tab.locator("#scene").selectOption("planes");
        await tab.locator("#light").selectOption("spot");
        await tab.locator("#mipmaps").check();
        await tab.locator("#anisotropy").selectOption("4");
        await tab.locator("#views label", {hasText: "Visibility"}).click();
        await tab.locator("#right-reduction").fill("0.3");
        await viewer.settled();
        const [address, figures, greys] = [await viewer.address(), await viewer.figures("right"), await viewer.greys()];
        for (const part of ["scene=planes", "light=spot", "mipmaps=on", "anisotropy=4", "view=visibility", "size=256",
                            "right.reduction=0.3", "right.placement=manual", "right.splits=0,"])
            assert.ok(address.includes(part), `${part} is not in ${address}`);
        await tab.waitForFunction((hash) => location.hash === hash, address);
        await viewer.open(address);
        assert.equal(await viewer.address(), address);
        assert.deepEqual(await viewer.figures("right"), figures);
        assert.ok((await viewer.greys()).join() === greys.join(), "the picture is another");
    },

    "an address of nonsense shows the defaults": async (viewer) => {
        await viewer.open("#left=nonsense&size=77&right.reduction=x&right.exponent=3&a=1&left.splits=&view&divider=9");
        assert.equal(await viewer.state("left"), "vsm");
        assert.equal(await viewer.state("size"), 512);
        assert.equal(await viewer.state("divider"), 1);
    },

    "a moving light takes the splits along": async (viewer) => {
        await viewer.tab.evaluate((hash) => location.hash = hash, `#${QUICK}&left=lvsm&right=bracketed&moving=on`);
        const look = () => viewer.tab.evaluate(async () => {
            const {loop} = window.lvsmViewer;
            const first = loop.frames;
            while (loop.frames < first + 4)
                await new Promise((resolve) => setTimeout(resolve, 20));
            return {splits: [...loop.splits.left, ...loop.splits.right], light: [...loop.picture.light.direction]};
        });
        const [before, after] = [await look(), await look()];
        assert.notDeepEqual(before.light, after.light);
        assert.notDeepEqual(before.splits, after.splits);
        assert.ok([...before.splits, ...after.splits].every(Number.isFinite));
        await viewer.tab.locator("#moving").uncheck();
        await viewer.settled();
    },

    "whole at 390 pixels": async (viewer) => {
        await viewer.tab.setViewportSize({width: 390, height: 844});
        await viewer.open(`#${QUICK}&right=plane`);
        await isWhole(viewer);
        await viewer.press("#divider", "ArrowLeft");
        assert.equal(await viewer.state("divider"), 0.48);
        const {width} = await viewer.tab.locator("#frame").boundingBox();
        await viewer.drag("#divider", 0.2 * width, 0);
        assert.ok(Math.abs(await viewer.state("divider") - 0.68) < 0.02);
    },
};

// Half a pixel for each of the page's: a fourth of the work, and the layout is the same.
process.exit(await runCases(path, {viewport: {width: 1280, height: 800}, deviceScaleFactor: 0.5}, cases) ? 1 : 0);
