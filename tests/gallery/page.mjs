// The gallery's page from disk, by keyboard, pointer and finger: page.mjs INDEX
import assert from "node:assert/strict";
import {withTab} from "../clients/browser.mjs";
import {runCases, Viewer} from "../viewer/page.mjs";
import {faintTexts} from "./contrast.mjs";

const [path] = process.argv.slice(2);
const WIDE = {width: 1280, height: 900};
const NARROW = {width: 390, height: 844};

class Gallery extends Viewer {
    async open() {
        await this.tab.goto("about:blank");
        await this.tab.goto(this.url);
        this.article = this.tab.locator("article").first();
        this.stage = this.article.locator(".stage");
        await this.stage.scrollIntoViewIfNeeded();
        await this.decoded();
    }

    // Nothing is drawn by a script; a picture has to arrive.
    async drawn() {
        await this.decoded();
    }

    decoded() {
        return this.stage.locator("img").evaluateAll((images) => Promise.all(images.map((image) => image.decode())));
    }

    async choose(side, technique) {
        await this.article.locator(`select[name=${side}]`).selectOption(technique);
        await this.decoded();
    }

    at() {
        return this.stage.locator("input").inputValue().then(Number);
    }

    // What is seen in a part of the stage, from and to in shares of its width, above the names, once it rests.
    async seen(from, to) {
        let [before, now] = ["", await this.photograph(from, to)];
        for (let tries = 0; before !== now && tries < 10; ++tries)
            [before, now] = [now, await this.photograph(from, to)];
        return now;
    }

    async photograph(from, to) {
        await this.stage.scrollIntoViewIfNeeded();
        const {x, y, width, height} = await this.stage.boundingBox();
        const clip = {x: Math.round(x + from * width), y: Math.round(y), width: Math.round((to - from) * width),
                      height: Math.round(0.75 * height)};
        return (await this.tab.screenshot({clip})).toString("base64");
    }
}

async function isWhole({tab}) {
    const {wide, shown} = await tab.evaluate(() => ({wide: document.documentElement.scrollWidth, shown: innerWidth}));
    assert.ok(wide <= shown, `the page is ${wide} wide and the window ${shown}`);
    const unnamed = await tab.locator(":is(input, select)").evaluateAll((inputs) => inputs.filter(
        (input) => !input.labels[0]?.textContent && !input.getAttribute("aria-label")).length);
    assert.equal(unnamed, 0, "a control has no name");
}

// Chooses everything in the page itself, and gives the files that do not load; pictures: how many were shown.
function tryAll() {
    const load = async (image, problems, shown) => {
        shown.add(image.src);
        await image.decode().catch(() => problems.push(image.src));
    };
    return (async () => {
        const [problems, shown] = [[], new Set()];
        for (const article of document.querySelectorAll("article")) {
            for (const view of article.querySelectorAll("fieldset input")) {
                view.click();
                for (const side of ["a", "b"]) {
                    const select = article.querySelector(`select[name=${side}]`);
                    const image = article.querySelector(`img.${side}`);
                    image.loading = "eager";
                    for (const {value, text} of select.options) {
                        select.value = value;
                        select.dispatchEvent(new Event("change", {bubbles: true}));
                        await load(image, problems, shown);
                        if (!article.querySelector(`.about.${side}`).textContent.startsWith(`${text}.`))
                            problems.push(`${article.id}: nothing is said of ${text}`);
                        if (value !== "exact" && article.querySelectorAll(`tr.${side}`).length !== 1)
                            problems.push(`${article.id}: no row of ${text} is marked`);
                    }
                }
            }
        }
        return {problems, pictures: shown.size};
    })();
}

// Pairs of shown labels that meet, and labels that leave their chart.
function collidingLabels() {
    const found = [];
    for (const svg of document.querySelectorAll(".chart svg")) {
        const frame = svg.closest(".chart").getBoundingClientRect();
        const texts = [...svg.querySelectorAll("text")].filter((text) => getComputedStyle(text).visibility === "visible" &&
            getComputedStyle(text).display !== "none" && !text.matches(".letter"));
        const boxes = texts.map((text) => [text.textContent, text.getBoundingClientRect()]);
        for (const [i, [name, box]] of boxes.entries()) {
            if (box.left < frame.left || box.right > frame.right)
                found.push(`${name} leaves its chart`);
            for (const [other, b] of boxes.slice(i + 1)) {
                if (box.left < b.right && b.left < box.right && box.top < b.bottom - 3 && b.top < box.bottom - 3)
                    found.push(`${name} and ${other}`);
            }
        }
    }
    return found;
}

const cases = {
    "opens from disk, whole and without a word": async (gallery) => {
        await gallery.open();
        await isWhole(gallery);
        assert.ok(await gallery.tab.locator("article").count() >= 5);
        assert.ok(await gallery.tab.locator("#papers tbody tr:not(.reason)").count() >= 79);
    },

    "every technique can be chosen on either side, and every picture is there": async (gallery) => {
        const {problems, pictures} = await gallery.tab.evaluate(tryAll);
        assert.deepEqual(problems, []);
        console.log(`     ${pictures} pictures`);
        assert.ok(pictures > 50, `${pictures} pictures`);
    },

    "A is on the left of the divider and B on the right": async (gallery) => {
        await gallery.open();
        const [left, right] = [await gallery.seen(0, 0.45), await gallery.seen(0.55, 1)];
        await gallery.choose("a", "basic");
        assert.notEqual(await gallery.seen(0, 0.45), left);
        assert.equal(await gallery.seen(0.55, 1), right);
        await gallery.choose("b", "basic");
        assert.notEqual(await gallery.seen(0.55, 1), right);
    },

    "the divider moves by keys": async (gallery) => {
        await gallery.open();
        const middle = await gallery.seen(0.55, 0.9);
        await gallery.press("article .stage input >> nth=0", "ArrowRight", "ArrowRight");
        assert.equal(await gallery.at(), 52);
        await gallery.press("article .stage input >> nth=0", "End");
        assert.notEqual(await gallery.seen(0.55, 0.9), middle);
        await gallery.choose("b", "basic");
        const whole = await gallery.seen(0.02, 0.95);
        await gallery.choose("b", "vsm");
        assert.equal(await gallery.seen(0.02, 0.95), whole, "B is seen where A should be");
    },

    "the divider moves by pointer": async (gallery) => {
        await gallery.open();
        const middle = await gallery.seen(0.1, 0.45);
        const {width} = await gallery.stage.boundingBox();
        await gallery.drag("article .stage >> nth=0", -0.4 * width, 0);
        assert.ok(Math.abs(await gallery.at() - 10) <= 1, `at ${await gallery.at()}`);
        assert.notEqual(await gallery.seen(0.12, 0.45), middle);
    },

    "error maps and layers are shown with what explains them": async (gallery) => {
        await gallery.open();
        await gallery.article.locator("fieldset label", {hasText: "error map"}).click();
        assert.match(await gallery.stage.locator("img.a").getAttribute("src"), /vsm-error\.png$/);
        assert.match(await gallery.article.locator(".ticks").first().innerText(), /−50%\s+−25%\s+0%\s+\+25%\s+\+50%/);
        await gallery.article.locator("fieldset label", {hasText: "layers"}).click();
        assert.equal(await gallery.article.locator(".about.b .key").count(), 4);
        assert.match(await gallery.article.locator(".tag.a").innerText(), /picture/);
    },

    "splits of the chosen pair are drawn on the histogram": async (gallery) => {
        await gallery.open();
        const splits = () => gallery.article.locator(".splits line").evaluateAll(
            (lines) => lines.filter((line) => line.getClientRects().length > 0).length);
        assert.equal(await splits(), 3);
        await gallery.choose("a", "lvsm2");
        assert.equal(await splits(), 4);
        assert.ok((await gallery.article.locator(".bars").getAttribute("d")).length > 200);
    },

    "points of a chart tell their names by key and pointer, and no labels meet": async (gallery) => {
        await gallery.open();
        assert.deepEqual(await gallery.tab.evaluate(collidingLabels), []);
        const chart = gallery.article.locator(".chart:has(.point)").first();
        const count = await chart.locator(".point").count();
        assert.equal(count, await gallery.article.locator("tbody tr").count(), "a technique is not in the chart");
        await chart.locator("svg").focus();
        for (let i = 0; i < count; ++i) {
            await gallery.tab.keyboard.press("ArrowRight");
            assert.equal(await chart.locator(".point:focus .label").isVisible(), true);
            assert.deepEqual(await gallery.tab.evaluate(collidingLabels), []);
        }
        await chart.locator(".point.a circle").last().hover({force: true});
        assert.equal(await chart.locator(".point.a .label").isVisible(), true);
    },

    "only what does not agree can be asked for": async (gallery) => {
        const shown = () => gallery.tab.locator("#papers .verdict").evaluateAll(
            (cells) => cells.filter((cell) => cell.checkVisibility()).map((cell) => cell.textContent));
        const all = await shown();
        await gallery.tab.locator("#only-differing").check();
        assert.deepEqual(await shown(), all.filter((verdict) => verdict !== "agrees"));
        await gallery.tab.locator("#only-differing").uncheck();
    },

    "whole at 390 pixels, with a finger": async (gallery) => {
        await gallery.tab.setViewportSize(NARROW);
        await gallery.open();
        await gallery.tab.locator("summary").evaluateAll((all) => all.forEach((summary) => summary.click()));
        await isWhole(gallery);
        assert.deepEqual(await gallery.tab.evaluate(collidingLabels), []);
        await gallery.stage.scrollIntoViewIfNeeded();
        const {x, y, width, height} = await gallery.stage.boundingBox();
        const finger = await gallery.tab.context().newCDPSession(gallery.tab);
        const touch = (type, share) => finger.send("Input.dispatchTouchEvent", {
            type, touchPoints: share === null ? [] : [{x: x + share * width, y: y + height / 2}]});
        await touch("touchStart", 0.5);
        for (const share of [0.6, 0.7, 0.8])
            await touch("touchMove", share);
        await touch("touchEnd", null);
        assert.ok(Math.abs(await gallery.at() - 80) <= 1, `at ${await gallery.at()}`);
    },
};

for (const colorScheme of ["light", "dark"]) {
    cases[`texts and marks stand out, ${colorScheme}`] = async (gallery) => {
        await gallery.tab.emulateMedia({colorScheme});
        await gallery.tab.setViewportSize(WIDE);
        await gallery.open();
        await gallery.tab.locator("summary").evaluateAll((all) => all.forEach((summary) => summary.click()));
        const {faint, least, count} = await gallery.tab.evaluate(faintTexts);
        console.log(`     ${count} parts, least contrast ${least.toFixed(2)}`);
        assert.ok(count > 100);
        assert.deepEqual(faint, []);
    };
}

cases["without scripts the first pair stands side by side"] = async (gallery) => {
    const {said} = await withTab({viewport: NARROW, javaScriptEnabled: false}, async (tab) => {
        await tab.goto(gallery.url);
        const boxes = [];
        for (const image of await tab.locator("article .stage >> nth=0 >> img").all()) {
            await image.scrollIntoViewIfNeeded();
            boxes.push(await image.boundingBox());
        }
        assert.ok(boxes.every(({width}) => width > 100) && boxes[0].x !== boxes[1].x, JSON.stringify(boxes));
        assert.equal(await tab.locator("select").first().isVisible(), false, "a select that does nothing");
    });
    assert.deepEqual(said, []);
};

process.exit(await runCases(path, {viewport: WIDE, hasTouch: true}, cases, Gallery) ? 1 : 0);
