// Starts the viewer, or says what it lacks.
import {describeLack, deviceOf} from "./device.js";
import {Viewer} from "./viewer.js";

const lack = describeLack();
const message = document.getElementById("message");
message.hidden = !lack;
message.textContent = lack;
if (!lack) {
    document.getElementById("viewer").hidden = false;
    const viewer = new Viewer(deviceOf(document.createElement("canvas")));
    viewer.start();
    // For whoever automates the page: when this resolves, all that was asked for is on the screen.
    window.lvsmViewer = viewer;
}
