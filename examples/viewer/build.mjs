// Bundles the viewer into one file that opens from disk: build.mjs SINGLE WASM VERSION OUTPUT
// SINGLE: the folder of the one-file shaders. WASM: that of lvsm.mjs. The packages lie in the current folder.
import {spawnSync} from "node:child_process";
import {existsSync, mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const [single, wasm, version, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(process.cwd(), "package.json"))("esbuild");
if (!existsSync(join(wasm, "lvsm.mjs"))) {
    console.log("skipped: no lvsm.mjs, which needs clang, lld and the libraries for WebAssembly");
    process.exit(77);
}

// The viewer takes the library as everybody does, from its npm package.
mkdirSync(output, {recursive: true});
const packages = join(output, "packages");
const words = [join(here, "../../npm/build.mjs"), single, wasm, version, join(packages, "lvsm")];
const made = spawnSync("node", words, {stdio: "inherit"});
if (made.status !== 0)
    process.exit(1);
const bundled = await esbuild.build({
    entryPoints: [join(here, "src/main.js")], bundle: true, write: false, format: "esm", target: "es2022", minify: true,
    legalComments: "inline", charset: "utf8", logLevel: "warning", loader: {".glsl": "text", ".frag": "text"},
    nodePaths: [packages, join(process.cwd(), "node_modules")],
});
// A module within the page needs no second file, which pages from disk may not load.
const script = bundled.outputFiles[0].text.replaceAll("</script", "<\\/script");
const page = readFileSync(join(here, "index.html"), "utf8")
    .replace("/* STYLE */", () => readFileSync(join(here, "viewer.css"), "utf8"))
    .replace("/* SCRIPT */", () => script);
writeFileSync(join(output, "index.html"), page);
console.log(`wrote ${join(output, "index.html")}, ${Math.round(page.length / 1024)} KiB`);
