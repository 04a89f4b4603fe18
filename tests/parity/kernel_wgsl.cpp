#include "kernel.hpp"

namespace parity
{
namespace
{

// What functions.def calls its arguments are functions here, which read from the input's first word on.
const char* const kInterface = R"(
@group(0) @binding(0) var<storage, read> inputs: array<u32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;
var<private> word: u32;
var<private> result: u32;

fn A(i: u32) -> f32 { return bitcast<f32>(inputs[word + i]); }
fn I(i: u32) -> i32 { return i32(inputs[word + i]); }
fn N(i: u32) -> i32 { return I(i); }
fn V2(i: u32) -> vec2f { return vec2f(A(i), A(i + 1)); }
fn V3(i: u32) -> vec3f { return vec3f(A(i), A(i + 1), A(i + 2)); }
fn V4(i: u32) -> vec4f { return vec4f(A(i), A(i + 1), A(i + 2), A(i + 3)); }
fn IV2(i: u32) -> vec2i { return vec2i(I(i), I(i + 1)); }
fn UV2(i: u32) -> vec2u { return vec2u(inputs[word + i], inputs[word + i + 1]); }
fn UV4(i: u32) -> vec4u { return vec4u(UV2(i), UV2(i + 2)); }

fn COMPONENT(i: u32) -> lvsm_MixtureComponent
{
    return lvsm_MixtureComponent(A(i), V2(i + 1), A(i + 3), V3(i + 4), V2(i + 7), A(i + 9));
}

fn TAP(i: u32) -> lvsm_MixtureComponent
{
    var tap = lvsm_noComponent();
    tap.weight = A(i);
    tap.place = V2(i + 1);
    tap.depth = A(i + 3);
    return tap;
}

fn PLANE(i: u32) -> lvsm_MixturePlane
{
    return lvsm_MixturePlane(A(i), V2(i + 1), A(i + 3), V2(i + 4), A(i + 6));
}

fn MIXTURE2(i: u32) -> lvsm_Mixture
{
    var mixture: lvsm_Mixture;
    mixture.components[0] = COMPONENT(i);
    mixture.components[1] = COMPONENT(i + 10);
    mixture.components[2] = lvsm_noComponent();
    mixture.components[3] = lvsm_noComponent();
    return mixture;
}

fn MIXTURE4(i: u32) -> lvsm_Mixture
{
    var mixture: lvsm_Mixture;
    for (var c = 0u; c < 4u; c++)
    {
        let at = i + 4 * c;
        mixture.components[c] = lvsm_MixtureComponent(A(at), V2(at + 1), A(at + 3), V3(i + 16), V2(i + 19), A(i + 21));
    }
    return mixture;
}

fn put(value: f32)
{
    outputs[result] = value;
    result++;
}

fn keepFloat(r: f32) { put(r); }
fn keepVec2(r: vec2f) { put(r.x); put(r.y); }
fn keepVec3(r: vec3f) { put(r.x); put(r.y); put(r.z); }
fn keepVec4(r: vec4f) { keepVec2(r.xy); keepVec2(r.zw); }
fn keepIVec2(r: vec2i) { keepVec2(vec2f(r)); }
fn keepHalves(r: u32) { put(f32(r & 0xFFFFu)); put(f32(r >> 16)); }
fn keepUVec2(r: vec2u) { keepHalves(r.x); keepHalves(r.y); }
fn keepUVec4(r: vec4u) { keepUVec2(r.xy); keepUVec2(r.zw); }

fn keepComponent(c: lvsm_MixtureComponent)
{
    put(c.weight);
    keepVec2(c.place);
    put(c.depth);
    keepVec3(c.spread);
    keepVec2(c.tilt);
    put(c.variance);
}

fn keepPlane(p: lvsm_MixturePlane)
{
    put(p.weight);
    keepVec2(p.place);
    put(p.depth);
    keepVec2(p.slope);
    put(p.deviation);
}

fn keepMixture(r: lvsm_Mixture)
{
    for (var i = 0; i < LVSM_MAX_COMPONENTS; i++) { keepComponent(r.components[i]); }
}

fn keepPlanes(r: lvsm_MixturePlanes)
{
    for (var i = 0; i < LVSM_MAX_COMPONENTS; i++) { keepPlane(r.planes[i]); }
}

fn keepSplits(r: array<f32, LVSM_MAX_LAYERS + 1>)
{
    for (var i = 0; i < STORED; i++) { put(r[i]); }
}
)";

const char* const kBody = R"(
    word = id.x * WORDS;
    result = id.x * RESULTS;
    var splits: array<f32, LVSM_MAX_LAYERS + 1>;
    var weights: array<f32, LVSM_MAX_LAYERS + 1>;
    for (var k = 0; k <= LVSM_MAX_LAYERS; k++)
    {
        splits[k] = 1.0;
        weights[k] = 0.0;
    }
    for (var stored = 0; stored < STORED; stored++)
    {
        splits[stored] = A(u32(stored));
        weights[stored] = A(u32(stored + STORED));
    }
)";

// The statements that call the function and keep its result. What it changes in place, its first argument, it takes by
// pointer.
std::string callStatement(const Row& row)
{
    const bool changes = row.kind == "Splits" || row.kind == "Inserted";
    const std::string arguments = changes ? "(&" + row.arguments.substr(1) : row.arguments;
    const std::string call = "lvsm_" + row.function + arguments;
    if (row.kind == "Splits")
        return "    " + call + ";\n    keepSplits(splits);\n";
    if (row.kind == "Inserted")
        return "    var mixture = MIXTURE2(0);\n    " + call + ";\n    keepMixture(mixture);\n";
    return row.kind == "Int" ? "    put(f32(" + call + "));\n" : "    keep" + row.kind + "(" + call + ");\n";
}

} // namespace

std::string wgslKernel(const Row& row, const std::string& library)
{
    const std::string constants = "\nconst WORDS = " + std::to_string(kWords) +
                                  "u;\nconst RESULTS = " + std::to_string(componentCount(row.kind)) +
                                  "u;\nconst STORED = " + std::to_string(kSplits) + ";\n";
    return library + constants + kInterface + "\n@compute @workgroup_size(" + std::to_string(kGroupSize) +
           ")\nfn main(@builtin(global_invocation_id) id: vec3u)\n{" + kBody + callStatement(row) + "}\n";
}

} // namespace parity
