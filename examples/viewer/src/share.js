// What leaves the page: its address, and the shader text of a side with the settings as constants.
import {element} from "./panel.js";
import {pasteable} from "./glsl.js";
import {FORMATS} from "./formats.js";
import {sliceCount, TECHNIQUES} from "./techniques.js";

const byId = (id) => document.getElementById(id);

// Browsers refuse the clipboard to pages that are not secure; the text is selected then.
async function copied(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false;
    }
}

export function makeShare(viewer) {
    const {state} = viewer;

    function textOf(side, language) {
        const technique = state.get(side);
        const row = TECHNIQUES[technique];
        const own = state.side(side);
        const kernel = viewer.loop.kernel();
        const slices = sliceCount(row, own);
        const blur = row.filtered && kernel.taps > 1 ? `blurred by ${kernel.taps} taps (${state.get("kernel")}) in each direction`
                                                     : "not blurred";
        const count = slices > 1 ? `${slices} slices` : "one slice";
        const made = row.planes ? ["made by lvsm_mixture.frag or .comp, whose blocks are those of",
                                   `mixtureDraws or mixturePasses(${own.window}, ${own.half}, ...).`]
                                : [`${count}, ${blur};`, "cleared to store(1.0, slice)."];
        const header = [`${row.name}: ${FORMATS[own.format].name}, ${row.channels} components, ${made[0]}`, ...made.slice(1)];
        return pasteable(technique, own, viewer.loop.frameOf(side), language, header);
    }

    async function show(side, language) {
        const text = textOf(side, language);
        byId("code-title").textContent = `${TECHNIQUES[state.get(side)].name}, ${side}: ${language} with the chosen settings`;
        byId("code-text").value = text;
        byId("code-status").textContent = "";
        byId("code").showModal();
        byId("code-text").select();
        byId("code-status").textContent = await copied(text) ? "Copied." : "Selected: copy it with Ctrl+C or Cmd+C.";
    }

    const buttons = ["left", "right"].flatMap((side) => ["GLSL", "HLSL"].map((language) => {
        const button = element("button", {type: "button", id: `copy-${side}-${language.toLowerCase()}`,
                                          textContent: `${language}, ${side}`,
                                          title: `Copy the ${language} of the technique on the ${side}`});
        button.addEventListener("click", () => show(side, language));
        return {button, side};
    }));
    byId("copy-buttons").append(...buttons.map(({button}) => button));
    byId("copy-link").addEventListener("click", async () => {
        const address = location.href.replace(/#.*/, "") + state.toAddress();
        history.replaceState(null, "", state.toAddress());
        viewer.say(await copied(address) ? "The link is copied." : `Copy the link from the address bar: ${address}`);
    });
    return {
        textOf,
        update: () => buttons.forEach(({button, side}) => button.disabled = Boolean(TECHNIQUES[state.get(side)].exact)),
    };
}
