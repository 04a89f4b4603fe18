#include "kernel.hpp"

#include <map>

namespace parity
{
namespace
{

std::string constants(const Row& row)
{
    return "#define WORDS " + std::to_string(kWords) + "u\n#define RESULTS " +
           std::to_string(componentCount(row.kind)) + "u\n#define STORED " + std::to_string(kSplits) +
           "\n#define GROUP_SIZE " + std::to_string(kGroupSize) + "\n";
}

// The statement that calls the function and keeps its result; both languages spell it alike.
std::string callStatement(const Row& row)
{
    const std::string call = "lvsm_" + row.function + row.arguments;
    return "KEEP_" + row.kind + "(" + call + ")\n";
}

const char* const kGlslCompute = R"(
layout(local_size_x = GROUP_SIZE) in;
layout(std430, set = 0, binding = 0) readonly buffer Inputs { uint inputs[]; };
layout(std430, set = 0, binding = 1) buffer Outputs { float outputs[]; };
)";

// An input fills WORDS / 4 texels of a row of the texture, and twelve of its results, from FIRST on, one pixel of three
// targets.
const char* const kGlslFragment = R"(
uniform highp usampler2D lvsm_inputs;
layout(location = 0) out vec4 results0;
layout(location = 1) out vec4 results1;
layout(location = 2) out vec4 results2;
uint inputs[WORDS];
float outputs[12 * ((int(RESULTS) + 11) / 12)];

void readInput()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    for (int texel = 0; texel < int(WORDS) / 4; ++texel)
    {
        uvec4 four = texelFetch(lvsm_inputs, ivec2(pixel.x * (int(WORDS) / 4) + texel, pixel.y), 0);
        for (int c = 0; c < 4; ++c)
            inputs[4 * texel + c] = four[c];
    }
}
)";

const char* const kGlslArguments = R"(#define A(i) uintBitsToFloat(inputs[word + uint(i)])
#define I(i) int(inputs[word + uint(i)])
#define V2(i) vec2(A(i), A((i) + 1))
#define V3(i) vec3(A(i), A((i) + 1), A((i) + 2))
#define V4(i) vec4(A(i), A((i) + 1), A((i) + 2), A((i) + 3))
#define IV2(i) ivec2(I(i), I((i) + 1))
#define UV2(i) uvec2(inputs[word + uint(i)], inputs[word + uint(i) + 1u])
#define UV4(i) uvec4(UV2(i), UV2((i) + 2))

#define KEEP_Float(call) outputs[result] = call;
#define KEEP_Int(call) outputs[result] = float(call);
#define KEEP_Vec2(call) vec2 r = call; outputs[result] = r.x; outputs[result + 1u] = r.y;
#define KEEP_IVec2(call) ivec2 r = call; outputs[result] = float(r.x); outputs[result + 1u] = float(r.y);
#define KEEP_Vec4(call) vec4 r = call; for (int c = 0; c < 4; ++c) outputs[result + uint(c)] = r[c];
#define KEEP_UVec2(call) uvec2 r = call; for (int c = 0; c < 2; ++c) keepHalves(result + 2u * uint(c), r[c]);
#define KEEP_UVec4(call) uvec4 r = call; for (int c = 0; c < 4; ++c) keepHalves(result + 2u * uint(c), r[c]);
)";

const char* const kGlslComputeMain = R"(
void main()
{
    uint thread = gl_GlobalInvocationID.x;
)";

const char* const kGlslFragmentMain = R"(
void main()
{
    readInput();
    for (int c = 0; c < outputs.length(); ++c)
        outputs[c] = 0.0;
    uint thread = 0u;
)";

const char* const kGlslFragmentEnd = R"(
    results0 = vec4(outputs[FIRST], outputs[FIRST + 1], outputs[FIRST + 2], outputs[FIRST + 3]);
    results1 = vec4(outputs[FIRST + 4], outputs[FIRST + 5], outputs[FIRST + 6], outputs[FIRST + 7]);
    results2 = vec4(outputs[FIRST + 8], outputs[FIRST + 9], outputs[FIRST + 10], outputs[FIRST + 11]);
}
)";

const char* const kHlslInterface = R"(
[[vk::binding(0, 0)]] StructuredBuffer<uint> inputs : register(t0);
[[vk::binding(1, 0)]] RWStructuredBuffer<float> outputs : register(u1);

#define A(i) asfloat(inputs[word + uint(i)])
#define I(i) int(inputs[word + uint(i)])
#define V2(i) float2(A(i), A((i) + 1))
#define V3(i) float3(A(i), A((i) + 1), A((i) + 2))
#define V4(i) float4(A(i), A((i) + 1), A((i) + 2), A((i) + 3))
#define IV2(i) int2(I(i), I((i) + 1))
#define UV2(i) uint2(inputs[word + uint(i)], inputs[word + uint(i) + 1u])
#define UV4(i) uint4(UV2(i), UV2((i) + 2))

#define KEEP_Float(call) outputs[result] = call;
#define KEEP_Int(call) outputs[result] = float(call);
#define KEEP_Vec2(call) float2 r = call; outputs[result] = r.x; outputs[result + 1u] = r.y;
#define KEEP_IVec2(call) int2 r = call; outputs[result] = float(r.x); outputs[result + 1u] = float(r.y);
#define KEEP_Vec4(call) float4 r = call; for (int c = 0; c < 4; ++c) outputs[result + uint(c)] = r[c];
#define KEEP_UVec2(call) uint2 r = call; for (int c = 0; c < 2; ++c) keepHalves(result + 2u * uint(c), r[c]);
#define KEEP_UVec4(call) uint4 r = call; for (int c = 0; c < 4; ++c) keepHalves(result + 2u * uint(c), r[c]);
)";

const char* const kHlslMain = R"(
[numthreads(GROUP_SIZE, 1, 1)]
void main(uint3 id : SV_DispatchThreadID)
{
    uint thread = id.x;
)";

// Structs from the input's words and back to numbers, in the order of rows.cpp; both languages spell them alike.
const char* const kStructs = R"(
lvsm_MixtureComponent componentAt(uint word)
{
    lvsm_MixtureComponent c;
    c.weight = A(0);
    c.place = V2(1);
    c.depth = A(3);
    c.spread = V3(4);
    c.tilt = V2(7);
    c.variance = A(9);
    return c;
}

lvsm_MixtureComponent tapAt(uint word)
{
    lvsm_MixtureComponent c = lvsm_noComponent();
    c.weight = A(0);
    c.place = V2(1);
    c.depth = A(3);
    return c;
}

lvsm_MixturePlane planeAt(uint word)
{
    lvsm_MixturePlane p;
    p.weight = A(0);
    p.place = V2(1);
    p.depth = A(3);
    p.slope = V2(4);
    p.deviation = A(6);
    return p;
}

lvsm_Mixture twoComponentsAt(uint word)
{
    lvsm_Mixture mixture;
    mixture.components[0] = componentAt(word);
    mixture.components[1] = componentAt(word + 10u);
    mixture.components[2] = lvsm_noComponent();
    mixture.components[3] = lvsm_noComponent();
    return mixture;
}

lvsm_Mixture fourComponentsAt(uint word)
{
    lvsm_Mixture mixture;
    for (int i = 0; i < LVSM_MAX_COMPONENTS; ++i)
    {
        mixture.components[i].weight = A(4 * i);
        mixture.components[i].place = V2(4 * i + 1);
        mixture.components[i].depth = A(4 * i + 3);
        mixture.components[i].spread = V3(16);
        mixture.components[i].tilt = V2(19);
        mixture.components[i].variance = A(21);
    }
    return mixture;
}

void keepHalves(uint at, uint code)
{
    outputs[at] = float(int(code & 0xFFFFu));
    outputs[at + 1u] = float(int(code >> 16u));
}

void keepComponent(uint at, lvsm_MixtureComponent c)
{
    outputs[at] = c.weight;
    outputs[at + 1u] = c.place.x;
    outputs[at + 2u] = c.place.y;
    outputs[at + 3u] = c.depth;
    outputs[at + 4u] = c.spread.x;
    outputs[at + 5u] = c.spread.y;
    outputs[at + 6u] = c.spread.z;
    outputs[at + 7u] = c.tilt.x;
    outputs[at + 8u] = c.tilt.y;
    outputs[at + 9u] = c.variance;
}

void keepPlane(uint at, lvsm_MixturePlane p)
{
    outputs[at] = p.weight;
    outputs[at + 1u] = p.place.x;
    outputs[at + 2u] = p.place.y;
    outputs[at + 3u] = p.depth;
    outputs[at + 4u] = p.slope.x;
    outputs[at + 5u] = p.slope.y;
    outputs[at + 6u] = p.deviation;
}

#define TAP(i) tapAt(word + uint(i))
#define COMPONENT(i) componentAt(word + uint(i))
#define PLANE(i) planeAt(word + uint(i))
#define MIXTURE2(i) twoComponentsAt(word + uint(i))
#define MIXTURE4(i) fourComponentsAt(word + uint(i))
#define KEEP_Component(call) keepComponent(result, call);
#define KEEP_Plane(call) keepPlane(result, call);
#define KEEP_Planes(call) lvsm_MixturePlanes r = call; \
    for (int c = 0; c < LVSM_MAX_COMPONENTS; ++c) \
        keepPlane(result + 7u * uint(c), r.planes[c]);
#define KEEP_Mixture(call) lvsm_Mixture r = call; \
    for (int c = 0; c < LVSM_MAX_COMPONENTS; ++c) \
        keepComponent(result + 10u * uint(c), r.components[c]);
#define KEEP_Inserted(call) lvsm_Mixture mixture = MIXTURE2(0); call; \
    for (int c = 0; c < LVSM_MAX_COMPONENTS; ++c) \
        keepComponent(result + 10u * uint(c), mixture.components[c]);
)";

const char* const kBody = R"(
    uint word = thread * WORDS;
    uint result = thread * RESULTS;
    float splits[LVSM_MAX_LAYERS + 1];
    float weights[LVSM_MAX_LAYERS + 1];
    for (int k = 0; k <= LVSM_MAX_LAYERS; ++k)
    {
        splits[k] = 1.0;
        weights[k] = 0.0;
    }
    for (int stored = 0; stored < STORED; ++stored)
    {
        splits[stored] = A(stored);
        weights[stored] = A(stored + STORED);
    }
)";

const char* const kCommonMacros = R"(
#define N(i) I(i)
#define KEEP_Splits(call) call; for (int c = 0; c < STORED; ++c) outputs[result + uint(c)] = splits[c];
)";

} // namespace

int componentCount(const std::string& kind)
{
    static const std::map<std::string, int> counts = {
        {"Float", 1},    {"Int", 1},       {"Vec2", 2},        {"IVec2", 2}, {"Vec4", 4},
        {"UVec2", 4},    {"UVec4", 8},     {"Component", 10},  {"Plane", 7}, {"Planes", 28},
        {"Mixture", 40}, {"Inserted", 40}, {"Splits", kSplits}};
    return counts.at(kind);
}

std::string glslKernel(const Row& row, const std::string& library)
{
    return "#version 450\n" + library + constants(row) + kCommonMacros + kGlslCompute + kGlslArguments + kStructs +
           kGlslComputeMain + kBody + callStatement(row) + "}\n";
}

std::string glslFragmentKernel(const Row& row)
{
    return constants(row) + kCommonMacros + kGlslFragment + kGlslArguments + kStructs + kGlslFragmentMain + kBody +
           callStatement(row) + kGlslFragmentEnd;
}

std::string hlslKernel(const Row& row, const std::string& library)
{
    return library + constants(row) + kCommonMacros + kHlslInterface + kStructs + kHlslMain + kBody +
           callStatement(row) + "}\n";
}

} // namespace parity
