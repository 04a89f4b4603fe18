// A page in headless Chromium, served from folders of this machine, with nothing of the page's console lost.
import {createReadStream, existsSync} from "node:fs";
import {writeFile} from "node:fs/promises";
import {createServer} from "node:http";
import {createRequire} from "node:module";
import {extname, join, normalize} from "node:path";

// The packages lie in the current folder, not beside this file.
const {chromium} = createRequire(join(process.cwd(), "package.json"))("playwright-core");

const TYPES = {".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".json": "application/json"};
const FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--enable-unsafe-webgpu",
               "--use-webgpu-adapter=swiftshader", "--disable-quic",
               "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
// What the driver says of our reading pixels back, and of no shader.
const READBACK = /GPU stall due to ReadPixels/;

// folders: {"/name/": path}. PUT writes a file, GET reads one.
function serve(folders) {
    const pathOf = (url) => {
        const [prefix, folder] = Object.entries(folders).find(([name]) => url.startsWith(name)) ?? [];
        return prefix && join(folder, normalize("/" + url.slice(prefix.length)));
    };
    const server = createServer(async (request, response) => {
        const path = pathOf(new URL(request.url, "http://localhost").pathname);
        if (request.method === "PUT" && path) {
            const parts = [];
            for await (const part of request)
                parts.push(part);
            await writeFile(path, Buffer.concat(parts));
            response.end();
        } else if (path && existsSync(path)) {
            response.setHeader("content-type", TYPES[extname(path)] ?? "application/octet-stream");
            createReadStream(path).pipe(response);
        } else {
            response.statusCode = request.url === "/favicon.ico" ? 204 : 404;
            response.end();
        }
    });
    return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

// Gives act an empty tab and the list of what its console says from then on; options are those of Playwright's newPage,
// flags more of the browser's. browser: its name and version.
export async function withTab(options, act, flags = []) {
    const browser = await chromium.launch({executablePath: process.env.LVSM_CHROMIUM ?? "/usr/bin/chromium",
                                           args: [...FLAGS, ...flags]});
    try {
        const tab = await browser.newPage(options);
        const said = [];
        tab.on("console", (message) => {
            if (!READBACK.test(message.text()))
                said.push(`${message.type()}: ${message.text()}`);
        });
        tab.on("pageerror", (error) => said.push(`error: ${error.stack}`));
        return {result: await act(tab, said), said, browser: `Chromium ${browser.version()}`};
    } finally {
        await browser.close();
    }
}

// Opens the page, waits for what its function main() resolves to, and gives that and what the console said. The page's
// modules import "three" from the current folder's packages.
export async function runPage(page, folders, argument) {
    const server = await serve({"/packages/": join(process.cwd(), "node_modules"), ...folders});
    try {
        return await withTab({}, async (tab) => {
            await tab.goto(`http://127.0.0.1:${server.address().port}${page}`);
            await tab.waitForFunction("window.main || window.failed", null, {timeout: 60000});
            return tab.evaluate((value) => window.main(value), argument);
        });
    } finally {
        server.close();
    }
}

// Prints what the console said; the status to exit with: a page that says anything has failed.
export function consoleStatus(said) {
    for (const line of new Set(said))
        console.log(`FAIL the browser's console says ${line}`);
    return said.length > 0 ? 1 : 0;
}
