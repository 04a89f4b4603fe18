// The README's quick start in three.js, against plain filtering of the same window:
//   quick_start.mjs SINGLE WASM [--record]
// Runs the very text of the README, writes what it looks like to the current folder, prints the errors in grey levels,
// and fails where one is not what tests/clients/recorded.json holds and the documents show; --record writes that.
import {existsSync, readFileSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {consoleStatus, runPage} from "./browser.mjs";

const [single, wasm, option] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const recordedPath = join(here, "recorded.json");
// Another browser or processor may round otherwise; what is recorded is worth two digits.
const same = (a, b) => Math.abs(a - b) <= Math.max(0.05, 0.05 * Math.abs(b));

if (!existsSync(join(wasm, "lvsm.mjs"))) {
    console.log("skipped: no lvsm.mjs, which needs clang, lld and the libraries for WebAssembly");
    process.exit(77);
}
const sections = readFileSync(join(here, "../../README.md"), "utf8").split(/^## /m);
const chunk = sections.find((text) => text.startsWith("Quick start")).match(/^```glsl\n(.*?)^```/ms)[1];
const {result, said, browser} = await runPage("/clients/page.html?quick_start_page.js",
                                              {"/clients/": here, "/single/": single, "/wasm/": wasm}, chunk);
let status = consoleStatus(said);
if (!result)
    process.exit(1);
for (const [name, url] of Object.entries(result.pictures))
    writeFileSync(`${name.replace(" ", "_")}.png`, Buffer.from(url.split(",")[1], "base64"));

const round = (value) => Number(value.toPrecision(3));
const rows = Object.fromEntries(Object.entries(result.errors).map(([name, error]) => [name, round(error)]));
const now = {command: "tests/clients/run quick_start.mjs", browser, lloyd: round(result.lloyd),
             optimal: round(result.optimal), errors: rows};
if (option === "--record")
    writeFileSync(recordedPath, JSON.stringify(now, null, 1) + "\n");
const recorded = JSON.parse(readFileSync(recordedPath, "utf8"));
for (const [name, error] of Object.entries(rows)) {
    const as = recorded.errors[name];
    console.log(`${name}: ${error}`);
    if (as === undefined || !same(error, as)) {
        console.log(`FAIL ${name}: recorded is ${as}`);
        status = 1;
    }
}
for (const name of Object.keys(recorded.errors).filter((name) => !(name in rows))) {
    console.log(`FAIL ${name} is recorded and was not tried`);
    status = 1;
}
console.log(`splits: lloydRelax ${now.lloyd}, optimalSplits ${now.optimal}; ${browser}`);
status |= same(now.lloyd, recorded.lloyd) && same(now.optimal, recorded.optimal) ? 0 : 1;
process.exit(status);
