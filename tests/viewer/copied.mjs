// What the copy buttons give compiles, in WebGL2 and by glslang: copied.mjs PAGE SINGLE GLSLANG
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {runCases} from "./page.mjs";

const [path, single, glslang] = process.argv.slice(2);
const HEAD = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
const COMBINED = readFileSync(join(single, "lvsm_combined.glsl"), "utf8");
const SEPARATE = readFileSync(join(single, "lvsm_separate.hlsli"), "utf8");

// A shader around the text: it stores a depth, and reads the map.
const glslShader = (text, takesUnfiltered, define, planes) => `${HEAD}${define}${COMBINED}\n${text}
uniform highp ${planes ? "usampler2DArray" : "sampler2DArray"} map;
uniform highp sampler2DArray unfiltered;
in vec2 uv;
out vec4 result;
void main()
{
    lvsm_MapPoint at = lvsm_mapPoint(uv, dFdx(uv), dFdy(uv), 0);
    float lit = visibility(map, ${takesUnfiltered ? "unfiltered, " : ""}at, 0.5, vec2(0.0, 0.001));
    result = ${planes ? "vec4(0.0)" : "store(uv.x, 0)"} + lit;
}
`;
const hlslShader = (text, takesUnfiltered, define, planes) => `${define}${SEPARATE}\n${text}
Texture2DArray<${planes ? `uint${planes}` : "float4"}> map : register(t0);
Texture2DArray<float4> unfiltered : register(t1);
SamplerState filtering : register(s0);
float4 main(float2 uv : TEXCOORD0) : SV_Target
{
    lvsm_MapPoint at = lvsm_mapPoint(uv, ddx(uv), ddy(uv), 0);
    float lit = visibility(map, ${takesUnfiltered ? "unfiltered, " : ""}${planes ? "" : "filtering, "}at, 0.5, float2(0.0, 0.001));
    return ${planes ? "float4(0.0, 0.0, 0.0, 0.0)" : "store(uv.x, 0)"} + lit;
}
`;

// Whatever the compiler says, or nothing.
function webglSays(text) {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    const shader = gl.createShader(gl.FRAGMENT_SHADER);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? "" : gl.getShaderInfoLog(shader) || "failed";
}

function glslangSays(folder, text) {
    const file = join(folder, "copied.hlsl");
    writeFileSync(file, text);
    const done = spawnSync(glslang, ["-D", "-V", "-S", "frag", "-e", "main", "-o", "/dev/null", file], {encoding: "utf8"});
    assert.equal(done.error, undefined, `${glslang}: ${done.error}`);
    return done.status === 0 ? "" : done.stdout;
}

async function copied(viewer, language) {
    await viewer.tab.locator(`#copy-left-${language}`).click();
    const text = await viewer.tab.locator("#code-text").inputValue();
    await viewer.tab.waitForFunction(() => /Copied|Selected/.test(document.getElementById("code-status").textContent));
    await viewer.tab.keyboard.press("Escape");
    return text;
}

const cases = {"opens": (viewer) => viewer.open("#size=256&taps=5&right=vsm")};
const folder = mkdtempSync(join(tmpdir(), "lvsm-copied-"));

// Beside the defaults, what changes the text: formats, and layers beyond the eight of the library's setting.
const TRIALS = ["basic", "pcf", "vsm&left.reduction=0.2&left.minVariance=0", "lvsm", "bracketed", "bracketed&left.format=unorm8",
                "plane&left.layers=16", "evsm2", "evsm4", "esm", "msm4", "quantised", "trigonometric", "csm&left.order=16",
                "layers4", "mixture2&left.half=on", "mixture4"];
cases["every technique, in both languages, with its constants"] = async (viewer) => {
    const names = await viewer.tab.locator("#left option").evaluateAll((options) => options.map(({value}) => value));
    assert.deepEqual(new Set(TRIALS.map((trial) => trial.split("&")[0])), new Set(names.filter((name) => name !== "exact")));
    for (const trial of TRIALS) {
        const planes = Number(/^mixture(\d)/.exec(trial)?.[1] ?? 0);
        // Maps of mixtures would take seconds to draw, and the text is the same without: the last trials have none.
        if (planes)
            await viewer.tab.evaluate(() => window.lvsmViewer.loop.isLost = true);
        const address = `#size=256&taps=5&right=vsm&left=${trial}`;
        await (planes ? viewer.choose(address) : viewer.go(address));
        const define = trial.includes("layers=16") ? "#define LVSM_MAX_LAYERS 16\n" : "";
        const takesUnfiltered = trial === "esm";
        const [glsl, hlsl] = [await copied(viewer, "glsl"), await copied(viewer, "hlsl")];
        assert.equal(await viewer.tab.evaluate(webglSays, glslShader(glsl, takesUnfiltered, define, planes)), "", `${trial}: ${glsl}`);
        assert.equal(glslangSays(folder, hlslShader(hlsl, takesUnfiltered, define, planes)), "", `${trial}: ${hlsl}`);
        if (trial.includes("reduction"))
            assert.match(glsl, /const float amount = 0\.2;/);
    }
};

const failed = await runCases(path, {viewport: {width: 1280, height: 800}, deviceScaleFactor: 0.5}, cases);
rmSync(folder, {recursive: true});
process.exit(failed ? 1 : 0);
