// The sampling wrappers and the ready passes in a browser, compared with C++:
//   passes.mjs PAGE LANGUAGE FOLDER SINGLE KERNELS JUDGE
// PAGE: the module that plays the script. FOLDER: of this test's own. JUDGE: the program lvsm_web.
import {spawnSync} from "node:child_process";
import {mkdirSync, rmSync} from "node:fs";
import {dirname} from "node:path";
import {fileURLToPath} from "node:url";
import {consoleStatus, runPage} from "./browser.mjs";

const [page, language, folder, single, kernels, judge] = process.argv.slice(2);
const words = [language, folder, "--single", single, "--kernels", kernels];
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder);
if (spawnSync(judge, ["write", ...words], {stdio: "inherit"}).status !== 0)
    process.exit(1);
const {result, said, browser} = await runPage(`/clients/page.html?${page}`, {
    "/clients/": dirname(fileURLToPath(import.meta.url)), "/rows/": folder});
console.log(`${result}, ${browser}`);
const {status} = spawnSync(judge, ["judge", ...words], {stdio: "inherit"});
process.exit(consoleStatus(said) || status);
