#include "kernel.hpp"

namespace parity
{
namespace
{

std::string constants()
{
    return "#define WORDS " + std::to_string(kWords) + "u\n#define RESULTS " + std::to_string(kResults) +
           "u\n#define STORED " + std::to_string(kMaxLayers + 1) + "\n#define GROUP_SIZE " +
           std::to_string(kGroupSize) + "\n";
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
layout(std430, set = 0, binding = 1) writeonly buffer Outputs { float outputs[]; };
)";

// An input fills WORDS / 4 texels of a row of the texture, and its results one pixel of three targets.
const char* const kGlslFragment = R"(
uniform highp usampler2D lvsm_inputs;
layout(location = 0) out vec4 results0;
layout(location = 1) out vec4 results1;
layout(location = 2) out vec4 results2;
uint inputs[WORDS];
float outputs[12];
)";

const char* const kGlslArguments = R"(#define A(i) uintBitsToFloat(inputs[word + uint(i)])
#define I(i) int(inputs[word + uint(i)])
#define V2(i) vec2(A(i), A((i) + 1))
#define V3(i) vec3(A(i), A((i) + 1), A((i) + 2))
#define V4(i) vec4(A(i), A((i) + 1), A((i) + 2), A((i) + 3))
#define IV2(i) ivec2(I(i), I((i) + 1))

#define KEEP_Float(call) outputs[result] = call;
#define KEEP_Int(call) outputs[result] = float(call);
#define KEEP_Vec2(call) vec2 r = call; outputs[result] = r.x; outputs[result + 1u] = r.y;
#define KEEP_IVec2(call) ivec2 r = call; outputs[result] = float(r.x); outputs[result + 1u] = float(r.y);
#define KEEP_Vec4(call) vec4 r = call; for (int c = 0; c < 4; ++c) outputs[result + uint(c)] = r[c];
)";

const char* const kGlslComputeMain = R"(
void main()
{
    uint thread = gl_GlobalInvocationID.x;
)";

const char* const kGlslFragmentMain = R"(
void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    for (int texel = 0; texel < int(WORDS) / 4; ++texel)
    {
        uvec4 four = texelFetch(lvsm_inputs, ivec2(pixel.x * (int(WORDS) / 4) + texel, pixel.y), 0);
        for (int c = 0; c < 4; ++c)
            inputs[4 * texel + c] = four[c];
    }
    for (int c = 0; c < 12; ++c)
        outputs[c] = 0.0;
    uint thread = 0u;
)";

const char* const kGlslFragmentEnd = R"(
    results0 = vec4(outputs[0], outputs[1], outputs[2], outputs[3]);
    results1 = vec4(outputs[4], outputs[5], outputs[6], outputs[7]);
    results2 = vec4(outputs[8], 0.0, 0.0, 0.0);
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

#define KEEP_Float(call) outputs[result] = call;
#define KEEP_Int(call) outputs[result] = float(call);
#define KEEP_Vec2(call) float2 r = call; outputs[result] = r.x; outputs[result + 1u] = r.y;
#define KEEP_IVec2(call) int2 r = call; outputs[result] = float(r.x); outputs[result + 1u] = float(r.y);
#define KEEP_Vec4(call) float4 r = call; for (int c = 0; c < 4; ++c) outputs[result + uint(c)] = r[c];

[numthreads(GROUP_SIZE, 1, 1)]
void main(uint3 id : SV_DispatchThreadID)
{
    uint thread = id.x;
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

std::string glslKernel(const Row& row, const std::string& library)
{
    return "#version 450\n" + library + constants() + kCommonMacros + kGlslCompute + kGlslArguments + kGlslComputeMain +
           kBody + callStatement(row) + "}\n";
}

std::string glslFragmentKernel(const Row& row)
{
    return constants() + kCommonMacros + kGlslFragment + kGlslArguments + kGlslFragmentMain + kBody +
           callStatement(row) + kGlslFragmentEnd;
}

std::string hlslKernel(const Row& row, const std::string& library)
{
    return library + constants() + kCommonMacros + kHlslInterface + kBody + callStatement(row) + "}\n";
}

} // namespace parity
