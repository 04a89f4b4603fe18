// Every function of the library in a browser: functions.mjs PAGE ROWS SINGLE JUDGE REPORT ORDER
// PAGE: the module that runs them. ROWS: a folder of this test's own. SINGLE: that of the one-file versions. JUDGE: the
// program lvsm_client_rows. ORDER: `precise` or `imprecise`, as it takes it.
import {spawnSync} from "node:child_process";
import {mkdirSync, rmSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {consoleStatus, runPage} from "./browser.mjs";

const [page, rows, single, judge, report, order] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
rmSync(report, {force: true}); // what an earlier run wrote says nothing about this one
rmSync(rows, {recursive: true, force: true});
mkdirSync(rows);
const written = spawnSync(judge, ["write", rows], {stdio: "inherit"});
if (written.status !== 0)
    process.exit(1);
const {result, said, browser} = await runPage(`/clients/page.html?${page}`,
                                              {"/clients/": here, "/rows/": rows, "/single/": single});
writeFileSync(join(rows, "version"), `${result.version}, ${browser}`);
const judged = spawnSync(judge, ["judge", rows, result.client, report, order], {stdio: "inherit"});
process.exit(consoleStatus(said) || judged.status);
