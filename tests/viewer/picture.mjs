// The picture of the README, docs/viewer.png: picture.mjs PAGE
import {fileURLToPath} from "node:url";
import {resolve} from "node:path";
import {runCases} from "./page.mjs";

const out = fileURLToPath(new URL("../../docs/viewer.png", import.meta.url));
const options = {viewport: {width: 1280, height: 800}, colorScheme: "light"};
process.exit(await runCases(resolve(process.argv[2]), options, {
    [`writes ${out}`]: async (viewer) => {
        await viewer.open("#left=vsm&right=bracketed&divider=0.42");
        await viewer.tab.screenshot({path: out});
    },
}) ? 1 : 0);
