// The script that `lvsm_web write` has left in /rows/, for a page to play, and the results that it leaves.
import {bytes, text} from "./rows_page.js";

// The texels of each level, and its size: all slices of level 0 first, then of level 1.
export function levelsOf({width, height, slices, levels}) {
    let at = 0;
    return Array.from({length: levels}, (_, level) => {
        const size = {level, at, width: Math.max(width >> level, 1), height: Math.max(height >> level, 1)};
        size.floats = 4 * size.width * size.height * slices;
        at += size.floats;
        return size;
    });
}

// act: one function for each kind of command; those of reading give the bytes, or a promise of them.
export async function playScript(act) {
    const commands = JSON.parse(await text("/rows/script.json"));
    const data = await bytes("/rows/script.data");
    const reads = [];
    for (const command of commands) {
        const done = act[command.do](command, data);
        if (command.do.startsWith("read"))
            reads.push(done);
    }
    await fetch("/rows/results", {method: "PUT", body: new Blob(await Promise.all(reads))});
}
