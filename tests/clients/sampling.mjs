// The one-file wrappers and fragment passes in WebGL2, whose language gathers nothing: they link without a word from the
// compiler, and wrappers that gather or sample over the map's edge answer what they should: sampling.mjs SINGLE
import {dirname} from "node:path";
import {fileURLToPath} from "node:url";
import {consoleStatus, runPage} from "./browser.mjs";

const [single] = process.argv.slice(2);
const {result, said} = await runPage("/clients/page.html?sampling_page.js",
                                     {"/clients/": dirname(fileURLToPath(import.meta.url)), "/single/": single});
let status = consoleStatus(said);
for (const [what, answer, expected] of result) {
    // Quotients of small whole numbers, and the bilinear weights of a sampler, in 256ths at least.
    const passed = Math.abs(answer - expected) < 1 / 512;
    console.log(`${passed ? "ok  " : "FAIL"} ${what}: ${answer}, expected ${expected}`);
    status = passed ? status : 1;
}
process.exit(result.length > 0 ? status : 1);
