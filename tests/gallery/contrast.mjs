// What is too faint on a page, by the contrast of WCAG 2: 4.5 for texts, 3 for large ones and for marks. To be evaluated
// in the page, so that it holds all that it needs.
export function faintTexts() {
    const rgba = (colour) => {
        const [r, g, b, a = 1] = colour.match(/[\d.]+/g).map(Number);
        return [r, g, b, a];
    };
    const over = ([r, g, b, a], under) => [r, g, b].map((c, i) => a * c + (1 - a) * under[i]);
    const luminance = (colour) => {
        const [r, g, b] = colour.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const contrast = (some, other) => {
        const [dark, light] = [luminance(some), luminance(other)].sort((a, b) => a - b);
        return (light + 0.05) / (dark + 0.05);
    };
    // A picture may be black or white.
    const papersOf = (element) => {
        const layers = [];
        for (let at = element; at; at = at.parentElement) {
            const colour = rgba(getComputedStyle(at).backgroundColor);
            if (colour[3] > 0)
                layers.unshift(colour);
            if (colour[3] === 1)
                return [layers.reduce((under, layer) => over(layer, under), [0, 0, 0])];
            if (at.matches(".tag"))
                return [[0, 0, 0], [255, 255, 255]].map((picture) => layers.reduce((under, layer) => over(layer, under), picture));
        }
        throw new Error(`${element.outerHTML.slice(0, 80)} is on nothing`);
    };
    const [faint, seen] = [new Map(), []];
    const judge = (element, colour, papers, least) => {
        const found = Math.min(...papers.map((paper) => contrast(over(rgba(colour), paper), paper)));
        seen.push(found);
        if (found < least)
            faint.set(`${element.tagName} ${element.getAttribute("class")}`, `${element.textContent.slice(0, 40)}: ${found.toFixed(2)}`);
    };
    const walker = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
        const element = walker.currentNode.parentElement;
        const style = getComputedStyle(element);
        if (!walker.currentNode.data.trim() || element.getClientRects().length === 0 || style.visibility !== "visible" || element.matches("script, option, style"))
            continue;
        const isLarge = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.6 && style.fontWeight >= 700);
        const inChart = element.closest("svg");
        const papers = element.matches(".letter") ?
            [rgba(getComputedStyle(element.parentElement.querySelector("circle:not(.reach)")).fill).slice(0, 3)] : papersOf(element);
        judge(element, inChart ? style.fill : style.color, papers, isLarge ? 3 : 4.5);
    }
    for (const mark of document.querySelectorAll(".point circle:not(.reach), .splits line, .bars, select")) {
        const style = getComputedStyle(mark);
        if (mark.getClientRects().length > 0)
            judge(mark, mark.matches("circle") ? style.fill : mark.matches("select") ? style.borderColor : style.stroke,
                  papersOf(mark.parentElement), 3);
    }
    return {faint: [...faint], least: Math.min(...seen), count: seen.length};
}
