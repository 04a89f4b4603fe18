// Files that are dropped on the page or chosen with its button.
import {loadModel} from "./models.js";

// load(scene) is called with what was read, fail(text) with why it was not.
export function acceptModels(input, hint, load, fail) {
    const read = async (files) => {
        if (files.length === 0)
            return;
        try {
            load(await loadModel(files));
        } catch (error) {
            fail(error.message);
        }
    };
    input.addEventListener("change", async () => {
        await read([...input.files]);
        input.value = "";
    });
    document.addEventListener("dragover", (event) => {
        event.preventDefault();
        hint.hidden = false;
    });
    document.addEventListener("dragleave", (event) => hint.hidden = hint.hidden || !event.relatedTarget);
    document.addEventListener("drop", (event) => {
        event.preventDefault();
        hint.hidden = true;
        read([...event.dataTransfer.files]);
    });
}
