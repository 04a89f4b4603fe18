// Makes the npm package: node npm/build.mjs SINGLE WASM VERSION OUTPUT
// SINGLE: the folder of the one-file versions. WASM: that of lvsm.mjs and lvsm.d.mts. `npm pack OUTPUT` packs it.
import {copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const [single, wasm, version, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const NOTICE = "// SPDX-License-Identifier: MIT\n// Copyright (c) 2026 lvsm contributors\n";

rmSync(output, {recursive: true, force: true});
for (const folder of ["shaders", "host"])
    mkdirSync(join(output, folder), {recursive: true});
for (const file of readdirSync(single).filter((name) => name.startsWith("lvsm_")))
    copyFileSync(join(single, file), join(output, "shaders", file));
for (const file of ["lvsm.mjs", "lvsm.d.mts"])
    copyFileSync(join(wasm, file), join(output, "host", file));
copyFileSync(join(here, "../LICENSE"), join(output, "LICENSE"));
copyFileSync(join(here, "README.md"), join(output, "README.md"));

// The one-file versions as strings, so that no bundler needs a loader for them.
const TEXTS = {"glsl": "lvsm_all.glsl", "hlsl": "lvsm_all.hlsli", "wgsl": "lvsm_all.wgsl", "glsl-sampling": "lvsm_combined.glsl",
               "hlsl-sampling": "lvsm_separate.hlsli", "wgsl-sampling": "lvsm_separate.wgsl"};
for (const [name, file] of Object.entries(TEXTS)) {
    const text = JSON.stringify(readFileSync(join(single, file), "utf8"));
    writeFileSync(join(output, `${name}.mjs`), `${NOTICE}export default ${text};\n`);
    writeFileSync(join(output, `${name}.d.mts`),
                  `${NOTICE}/** The text of ${file}. */\ndeclare const text: string;\nexport default text;\n`);
}

const module = (path) => ({types: `./${path}.d.mts`, default: `./${path}.mjs`});
const manifest = {
    name: "lvsm",
    version,
    description: "The maths of filterable shadow maps, in GLSL, HLSL and WGSL, and placing their layers in WebAssembly",
    keywords: ["shadow", "shadow-map", "vsm", "evsm", "glsl", "hlsl", "wgsl", "webgl", "webgpu"],
    license: "MIT",
    type: "module",
    sideEffects: false,
    exports: {...Object.fromEntries(Object.keys(TEXTS).map((name) => [`./${name}`, module(name)])),
              "./host": module("host/lvsm"), "./shaders/*": "./shaders/*"},
    files: ["shaders", "host", "*.mjs", "*.mts"],
};
writeFileSync(join(output, "package.json"), JSON.stringify(manifest, null, 2) + "\n");
