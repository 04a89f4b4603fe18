// The viewer in a tab, opened from disk or from a server, for the tests of this folder.
import assert from "node:assert/strict";
import {existsSync} from "node:fs";
import {pathToFileURL} from "node:url";
import {withTab} from "../clients/browser.mjs";

export class Viewer {
    constructor(tab, path, said) {
        Object.assign(this, {tab, said, url: path.startsWith("http:") ? path : pathToFileURL(path).href});
    }

    // Opens an address anew, and waits for its picture and error.
    async open(address = "") {
        await this.tab.goto("about:blank");
        await this.tab.goto(this.url + address);
        await this.tab.waitForFunction("window.lvsmViewer", null, {timeout: 30000});
        await this.settled();
    }

    // Another address in the page that is open, and its picture and error.
    async go(address) {
        await this.choose(address);
        await this.settled();
    }

    // The same without waiting for a picture.
    choose(address) {
        return this.tab.evaluate((hash) => new Promise((resolve) => {
            if (location.hash === hash)
                return resolve();
            addEventListener("hashchange", () => resolve(), {once: true});
            location.hash = hash;
        }), address);
    }

    settled() {
        return this.tab.evaluate(() => window.lvsmViewer.loop.settled());
    }

    // Waits for the next frame but one: what was asked for is on the screen.
    drawn() {
        return this.tab.evaluate(() => new Promise((resolve) => {
            const {loop} = window.lvsmViewer;
            const look = () => (loop.request ? setTimeout(look, 10) : resolve());
            look();
        }));
    }

    state(name) {
        return this.tab.evaluate((key) => window.lvsmViewer.state.get(key), name);
    }

    address() {
        return this.tab.evaluate(() => window.lvsmViewer.state.toAddress());
    }

    // {rmse, lighter, darker} of a side.
    figures(side) {
        return this.tab.evaluate((name) => window.lvsmViewer.loop.figures[name], side);
    }

    // The picture's pixels as greys.
    greys() {
        return this.tab.evaluate(() => {
            // A canvas keeps its pixels until the task that drew them ends.
            window.lvsmViewer.loop.show();
            const canvas = document.getElementById("canvas");
            const context = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
            context.drawImage(canvas, 0, 0);
            const {data} = context.getImageData(0, 0, canvas.width, canvas.height);
            const grey = (i) => Math.round((data[i] + data[i + 1] + data[i + 2]) / 3);
            return Array.from({length: data.length / 4}, (_, i) => grey(4 * i));
        });
    }

    async drag(selector, dx, dy) {
        const {x, y, width, height} = await this.tab.locator(selector).boundingBox();
        const [fromX, fromY] = [x + width / 2, y + height / 2];
        await this.tab.mouse.move(fromX, fromY);
        await this.tab.mouse.down();
        await this.tab.mouse.move(fromX + dx / 2, fromY + dy / 2, {steps: 3});
        await this.tab.mouse.move(fromX + dx, fromY + dy, {steps: 3});
        await this.tab.mouse.up();
        await this.drawn();
    }

    async press(selector, ...keys) {
        await this.tab.locator(selector).focus();
        for (const key of keys)
            await this.tab.keyboard.press(key);
        await this.drawn();
    }

    text(selector) {
        return this.tab.locator(selector).textContent();
    }
}

// Runs the cases {name: async (viewer) => ...} one after the other in one tab, and says of each whether it passed. A word
// on the console fails the case in which it was said. Page is what the cases get, made of tab, path and the words.
export async function runCases(path, options, cases, Page = Viewer) {
    if (!path.startsWith("http:") && !existsSync(path)) {
        console.log(`skipped: no ${path}`);
        process.exit(77);
    }
    let failed = 0;
    await withTab(options, async (tab, said) => {
        const viewer = new Page(tab, path, said);
        for (const [name, act] of Object.entries(cases)) {
            const start = Date.now();
            try {
                await act(viewer);
                assert.deepEqual(said, [], "the console says something");
                console.log(`ok   ${name}, ${((Date.now() - start) / 1000).toFixed(1)} s`);
            } catch (error) {
                ++failed;
                console.log(`FAIL ${name}: ${error.stack}`);
            }
            said.length = 0;
        }
    });
    return failed;
}
