// The page from a static host, as from disk: served.mjs PAGE
import assert from "node:assert/strict";
import {spawn} from "node:child_process";
import {dirname} from "node:path";
import {runCases} from "./page.mjs";

const folder = dirname(process.argv[2]);
const server = spawn("python3", ["-u", "-m", "http.server", "0", "--bind", "127.0.0.1", "--directory", folder],
                     {stdio: ["ignore", "pipe", "ignore"]});
const port = await new Promise((resolve, reject) => {
    server.on("error", reject);
    server.on("exit", (code) => reject(new Error(`the server ends with ${code}`)));
    let said = "";
    server.stdout.on("data", (text) => {
        said += text;
        const found = /port (\d+) .*\n/.exec(said);
        if (found)
            resolve(found[1]);
    });
});
const asked = [];
const failed = await runCases(`http://127.0.0.1:${port}/index.html`, {viewport: {width: 640, height: 480}}, {
    "the page is one file, and shows what its address says": async (viewer) => {
        viewer.tab.on("request", (request) => asked.push(new URL(request.url()).pathname));
        await viewer.open("#scene=planes&left=vsm&right=exact&size=256");
        assert.equal(await viewer.state("scene"), "planes");
        assert.ok((await viewer.figures("left")).rmse > 0);
        assert.equal((await viewer.figures("right")).rmse, 0);
        assert.deepEqual(asked.filter((path) => !["/index.html", "/favicon.ico", "blank"].includes(path)), []);
    },
}).finally(() => server.kill());
process.exit(failed ? 1 : 0);
