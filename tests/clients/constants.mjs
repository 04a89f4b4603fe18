// A literal is the float itself in a browser, or the next one to 0, which ANGLE makes of some, and the shader compiler
// has nothing to say: constants.mjs SINGLE
import {readFileSync} from "node:fs";
import {dirname} from "node:path";
import {fileURLToPath} from "node:url";
import {consoleStatus, runPage} from "./browser.mjs";

const [single] = process.argv.slice(2);
const {result, said} = await runPage("/clients/page.html?constants_page.js",
                                     {"/clients/": dirname(fileURLToPath(import.meta.url)), "/single/": single});
const library = readFileSync(`${single}/lvsm_all.glsl`, "utf8");
let status = consoleStatus(said);
let compared = 0;
for (const [, name, value] of library.matchAll(/^const float (\w+) = (-?[\d.e+-]+);/gm)) {
    const written = new Uint32Array(new Float32Array([Number(value)]).buffer)[0];
    ++compared;
    if (result[name] !== written && result[name] !== written - 1) {
        console.log(`FAIL ${name} is ${value}, and has the bits ${result[name]?.toString(16)} in a shader`);
        status = 1;
    }
}
console.log(`${compared} constants compared`);
process.exit(compared > 10 ? status : 1);
