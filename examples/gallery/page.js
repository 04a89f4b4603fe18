// The divider, the two selects and the charts of each article; without this the first pair is shown side by side.
"use strict";

const TITLES = {shaded: "picture", errors: "error map", layers: "layers"};
const STEP_KEYS = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1};

function legendOf(splits) {
    return splits.flatMap(([colour, metres]) => {
        const [key, swatch] = [document.createElement("span"), document.createElement("i")];
        key.className = "key";
        swatch.style.background = colour;
        key.append(swatch, `${metres}\u2009m`);
        return [key, " "];
    });
}

// Puts a technique on a side, "a" or "b"; what has no such view shows its picture.
function show(article, known, side) {
    const {value, selectedOptions: [{textContent: title}]} = article.querySelector(`select[name=${side}]`);
    const wanted = article.querySelector("fieldset input:checked").value;
    const view = known[value][wanted] ? wanted : "shaded";
    const image = article.querySelector(`img.${side}`);
    image.src = known[value][view];
    image.alt = `${title}, ${TITLES[view]}`;
    article.querySelector(`.tag.${side}`).textContent = view === wanted ? title : `${title}, ${TITLES[view]}`;
    const about = article.querySelector(`.about.${side}`);
    const [name, words, layers] = about.children;
    name.textContent = `${title}.`;
    words.textContent = known[value].about;
    layers.replaceChildren(...(view === "layers" ? legendOf(known[value].splits) : []));
    for (const part of article.querySelectorAll("[data-technique]"))
        part.classList.toggle(side, part.dataset.technique === value);
    raise(article);
}

// What is chosen lies over what is not.
function raise(article) {
    for (const point of article.querySelectorAll(".point:is(.a, .b)"))
        point.parentNode.append(point);
}

// One way for mouse, pen and finger; keys are the range's own.
function makeDivider(stage) {
    const range = stage.querySelector("input");
    const move = () => stage.style.setProperty("--at", `${range.value}%`);
    const follow = (event) => {
        const {left, width} = stage.getBoundingClientRect();
        range.value = 100 * (event.clientX - left) / width;
        move();
    };
    range.addEventListener("input", move);
    stage.addEventListener("pointerdown", (event) => {
        if (event.button !== 0)
            return;
        event.preventDefault();
        range.focus({preventScroll: true});
        stage.setPointerCapture(event.pointerId);
        follow(event);
    });
    stage.addEventListener("pointermove", (event) => {
        if (stage.hasPointerCapture(event.pointerId))
            follow(event);
    });
    move();
}

// One stop of the Tab key for a chart, the arrow keys within.
function makeChart(chart) {
    const points = [...chart.querySelectorAll(".point")];
    chart.addEventListener("keydown", (event) => {
        const step = STEP_KEYS[event.key];
        if (!step || points.length === 0)
            return;
        event.preventDefault();
        const at = points.indexOf(document.activeElement);
        points[(at < 0 ? (step > 0 ? 0 : -1) : at + step + points.length) % points.length]?.focus();
    });
}

for (const article of document.querySelectorAll("article")) {
    const known = JSON.parse(article.querySelector("script").textContent);
    for (const side of ["a", "b"])
        article.querySelector(`select[name=${side}]`).addEventListener("change", () => show(article, known, side));
    article.querySelector("fieldset").addEventListener("change", () => ["a", "b"].forEach((side) => show(article, known, side)));
    makeDivider(article.querySelector(".stage"));
    article.querySelectorAll(".chart svg").forEach(makeChart);
    raise(article);
}
