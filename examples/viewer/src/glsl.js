// Shader text from the tables: with the settings as uniforms for the viewer, or as constants for whoever copies it.
import {ESM_SIGNATURE, SIGNATURE, TECHNIQUES} from "./techniques.js";

// Of codes, which are whole numbers, or of what a sampler filters.
export const samplerOf = (technique) => (TECHNIQUES[technique].planes ? "usampler2DArray" : "sampler2DArray");
const mapOf = (technique) => `LVSM_HIGHP ${samplerOf(technique)}`;
const TYPES = {splits: "float"};

// The first line of a whole pass is the client's: three.js writes its own.
export const withoutVersion = (text) => text.replace(/^#version[^\n]*\n/, "");

// Values of the technique's constants: [type, name, value].
export function constantsOf(technique, side, frame) {
    return TECHNIQUES[technique].constants.map(([type, name, value]) => [type, name, value(side, frame)]);
}

const suffix = (type) => (type === "splits" ? "[LVSM_MAX_LAYERS + 1]" : "");

export function uniformDeclarations(constants) {
    return constants.map(([type, name]) => `uniform ${TYPES[type] ?? type} ${name}${suffix(type)};\n`).join("");
}

export const codeText = (technique) => TECHNIQUES[technique].coded ?? "";

export const storeText = (technique) => TECHNIQUES[technique].store ?? "";

export function judgeText(technique) {
    const {judge, unfiltered} = TECHNIQUES[technique];
    return `${(unfiltered ? ESM_SIGNATURE : SIGNATURE).replaceAll("MAP", mapOf(technique))}\n{${judge}\n}\n`;
}

export function storedText(technique) {
    return `vec2 stored(${mapOf(technique)} map, lvsm_MapPoint at, float depth)\n{\n    ${TECHNIQUES[technique].stored.trim()}\n}\n`;
}

// A number as GLSL and HLSL both read a float.
function floatText(value) {
    const text = String(Number(value.toPrecision(7)));
    return /[.e]/.test(text) ? text.replace(/^(-?\d+)e/, "$1.0e") : `${text}.0`;
}

function valueText(type, value, maxLayers) {
    if (type === "splits")
        return Array.from({length: maxLayers + 1}, (_, i) => floatText(value[i] ?? 1)).join(", ");
    return {float: () => floatText(value), int: () => String(value), bool: () => String(value),
            vec2: () => `vec2(${value.map(floatText).join(", ")})`}[type]();
}

function constantText([type, name, value], maxLayers, isHlsl) {
    const list = valueText(type, value, maxLayers);
    if (type !== "splits")
        return `${isHlsl ? "static " : ""}const ${type} ${name} = ${list};\n`;
    return isHlsl ? `static const float ${name}[LVSM_MAX_LAYERS + 1] = {${list}};\n`
                  : `const float ${name}[LVSM_MAX_LAYERS + 1] = float[](${list});\n`;
}

export const maxLayersFor = (side, technique) => (TECHNIQUES[technique].layered && side.layers > 8 ? 16 : 8);

// The same text in HLSL: types, and maps and samplers apart. planes: of codes, which no sampler reads.
function toHlsl(text, planes) {
    const typed = text.replace(/\bvec([234])\b/g, "float$1");
    if (planes)
        return typed.replace(/LVSM_HIGHP usampler2DArray/g, `Texture2DArray<uint${planes}>`);
    return typed.replace(/LVSM_HIGHP sampler2DArray/g, "Texture2DArray<float4>")
        .replaceAll("lvsm_MapPoint at, float depth, float2", "SamplerState filtering, lvsm_MapPoint at, float depth, float2")
        .replace(/\b(map|unfiltered), at\b/g, "$1, filtering, at").replace(/\b(map, )(unfiltered, filtering)/g, "$1$2");
}

// The technique with its settings as constants, ready to paste behind lvsm_combined. language: "GLSL" or "HLSL".
export function pasteable(technique, side, frame, language, header) {
    const isHlsl = language === "HLSL";
    const maxLayers = maxLayersFor(side, technique);
    const constants = constantsOf(technique, side, frame).map((row) => constantText(row, maxLayers, isHlsl)).join("");
    const {planes, coded} = TECHNIQUES[technique];
    const text = [constants, storeText(technique), codeText(technique) + judgeText(technique)].filter(Boolean).join("\n");
    const file = isHlsl ? "lvsm_separate.hlsli" : "lvsm_combined.glsl";
    const define = maxLayers > 8 ? `, and in front of that #define LVSM_MAX_LAYERS ${maxLayers}` : "";
    const lines = [...header, `Paste ${file} in front of this${define}.`,
                   ...(planes ? [] : ["store: a slice's texel for a depth in [0,1]."]),
                   "visibility: where, such as lvsm_mapPoint(uv, dFdx(uv), dFdy(uv), 0) or lvsm_cubePoint; the receiver's",
                   "depth, and its gradient per texel of the depths from lvsm_receiverGradient."];
    if (coded)
        lines.push("code: what is written of store's texels once they are filtered in floats; the map is read without a filter.");
    const comment = lines.map((line) => `// ${line}\n`).join("");
    return `${comment}${isHlsl ? toHlsl(text, planes) : text}`;
}
