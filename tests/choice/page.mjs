// docs/choose.html from disk, and its answers against what the recorded runs say: page.mjs PAGE QUALITY COST
// QUALITY, COST: recorded.json of tests/quality and tests/cost, read here without what made the page.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {runCases, Viewer} from "../viewer/page.mjs";
import {faintTexts} from "../gallery/contrast.mjs";

const [path, qualityPath, costPath] = process.argv.slice(2);
const quality = JSON.parse(readFileSync(qualityPath, "utf8"));
const costs = new Map(JSON.parse(readFileSync(costPath, "utf8")).rows.filter(({target}) => target === "GFX1100")
    .map((row) => [row.name, row]));
const WIDE = {width: 1280, height: 900};
const NARROW = {width: 390, height: 844};
const DEFAULTS = {pixels: 1920 * 1080, texels: 1024 ** 2, width: "7", bits: 64, budget: 500, megabytes: Infinity, by: "error",
                  filtered: false};

// What a texel costs to make, as docs/choose.md says: all slices of a map, or its one; null where it is not recorded.
function mapOf(technique, width) {
    const {map} = costs.get(technique.estimate);
    if (map === "depths")
        return {units: 0, bytes: 0};
    const row = costs.get(`map ${map} ${width}${technique.resolution < 1 ? " half" : ""}`);
    if (!row)
        return null;
    const slices = technique.texel_bits / technique.resolution ** 2 / row.bits;
    return {units: row.inverse_throughput * (row.slice ? slices : 1), bytes: (row.read_bytes + row.written_bytes) * slices};
}

// The name, the error and the cost of a pixel of what should be chosen.
function expected(wish) {
    const rounded = (value) => Math.round(1e4 * value) / 1e4;
    let best = null;
    for (const technique of quality.runs[wish.width]) {
        const row = costs.get(technique.estimate + (technique.taps > 1 ? ` ${technique.taps} taps` : ""));
        if (technique.bits === 0 || technique.texel_bits > wish.bits || (wish.filtered && !technique.filtered) || !row)
            continue;
        const map = mapOf(technique, wish.width) ?? (wish.texels === 0 ? {units: 0, bytes: 0} : null);
        if (!map || map.bytes * wish.texels > 1e6 * wish.megabytes)
            continue;
        const pixel = Math.round(row.inverse_throughput * technique.decisions / row.decisions);
        const total = pixel + map.units * wish.texels / wish.pixels;
        const mean = quality.mesh_scenes.reduce((sum, scene) => sum + technique.rmse[scene], 0) / quality.mesh_scenes.length;
        const error = rounded(wish.by === "error" ? mean : Math.max(...Object.values(technique.rmse)));
        if (total <= wish.budget && (!best || error < best.error || (error === best.error && total < best.total)))
            best = {name: technique.name, error, total, pixel, making: map.units * wish.texels};
    }
    return best;
}

class Choice extends Viewer {
    async open() {
        await this.tab.goto("about:blank");
        await this.tab.goto(this.url);
    }

    async drawn() {}

    control(name) {
        return this.tab.locator(`[name=${name}]`);
    }

    async ask(wish) {
        for (const name of ["pixels", "texels", "budget", "megabytes"])
            await this.control(name).fill(wish[name] === Infinity ? "" : String(wish[name]));
        for (const name of ["width", "bits", "by"])
            await this.control(name).selectOption(String(wish[name]));
        await this.control("filtered").setChecked(wish.filtered);
    }

    heading() {
        return this.text("#answer h2");
    }

    about(term) {
        return this.text(`#answer dt:text-is("${term}") + dd`);
    }

    async agrees(wish) {
        const best = expected(wish);
        const asked = JSON.stringify(wish);
        assert.equal(await this.heading(), best ? best.name : "Nothing fits", asked);
        if (!best)
            return best;
        const shown = (await this.about("error")).match(/[\d.]+/g).map(Number)[wish.by === "error" ? 0 : 1];
        assert.equal(shown, best.error, asked);
        assert.equal(Number((await this.about("lighting")).match(/([\d,]+) a pixel/)[1].replace(",", "")), best.pixel, asked);
        const total = Number((await this.about("in all")).match(/([\d.,]+) a lit pixel/)[1].replace(",", ""));
        assert.ok(Math.abs(total - best.total) <= 0.05001, `${total}, ${best.total} for ${asked}`);
        assert.equal(await this.text("tr.chosen td >> nth=0").then((text) => text.replace(" (peer)", "")), best.name);
        return best;
    }
}

const cases = {
    "opens from disk, without a network and with a name on every control": async (choice) => {
        const asked = [];
        choice.tab.on("request", (request) => asked.push(request.url()));
        await choice.open();
        assert.deepEqual(asked, [choice.url]);
        assert.ok(await choice.tab.locator("form :is(input, select)").count() >= 8);
        const unnamed = await choice.tab.locator(":is(input, select)").evaluateAll(
            (inputs) => inputs.filter((input) => !input.labels[0]?.textContent).length);
        assert.equal(unnamed, 0);
        await choice.agrees(DEFAULTS);
    },

    "answers are those of the recorded runs, whatever is asked": async (choice) => {
        await choice.open();
        const names = new Set();
        for (const changes of [{}, {budget: 70}, {budget: 20}, {budget: Infinity}, {bits: 32}, {bits: 256, budget: 1000},
                               {width: "15"}, {width: "15", budget: 250}, {width: "3", budget: 150}, {width: "25"},
                               {texels: 4096 ** 2, budget: 2000}, {texels: 0}, {texels: 0, filtered: true, budget: 3000},
                               {filtered: true, bits: 128, budget: 300}, {megabytes: 30}, {megabytes: 0}, {megabytes: 30, filtered: true},
                               {by: "worst"}, {by: "worst", width: "15", budget: 300}, {pixels: 1e5, budget: 4000}]) {
            const wish = {...DEFAULTS, ...changes};
            await choice.ask(wish);
            names.add((await choice.agrees(wish))?.name);
        }
        console.log(`     ${[...names].join("; ")}`);
        assert.ok(names.size >= 6 && names.has(undefined), "the answers are too few to tell");
    },

    "each row of the table errs less than the one above, at more cost": async (choice) => {
        await choice.open();
        const rows = await choice.tab.locator("tbody tr").evaluateAll((all) => all.map(({cells}) => [
            Number(cells[1].textContent), Number(cells[7].textContent.replace(",", ""))]));
        assert.ok(rows.length >= 4);
        for (const [i, [error, total]] of rows.entries())
            assert.ok(i === 0 || (error < rows[i - 1][0] && total >= rows[i - 1][1]), `row ${i}`);
        const marks = await choice.tab.locator("svg :is(circle.ours, rect.peer)").count();
        assert.ok(marks >= 50 && await choice.tab.locator("svg .ring").count() === 1, `${marks} marks`);
    },

    "is used by keyboard alone": async (choice) => {
        await choice.open();
        const before = await choice.heading();
        await choice.tab.keyboard.press("Tab");
        for (let i = 0; i < 30 && await choice.tab.evaluate(() => document.activeElement.name) !== "budget"; ++i)
            await choice.tab.keyboard.press("Tab");
        await choice.tab.keyboard.press("Control+a");
        await choice.tab.keyboard.type("200");
        assert.notEqual(await choice.heading(), before);
        await choice.agrees({...DEFAULTS, budget: 200});
        for (let i = 0; i < 5 && await choice.tab.evaluate(() => document.activeElement.name) !== "filtered"; ++i)
            await choice.tab.keyboard.press("Tab");
        await choice.tab.keyboard.press("Space");
        await choice.agrees({...DEFAULTS, budget: 200, filtered: true});
    },

    "a number that is missing is asked for": async (choice) => {
        await choice.open();
        await choice.control("pixels").fill("");
        assert.equal(await choice.heading(), "A number is missing");
        await choice.control("pixels").fill("1000000");
        await choice.agrees({...DEFAULTS, pixels: 1e6});
    },
};

for (const [size, viewport] of Object.entries({wide: WIDE, narrow: NARROW})) {
    for (const colorScheme of ["light", "dark"]) {
        cases[`whole and legible, ${size}, ${colorScheme}`] = async (choice) => {
            await choice.tab.emulateMedia({colorScheme});
            await choice.tab.setViewportSize(viewport);
            await choice.open();
            const {wide, shown} = await choice.tab.evaluate(() => ({wide: document.documentElement.scrollWidth, shown: innerWidth}));
            assert.ok(wide <= shown, `the page is ${wide} wide and the window ${shown}`);
            const {faint, least, count} = await choice.tab.evaluate(faintTexts);
            console.log(`     ${count} parts, least contrast ${least.toFixed(2)}`);
            assert.ok(count > 40);
            assert.deepEqual(faint, []);
            if (process.env.LVSM_SCREENSHOTS)
                await choice.tab.screenshot({path: `${process.env.LVSM_SCREENSHOTS}/${size}_${colorScheme}.png`, fullPage: true});
        };
    }
}

process.exit(await runCases(path, {viewport: WIDE}, cases, Choice) ? 1 : 0);
