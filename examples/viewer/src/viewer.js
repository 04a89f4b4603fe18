// The page: state, panel and picture joined.
import {acceptModels} from "./drop.js";
import {makeCamera, makeDivider, makeLightHandle} from "./handles.js";
import {anglesOf} from "./light.js";
import {Loop, SIDES} from "./loop.js";
import {Control, element, SidePanel} from "./panel.js";
import {Picture} from "./picture.js";
import {describeSide, describeTimes} from "./report.js";
import {makeScene} from "./scenes.js";
import {SETTINGS} from "./settings.js";
import {makeShare} from "./share.js";
import {SplitEditor} from "./splits.js";
import {State} from "./state.js";
import {TECHNIQUES} from "./techniques.js";
import {describeView} from "./views.js";

const ADDRESS_AFTER = 300;
// Settings that change the picture, but neither maps nor what is judged by them.
const SHOWN = new Set(["divider", "view"]);

const byId = (id) => document.getElementById(id);

export class Viewer {
    constructor(device) {
        this.device = device;
        this.state = new State({device: () => device, kernel: () => this.loop.kernel(),
                                initial: (name) => this.initial(name)});
        this.picture = new Picture(byId("canvas"));
        this.scene = makeScene("bench");
        this.camera = makeCamera(byId("canvas"), this.state);
        this.loop = new Loop(this, byId("frame"));
        this.makePanel();
        this.share = makeShare(this);
    }

    // Where the light stands by itself is the scene's.
    initial(name) {
        const angle = anglesOf(this.scene.lightDirection)[name];
        return angle === undefined ? undefined : Math.round(angle);
    }

    makePanel() {
        const {state} = this;
        const controls = (names, root) => names.map((name) => {
            const control = new Control(state, name, SETTINGS[name]);
            byId(root).append(control.root);
            return control;
        });
        this.controls = [...controls(["scene", "light", "azimuth", "elevation", "moving"], "scene-panel"),
                         ...controls(["size", "kernel", "taps", "mipmaps", "anisotropy"], "map-panel")];
        this.editors = Object.fromEntries(SIDES.map((side) => [side, new SplitEditor(state, side)]));
        this.sides = SIDES.map((side) => new SidePanel(byId(`${side}-panel`), state, side, this.editors[side]));
        this.handles = [makeDivider(byId("divider"), byId("frame"), state), makeLightHandle(byId("light-handle"), state)];
        this.views = SETTINGS.view.options.map(([value, name]) => {
            const input = element("input", {type: "radio", name: "view", value});
            input.addEventListener("change", () => state.set("view", value));
            byId("views").append(element("label", {}, input, name));
            return input;
        });
        byId("panel").addEventListener("submit", (event) => event.preventDefault());
    }

    start() {
        this.state.addEventListener("change", ({detail}) => this.changed(detail));
        window.addEventListener("hashchange", () => {
            if (location.hash !== this.state.toAddress())
                this.state.fromAddress(location.hash);
        });
        this.camera.controls.addEventListener("change", () => this.loop.invalidate());
        acceptModels(byId("model"), byId("drop"), (scene) => this.showModel(scene), (text) => this.say(text, true));
        byId("canvas").addEventListener("webglcontextlost",
                                        () => this.say("The graphics context is lost. It is asked for again.", true));
        byId("canvas").addEventListener("webglcontextrestored",
                                        () => this.say("The graphics context was lost, and is back."));
        this.state.fromAddress(location.hash);
    }

    changed(name) {
        if (name === "scene" || name === "address")
            this.showScene(makeScene(this.state.get("scene")));
        if (name === "camera" || name === "address" || name === "scene")
            this.camera.place(this.state.get("camera"), this.scene.camera);
        clearTimeout(this.addressTimer);
        this.addressTimer = setTimeout(() => history.replaceState(null, "", this.state.toAddress()), ADDRESS_AFTER);
        this.updatePanel();
        this.loop.invalidate(SHOWN.has(name));
    }

    showScene(scene) {
        this.scene = scene;
        this.picture.setScene(scene);
        this.loop.splits = {};
        this.picture.forgetSteps();
    }

    showModel(scene) {
        this.showScene(scene);
        this.state.set("camera", undefined);
        this.say(`${scene.title} is shown. It is not in the address: whoever gets the link sees the scene of the list.`);
    }

    updatePanel() {
        for (const part of [...this.controls, ...this.sides, ...this.handles])
            part.update();
        const filters = SIDES.some((side) => TECHNIQUES[this.state.get(side)].filtered);
        const isUsed = {mipmaps: filters, anisotropy: filters && this.state.get("mipmaps")};
        for (const {name, root} of this.controls)
            root.hidden = !(isUsed[name] ?? true);
        for (const input of this.views)
            input.checked = input.value === this.state.get("view");
        byId("legend").replaceChildren(...describeView(this.state.get("view")));
        this.share?.update();
    }

    // The loop tells what it did.
    placed(side, splits, histogram) {
        this.editors[side].update(splits, histogram);
    }

    drawn() {
        for (const side of SIDES)
            describeSide(side, this.state.side(side), this.loop.figures[side]);
        describeTimes(this.picture.timer);
    }

    say(text, isBad = false) {
        byId("status").textContent = text;
        byId("status").classList.toggle("bad", isBad);
    }
}
