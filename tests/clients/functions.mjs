// Every function of the library in a browser: functions.mjs ROWS SINGLE JUDGE REPORT
// ROWS: a folder of this test's own. SINGLE: the folder of lvsm_all.glsl. JUDGE: the program lvsm_client_rows.
import {spawnSync} from "node:child_process";
import {mkdirSync, rmSync} from "node:fs";
import {dirname} from "node:path";
import {fileURLToPath} from "node:url";
import {consoleStatus, runPage} from "./browser.mjs";

const [rows, single, judge, report] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
rmSync(rows, {recursive: true, force: true});
mkdirSync(rows);
const written = spawnSync(judge, ["write", rows], {stdio: "inherit"});
if (written.status !== 0)
    process.exit(1);
const {result, said, browser} = await runPage("/clients/page.html?functions_page.js",
                                              {"/clients/": here, "/rows/": rows, "/single/": single});
const client = `three.js r${result.version}, ${browser}`;
const judged = spawnSync(judge, ["judge", rows, client, report], {stdio: "inherit"});
process.exit(consoleStatus(said) || judged.status);
