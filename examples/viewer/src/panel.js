// Controls made from the tables. Each has a label, a value, and a line that says what it does.
import {SETTINGS, SIDE_SETTINGS} from "./settings.js";
import {TECHNIQUES} from "./techniques.js";

const STEPS = 200;

export function element(tag, properties = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(properties))
        name.includes("-") || name === "for" || name === "role" ? made.setAttribute(name, value) : made[name] = value;
    made.append(...children);
    return made;
}

function shown(value) {
    const isSmall = value !== 0 && Math.abs(value) < 0.001;
    return isSmall ? value.toExponential(1) : String(Number(value.toPrecision(4)));
}

// The place of a value on a scale by factors: 0 is at the left end, the least value one step to its right.
function toStep({min, max}, value) {
    return value <= 0 ? 0 : 1 + Math.round((STEPS - 1) * Math.log(value / min) / Math.log(max / min));
}

function fromStep({min, max}, step) {
    return step === 0 ? 0 : Number((min * (max / min) ** ((step - 1) / (STEPS - 1))).toPrecision(3));
}

const optionOf = ([value, name]) => element("option", {value, textContent: name});

// What shows and changes one kind of setting: its input, the value in it, and the value out of it.
const KINDS = {
    choice: {
        make: ({options}) => element("select", {}, ...options.map(optionOf)),
        write: (input, _, value) => input.value = value,
        read: (input, {options}) => options.find(([value]) => String(value) === input.value)[0],
    },
    toggle: {
        make: () => element("input", {type: "checkbox"}),
        write: (input, _, value) => input.checked = value,
        read: (input) => input.checked,
    },
    range: {
        make: ({min, max, step}) => element("input", {type: "range", min, max, step}),
        write: (input, _, value) => input.value = value,
        read: (input) => Number(input.value),
    },
    scale: {
        make: () => element("input", {type: "range", min: 0, max: STEPS, step: 1}),
        write: (input, setting, value) => input.value = toStep(setting, value),
        read: (input, setting) => fromStep(setting, Number(input.value)),
    },
};

export class Control {
    constructor(state, name, setting) {
        Object.assign(this, {state, name, setting});
        const {kind, label, line} = setting;
        const id = name.replace(".", "-");
        this.input = KINDS[kind].make(setting);
        Object.assign(this.input, {id, name});
        this.input.setAttribute("aria-describedby", `${id}-line`);
        this.output = element("output", {htmlFor: id});
        this.reset = element("button", {type: "button", className: "reset", textContent: "↺", title: "Back to the default",
                                        "aria-label": `${label}: back to the default`});
        this.root = element("div", {className: `control ${kind}`},
                            element("label", {for: id, textContent: label}), this.output, this.reset, this.input,
                            element("p", {id: `${id}-line`, className: "line", textContent: line}));
        this.input.addEventListener("input", () => this.change(KINDS[kind].read(this.input, setting)));
        this.reset.addEventListener("click", () => {
            this.change(undefined);
            this.input.focus();
        });
    }

    change(value) {
        if (SETTINGS[this.name] && TECHNIQUES[value])
            this.state.setTechnique(this.name, value);
        else
            this.state.set(this.name, value);
    }

    update() {
        const {kind} = this.setting;
        const value = this.state.get(this.name);
        KINDS[kind].write(this.input, this.setting, value);
        this.output.textContent = kind === "range" || kind === "scale" ? shown(value) : "";
        this.reset.hidden = !this.state.isSet(this.name) || value === this.state.initial(this.name);
    }

    // Options that this device or technique does not have cannot be chosen.
    limit(isThere) {
        for (const option of this.input.options)
            option.disabled = !isThere(option.value);
    }
}

// The controls of one side: its technique's list, and what that technique takes.
export class SidePanel {
    constructor(root, state, side, extras) {
        Object.assign(this, {state, side, extras});
        this.technique = new Control(state, side, SETTINGS[side]);
        this.about = element("p", {className: "line about"});
        this.own = element("div");
        root.append(this.technique.root, this.about, this.own);
        this.technique.root.querySelector(".line").remove();
        this.about.id = `${side}-line`;
        this.technique.limit((technique) => state.isThere(technique));
    }

    update() {
        const technique = this.state.get(this.side);
        if (technique !== this.shown) {
            this.shown = technique;
            const {line, source, settings, formats} = TECHNIQUES[technique];
            this.about.textContent = source ? `${line} (${source})` : line;
            const names = [...(formats.length > 1 ? ["format"] : []), ...Object.keys(settings)];
            this.controls = names.map((name) => new Control(this.state, `${this.side}.${name}`, SIDE_SETTINGS[name]));
            this.own.replaceChildren(...this.controls.map(({root}) => root));
            const there = this.state.formats(technique);
            this.controls.find(({name}) => name.endsWith(".format"))?.limit((format) => there.includes(format));
            const placement = this.controls.find(({name}) => name.endsWith(".placement"));
            if (placement)
                placement.root.after(this.extras.root);
        }
        for (const control of [this.technique, ...this.controls])
            control.update();
    }
}
