// The WebAssembly module places the splits that C++ places, and says the same: wasm.mjs MODULE NATIVE FOLDER
// NATIVE: the program lvsm_client_splits. FOLDER: of this test's own.
import {spawnSync} from "node:child_process";
import {existsSync, mkdirSync, readFileSync} from "node:fs";

const [path, native, folder] = process.argv.slice(2);
if (!existsSync(path)) {
    console.log(`skipped: no ${path}, which needs clang, lld and the libraries for WebAssembly`);
    process.exit(77);
}
const lvsm = await import(path);
mkdirSync(folder, {recursive: true});
if (spawnSync(native, [folder], {stdio: "inherit"}).status !== 0)
    process.exit(1);

// Native compilers may contract a product and a sum, which moves a split by some units in the last place.
const TOLERANCE = 2 ** -20;
let failed = 0;
let worst = 0;
const rows = JSON.parse(readFileSync(`${folder}/splits.json`, "utf8"));
for (const row of rows) {
    const bytes = readFileSync(`${folder}/${row.image}.depths`);
    const depths = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
    let answer;
    try {
        const result = lvsm[row.function](depths, row.width, row.height, row.layerCount, row.options);
        answer = {placed: true, message: result.message, splits: [...result.splits]};
    } catch (error) {
        answer = {placed: false, message: error.message, splits: row.splits};
    }
    const error = Math.max(...row.splits.map((split, index) => Math.abs(split - answer.splits[index])));
    worst = Math.max(worst, error);
    if (answer.placed !== row.placed || answer.message !== row.message || !(error <= TOLERANCE)) {
        ++failed;
        console.log(`FAIL ${row.function}, ${row.layerCount} layers of ${row.image}: ${JSON.stringify(answer)} where`,
                    `C++ has ${JSON.stringify(row)}`);
    }
}

// The wrapper's own refusals, and its memory, which must not lose an image when it grows.
const refused = [() => lvsm.lloydRelax([0, 1], 2, 1, 2), () => lvsm.lloydRelax(new Float32Array(3), 2, 1, 2),
                 () => lvsm.optimalSplits(new Float32Array(2), 2, 1, 2, {nosuch: 1}),
                 () => lvsm.optimalSplits(new Float32Array(2), 2, 1, 1.5)];
for (const call of refused) {
    try {
        call();
        ++failed;
        console.log(`FAIL ${call} is not refused`);
    } catch (error) {
        failed += error instanceof TypeError ? 0 : 1;
    }
}
const kept = lvsm.lloydRelax(new Float32Array([0, 1, 0.5, 0.7]), 2, 2, 2,
                             {keepSplits: true, maxIterations: 0, splits: new Float32Array([0, 0.3, 1])});
failed += Math.abs(kept.splits[1] - 0.3) < 1e-6 ? 0 : 1;

const bytes = readFileSync(`${folder}/large.depths`);
const large = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
for (const name of ["lloydRelax", "optimalSplits"]) {
    const times = Array.from({length: 9}, () => {
        const start = performance.now();
        lvsm[name](large, 512, 512, 4);
        return performance.now() - start;
    });
    console.log(`${name} of 512 x 512 depths: ${Math.min(...times).toFixed(2)} ms at best`);
}
console.log(`version ${lvsm.version}: ${rows.length} placements, the worst ${worst} from C++, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
