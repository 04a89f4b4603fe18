// The npm package as a stranger takes it: packed, installed elsewhere, type-checked, bundled, and run in the browser.
//   npm_package.mjs SINGLE WASM VERSION FOLDER
import {spawnSync} from "node:child_process";
import {existsSync, mkdirSync, rmSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {consoleStatus, runPage} from "./browser.mjs";

const [single, wasm, version, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const packages = join(process.cwd(), "node_modules");
if (!existsSync(join(wasm, "lvsm.mjs"))) {
    console.log("skipped: no lvsm.mjs, which needs clang, lld and the libraries for WebAssembly");
    process.exit(77);
}

function run(command, words, where) {
    const done = spawnSync(command, words, {cwd: where, encoding: "utf8"});
    if (done.status !== 0) {
        console.log(`FAIL ${command} ${words.join(" ")}\n${done.stdout}${done.stderr}${done.error ?? ""}`);
        process.exit(1);
    }
    return done.stdout;
}

rmSync(folder, {recursive: true, force: true});
mkdirSync(join(folder, "app"), {recursive: true});
run("node", [join(here, "../../npm/build.mjs"), single, wasm, version, join(folder, "package")]);
const archive = run("npm", ["pack", "./package", "--silent"], folder).trim();

const app = join(folder, "app");
writeFileSync(join(app, "package.json"), '{"name": "app", "private": true, "type": "module"}\n');
run("npm", ["install", "--offline", "--no-audit", "--no-fund", join(folder, archive)], app);
writeFileSync(join(app, "app.ts"), `
import glsl from "lvsm/glsl";
import hlsl from "lvsm/hlsl";
import wgsl from "lvsm/wgsl";
import wrappers from "lvsm/glsl-sampling";
import hlslWrappers from "lvsm/hlsl-sampling";
import wgslWrappers from "lvsm/wgsl-sampling";
import {lloydRelax, optimalSplits, version} from "lvsm/host";

function compiles(text: string): string {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2")!;
    const shader = gl.createShader(gl.FRAGMENT_SHADER)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? "compiles" : gl.getShaderInfoLog(shader) ?? "";
}

export async function main() {
    const depths = Float32Array.from({length: 64 * 64}, (_, i) => (i % 64 < 20 ? 0.2 : i % 64 < 40 ? 0.5 : 0.8));
    const head = "#version 300 es\\nprecision highp float;\\nprecision highp int;\\n";
    const body = "out vec4 c; void main() { c = vec4(lvsm_bracketedVisibility2(vec4(0.5), 0.7, 0.5, 1.0e-5)); }";
    const relaxed: Float32Array = lloydRelax(depths, 64, 64, 2, {maxIterations: 32}).splits;
    const sampled = "uniform highp sampler2DArray m; out vec4 c; void main() { c = vec4(lvsm_sampleVariance(m, " +
        "lvsm_mapPoint(vec2(0.5), vec2(0.0), vec2(0.0), 0), 0.5, 0.0)); }";
    return {shader: compiles(head + glsl + body), wrapper: compiles(head + wrappers + sampled),
            wrappers: hlslWrappers.includes("float lvsm_sampleVariance") && wgslWrappers.includes("fn lvsm_sampleVariance"),
            hlsl: hlsl.includes("float lvsm_bracketedVisibility2"),
            wgsl: wgsl.includes("fn lvsm_bracketedVisibility2"), version,
            lloyd: relaxed[1], optimal: optimalSplits(depths, 64, 64, 2).splits[1]};
}
`);
run("node", [join(packages, "typescript/bin/tsc"), "--noEmit", "--strict", "--target", "es2022", "--module", "nodenext",
             "--lib", "es2022,dom", "app.ts"], app);
const esbuild = createRequire(join(process.cwd(), "package.json"))("esbuild");
await esbuild.build({entryPoints: [join(app, "app.ts")], outfile: join(folder, "bundle.js"), bundle: true,
                     format: "esm", logLevel: "warning"});

const {result, said} = await runPage("/clients/page.html?../bundle/bundle.js", {"/clients/": here, "/bundle/": folder});
let status = consoleStatus(said);
const [major, minor, patch] = version.split(".").map(Number);
for (const [name, is, right] of [
    ["shader", result?.shader, (value) => value === "compiles"],
    ["wrapper", result?.wrapper, (value) => value === "compiles"],
    ["wrappers in HLSL and WGSL", result?.wrappers, (value) => value],
    ["hlsl", result?.hlsl, (value) => value],
    ["wgsl", result?.wgsl, (value) => value],
    ["version", result?.version, (value) => value === 10000 * major + 100 * minor + patch],
    ["lloydRelax", result?.lloyd, (value) => value > 0.2 && value < 0.8],
    ["optimalSplits", result?.optimal, (value) => value > 0.2 && value < 0.8],
    ["licence", existsSync(join(app, "node_modules/lvsm/LICENSE")), (value) => value],
    ...["all.glsl", "blur.frag", "step_move.frag", "store.wgsl", "blur.wgsl", "mip.wgsl", "step_sums.wgsl"].map((file) =>
        [file, existsSync(join(app, `node_modules/lvsm/shaders/lvsm_${file}`)), (value) => value]),
]) {
    console.log(`${right(is) ? "ok  " : "FAIL"} ${name}: ${is}`);
    status |= right(is) ? 0 : 1;
}
process.exit(status);
