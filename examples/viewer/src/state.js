// The state is a map from names to values, and all of it is in the address: #scene=bench&left=vsm&left.reduction=0.2.
// What is at its default is left out, so that a better default reaches old addresses.
import {LISTS, SETTINGS, SIDE_SETTINGS} from "./settings.js";
import {TECHNIQUES} from "./techniques.js";

const SIDES = ["left", "right"];

// A text of the address as a value of a setting, or undefined where it is none.
function parsed(setting, text) {
    if (setting.kind === "toggle")
        return {"on": true, "off": false}[text];
    if (setting.kind === "choice")
        return setting.options.map(([value]) => value).find((value) => String(value) === text);
    const number = text.trim() === "" ? NaN : Number(text);
    if (!Number.isFinite(number))
        return undefined;
    const least = setting.kind === "scale" ? 0 : setting.min;
    return Math.min(Math.max(number, least), setting.max);
}

function parsedList(length, text) {
    const numbers = text.split(",").map(Number);
    return numbers.length <= length && numbers.every(Number.isFinite) ? numbers : undefined;
}

// As the address has it, so that who opens it sees the very same.
const rounded = (number) => Number(number.toPrecision(5));
const written = (value) => (typeof value === "boolean" ? (value ? "on" : "off") : String(value));

export class State extends EventTarget {
    #values = new Map();

    // context: functions device() and kernel(), and initial(name) for defaults that depend on the scene.
    constructor(context) {
        super();
        this.context = context;
    }

    setting(name) {
        const [side, own] = name.split(".");
        return own ? SIDES.includes(side) && SIDE_SETTINGS[own] : SETTINGS[name];
    }

    // The formats that a technique can have here, the recommended one first.
    formats(technique) {
        const {formats, filtered, coded} = TECHNIQUES[technique];
        const has = (format) => this.context.device().formats.has(format);
        return formats.filter((format) => !filtered || has(format) && (!coded || has("fp32")));
    }

    isThere(technique) {
        return TECHNIQUES[technique].exact || this.formats(technique).length > 0;
    }

    initial(name) {
        const [side, own] = name.split(".");
        if (!own)
            return SETTINGS[name]?.initial ?? this.context.initial(name);
        if (own === "format")
            return this.formats(this.get(side))[0];
        const value = TECHNIQUES[this.get(side)].settings[own];
        return typeof value === "function" ? value(this.side(side), this.context.device(), this.context.kernel()) : value;
    }

    isSet(name) {
        return this.#values.has(name);
    }

    // What an address asks for and this device does not have is at its default.
    get(name) {
        const value = this.#values.get(name);
        const isLacking = SIDES.includes(name) && value !== undefined && !this.isThere(value) ||
            name.endsWith(".format") && !this.formats(this.get(name.split(".")[0])).includes(value);
        return isLacking ? this.initial(name) : value ?? this.initial(name);
    }

    // Sets a value, or takes it back to its default where it is undefined.
    set(name, value) {
        if (value === undefined)
            this.#values.delete(name);
        else
            this.#values.set(name, LISTS[name] ? value.map(rounded) : value);
        this.dispatchEvent(new CustomEvent("change", {detail: name}));
    }

    // A change of technique takes the side's other settings back to their defaults: they mean something else there.
    setTechnique(side, technique) {
        for (const name of [...this.#values.keys()].filter((key) => key.startsWith(`${side}.`)))
            this.#values.delete(name);
        this.set(side, technique);
    }

    // All settings of a side by their own names, for a technique's functions.
    side(side) {
        const state = this;
        return new Proxy({}, {get: (_, own) => (own === "technique" ? state.get(side) : state.get(`${side}.${own}`))});
    }

    toAddress() {
        const kept = [...this.#values].filter(([name, value]) => LISTS[name] || value !== this.initial(name));
        const text = kept.map(([name, value]) => `${name}=${LISTS[name] ? value.join(",") : written(value)}`);
        return `#${text.sort().join("&")}`;
    }

    // What is no setting, or no value of one, is left out: an old or mistyped address still shows something.
    fromAddress(address) {
        this.#values.clear();
        for (const pair of address.replace(/^#/, "").split("&").filter(Boolean)) {
            const [name, text = ""] = pair.split("=").map(decodeURIComponent);
            const setting = this.setting(name);
            const value = LISTS[name] ? parsedList(LISTS[name], text) : setting && parsed(setting, text);
            if (value !== undefined)
                this.#values.set(name, value);
        }
        this.dispatchEvent(new CustomEvent("change", {detail: "address"}));
    }
}
