// What the page says of a frame: the sides' names, storage and error, and how long each pass took.
import {element} from "./panel.js";
import {bitsOf} from "./formats.js";
import {sliceCount, TECHNIQUES} from "./techniques.js";

const byId = (id) => document.getElementById(id);

export function describeSide(side, own, figures) {
    const technique = TECHNIQUES[own.technique];
    byId(`${side}-name`).textContent = technique.layered ? `${technique.name}, ${own.layers} layers` : technique.name;
    const said = [];
    // Codes are of 16 bits, in whichever format this device has for them.
    const format = technique.coded ? "unorm16" : own.format;
    if (!technique.exact)
        said.push(`${bitsOf(format, technique.channels, sliceCount(technique, own)) / (own.half ? 4 : 1)} bits`);
    if (!technique.exact && figures)
        said.push(`RMSE ${figures.rmse.toFixed(4)}`);
    byId(`${side}-figures`).textContent = said.join(" · ");
}

export function describeTimes(timer) {
    timer.collect();
    const cells = timer.rows().map(([name, time]) => element("tr", {}, element("td", {textContent: name}),
                                                             element("td", {textContent: `${time.toFixed(2)} ms`})));
    const lack = "This browser has no timer queries (EXT_disjoint_timer_query_webgl2), so the passes cannot be timed.";
    byId("times").replaceChildren(timer.isThere ? element("table", {}, ...cells)
                                                : element("p", {className: "line", textContent: lack}));
}
