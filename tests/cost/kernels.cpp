#include "kernels.hpp"

#include "../parity/kernel.hpp"

#include <lvsm/config.hpp>

#include <cfloat>
#include <fstream>
#include <iterator>
#include <map>

namespace cost
{
namespace
{

const char* const kLibrary = "#include \"lvsm/lvsm.glsl\"\n";

// Sums of everything that an argument holds.
const char* const kTotals = R"(
float total(float x) { return x; }
float total(int x) { return float(x); }
float total(vec2 x) { return x.x + x.y; }
float total(vec3 x) { return x.x + x.y + x.z; }
float total(vec4 x) { return x.x + x.y + x.z + x.w; }
float total(ivec2 x) { return float(x.x + x.y); }
float total(uvec2 x) { return float(int(x.x + x.y)); }
float total(uvec4 x) { return total(x.xy) + total(x.zw); }
float total(lvsm_MixtureComponent c)
{
    return c.weight + total(c.place) + c.depth + total(c.spread) + total(c.tilt) + c.variance;
}
float total(lvsm_MixturePlane p)
{
    return p.weight + total(p.place) + p.depth + total(p.slope) + p.deviation;
}
float total(lvsm_Mixture m)
{
    return total(m.components[0]) + total(m.components[1]) + total(m.components[2]) + total(m.components[3]);
}
lvsm_MixtureComponent componentOf(float x)
{
    return lvsm_MixtureComponent(x, vec2(x), x, vec3(x), vec2(x), x);
}
lvsm_MixturePlane planeOf(float x)
{
    return lvsm_MixturePlane(x, vec2(x), x, vec2(x), x);
}
lvsm_MixturePlanes planesOf(float x)
{
    return lvsm_MixturePlanes(lvsm_MixturePlane[4](planeOf(x), planeOf(x), planeOf(x), planeOf(x)));
}
lvsm_Mixture mixtureOf(float x)
{
    return lvsm_Mixture(lvsm_MixtureComponent[4](componentOf(x), componentOf(x), componentOf(x), componentOf(x)));
}
float total(float x[LVSM_MAX_LAYERS + 1])
{
    float sum = 0.0;
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        sum += x[i];
    return sum;
}
)";

std::vector<std::string> splitArguments(const std::string& list)
{
    std::vector<std::string> arguments(1);
    int depth = 0;
    for (char c : list.substr(1, list.size() - 2))
    {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth == 0)
            arguments.emplace_back();
        else if (c != ' ')
            arguments.back() += c;
    }
    return arguments;
}

// The GLSL type of an argument as functions.def writes it; a number stands for itself.
std::string typeOf(const std::string& argument)
{
    static const std::map<std::string, std::string> types = {{"A", "float"},
                                                             {"I", "int"},
                                                             {"N", "int"},
                                                             {"V2", "vec2"},
                                                             {"V3", "vec3"},
                                                             {"V4", "vec4"},
                                                             {"IV2", "ivec2"},
                                                             {"UV2", "uvec2"},
                                                             {"UV4", "uvec4"},
                                                             {"TAP", "lvsm_MixtureComponent"},
                                                             {"COMPONENT", "lvsm_MixtureComponent"},
                                                             {"PLANE", "lvsm_MixturePlane"},
                                                             {"MIXTURE2", "lvsm_Mixture"},
                                                             {"MIXTURE4", "lvsm_Mixture"},
                                                             {"mixture", "inout lvsm_Mixture"}};
    const auto found = types.find(argument.substr(0, argument.find('(')));
    return found == types.end() ? "int" : found->second;
}

// The GLSL type of a result, and what makes one of a number.
struct ResultType
{
    std::string name;
    std::string make;
};

ResultType resultType(const std::string& kind)
{
    static const std::map<std::string, ResultType> types = {{"Float", {"float", "float"}},
                                                            {"Int", {"int", "int"}},
                                                            {"Vec2", {"vec2", "vec2"}},
                                                            {"Vec4", {"vec4", "vec4"}},
                                                            {"IVec2", {"ivec2", "ivec2"}},
                                                            {"UVec2", {"uvec2", "uvec2"}},
                                                            {"UVec4", {"uvec4", "uvec4"}},
                                                            {"Component", {"lvsm_MixtureComponent", "componentOf"}},
                                                            {"Plane", {"lvsm_MixturePlane", "planeOf"}},
                                                            {"Planes", {"lvsm_MixturePlanes", "planesOf"}},
                                                            {"Mixture", {"lvsm_Mixture", "mixtureOf"}}};
    return types.at(kind);
}

// A function that takes a row's arguments, needs all of them, and returns what the row's function returns.
std::string loadFunction(const parity::Row& row)
{
    std::string parameters;
    std::string sum = "0.0";
    int count = 0;
    for (const std::string& argument : splitArguments(row.arguments))
    {
        const std::string name = "a" + std::to_string(count++);
        const bool array = argument == "splits" || argument == "weights";
        parameters += count > 1 ? ", " : "";
        if (array)
            parameters += (row.kind == "Splits" && argument == "splits" ? "inout float " : "float ") + name +
                          "[LVSM_MAX_LAYERS + 1]";
        else
            parameters += typeOf(argument) + ' ' + name;
        sum += " + total(" + name + ")";
    }
    if (row.kind == "Splits")
        return "void lvsm_loads(" + parameters + ")\n{\n    float sum = " + sum +
               ";\n    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)\n        a0[i] += sum;\n}\n";
    if (row.kind == "Inserted")
        return "void lvsm_loads(" + parameters + ")\n{\n    a0 = mixtureOf(" + sum + ");\n}\n";
    const ResultType type = resultType(row.kind);
    return type.name + " lvsm_loads(" + parameters + ")\n{\n    return " + type.make + '(' + sum + ");\n}\n";
}

struct Estimate
{
    const char* name;
    int texels;
    const char* expression;
};

// Estimates relative to the receiver's plane read the neighbours' first moments of three layers: front, own, behind.
const char* const kPlaneEstimates = R"(
vec3 planeCovariances(vec3 right, vec3 left, vec3 up, vec3 down, vec2 gradient)
{
    return vec3(lvsm_planeCovariance(vec4(right.x, left.x, up.x, down.x), gradient, deviation),
                lvsm_planeCovariance(vec4(right.y, left.y, up.y, down.y), gradient, deviation),
                lvsm_planeCovariance(vec4(right.z, left.z, up.z, down.z), gradient, deviation));
}
float planeVisibility(vec4 frontAndOwn, vec2 behind, vec3 covariances, float depth, vec2 gradient, vec2 interval)
{
    return lvsm_planeBracketedVisibility(lvsm_expandMoments(frontAndOwn.xy), lvsm_expandMoments(frontAndOwn.zw),
                                         lvsm_expandMoments(behind), covariances, depth, interval,
                                         lvsm_planeVariance(gradient, deviation), minVariance, contact);
}
// Of two layers, which one texel holds: the receiver's, and what there is on both sides of it.
vec4 frontAndOwn(vec4 texel, bool isBehind) { return isBehind ? texel : vec4(1.0, 0.0, texel.xy); }
vec2 behindOwn(vec4 texel, bool isBehind) { return isBehind ? vec2(0.0) : texel.zw; }
vec3 threeMeans(vec4 texel, bool isBehind) { return isBehind ? vec3(texel.xz, 0.0) : vec3(1.0, texel.xz); }
vec2 intervalOfTwo(float split, bool isBehind) { return isBehind ? vec2(split, 1.0) : vec2(0.0, split); }
// Four samples half a texel away from the receiver.
float tapDepth(float depth, vec2 gradient, int tap)
{
    return lvsm_planeDepth(depth, gradient, vec2((tap & 1) == 0 ? -0.5 : 0.5, (tap & 2) == 0 ? -0.5 : 0.5));
}
float mean4(float a, float b, float c, float d) { return 0.25 * (a + b + c + d); }
// Binomial weights of 7 and of 15, with a 0 at each end.
const float kernel7[17] = float[](0.0, 0.015625, 0.09375, 0.234375, 0.3125, 0.234375, 0.09375, 0.015625, 0.0,
                                  0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
const float kernel15[17] = float[](0.0, 6.1035e-5, 8.5449e-4, 5.5542e-3, 2.2217e-2, 6.1096e-2, 0.12219, 0.18329,
                                   0.20947, 0.18329, 0.12219, 6.1096e-2, 2.2217e-2, 5.5542e-3, 8.5449e-4, 6.1035e-5,
                                   0.0);
float pcfWindow(const int gathers, const float weights[17], float depth, vec2 gradient)
{
    vec2 f = fract(vec2(depth) * vec2(1024.0, 777.0));
    float across[16];
    [[unroll]] for (int i = 0; i < 2 * gathers; ++i)
        across[i] = mix(weights[i + 1], weights[i], f.x);
    float sum = 0.0;
    float corner = depth - bias + dot(gradient, vec2(1 - gathers) - f);
    [[unroll]] for (int y = 0; y < gathers; ++y)
    {
        vec2 rows = vec2(0.0);
        [[unroll]] for (int x = 0; x < gathers; ++x)
        {
            vec4 depths = texel(y * gathers + x);
            float own = corner + gradient.x * float(2 * x) + gradient.y * float(2 * y);
            rows.x += (depths.x >= own ? across[2 * x] : 0.0) + (depths.y >= own + gradient.x ? across[2 * x + 1] : 0.0);
            own += gradient.y;
            rows.y += (depths.z >= own ? across[2 * x] : 0.0) + (depths.w >= own + gradient.x ? across[2 * x + 1] : 0.0);
        }
        sum += rows.x * mix(weights[2 * y + 1], weights[2 * y], f.y) +
               rows.y * mix(weights[2 * y + 2], weights[2 * y + 1], f.y);
    }
    return sum;
}
)";

std::string estimateKernel(int texels, const std::string& statements)
{
    return R"(#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
)" + std::string(kLibrary) +
           kTotals + "#define TEXELS " + std::to_string(texels) + R"(u
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Inputs { vec4 inputs[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Outputs { float outputs[]; };
layout(push_constant) uniform Settings
{
    vec2 placedInterval;
    float placedSplit;
};
const float minVariance = 1.0e-5;
const float bleeding = 0.1;
const vec2 exponents = vec2(42.0, 10.0);
const vec2 interval = vec2(0.25, 0.6);
const float split = 0.4;
const int order = 4;
const float bias = 0.001;
const float deviation = 1.2247449;
const float contact = 0.15;
#define texel(i) inputs[(TEXELS + 1u) * gl_GlobalInvocationID.x + 1u + uint(i)]
)" + kPlaneEstimates +
           R"(
void main()
{
    float depth = inputs[(TEXELS + 1u) * gl_GlobalInvocationID.x].x;
    vec2 gradient = inputs[(TEXELS + 1u) * gl_GlobalInvocationID.x].yz;
    // Packed, so that a receiver's place takes no second load: what is not read costs nothing.
    uint place = floatBitsToUint(inputs[(TEXELS + 1u) * gl_GlobalInvocationID.x].w);
    vec2 offset = vec2(float(place & 0xFFFFu), float(place >> 16u));
)" + statements +
           "}\n";
}

} // namespace

std::vector<Kernel> functionKernels()
{
    const parity::Row rows[] = {
#define FUNCTION(name, kind, arguments, domain, low, high) \
    {#name, #kind, #arguments, #domain, low, high, nullptr, nullptr, nullptr},
#include "../parity/functions.def"
#undef FUNCTION
    };
    std::vector<Kernel> kernels;
    for (const parity::Row& row : rows)
    {
        parity::Row loads = row;
        loads.function = "loads";
        kernels.push_back({row.function, parity::glslKernel(row, kLibrary),
                           parity::glslKernel(loads, kLibrary + std::string(kTotals) + loadFunction(row))});
    }
    return kernels;
}

std::vector<Kernel> estimateKernels()
{
    const Estimate estimates[] = {
#define ESTIMATE(name, texels, ...) {#name, texels, #__VA_ARGS__},
#include "estimates.def"
#undef ESTIMATE
    };
    std::vector<Kernel> kernels;
    for (const Estimate& estimate : estimates)
    {
        const bool sloped = std::string(estimate.expression).find("gradient") != std::string::npos;
        const bool placed = std::string(estimate.expression).find("offset") != std::string::npos;
        std::string loads = sloped ? "    float sum = depth + total(gradient);\n" : "    float sum = depth;\n";
        loads += placed ? "    sum += total(offset);\n" : "";
        for (int i = 0; i < estimate.texels; ++i)
            loads += "    sum += total(texel(" + std::to_string(i) + "));\n";
        const std::string store = "    outputs[gl_GlobalInvocationID.x] = ";
        kernels.push_back({estimate.name, estimateKernel(estimate.texels, store + estimate.expression + ";\n"),
                           estimateKernel(estimate.texels, loads + store + "sum;\n")});
    }
    return kernels;
}

std::vector<Kernel> passKernels(const std::string& glslFolder)
{
    struct Setting
    {
        std::string name;
        std::string pass;
        std::string macros;
    };
    std::vector<Setting> settings;
    for (const int taps : {5, 9, 15, 25, 33})
        settings.push_back({"blur " + std::to_string(taps) + " taps", "blur",
                            "#define LVSM_BLUR_FETCHES " + std::to_string((taps + 1) / 2) + '\n'});
    settings.push_back({"blur any taps", "blur", ""});
    settings.push_back({"store two layers", "store", ""});
    settings.push_back({"store EVSM4", "store",
                        "#define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, vec2(5.54, 5.54))\n"
                        "#define LVSM_STORE_LARGEST LVSM_LARGEST_FP16\n"});
    const std::string blurBindings = "#define LVSM_BLUR_SOURCE layout(binding = 2)\n"
                                     "#define LVSM_BLUR_TARGET layout(binding = 3)\n"
                                     "#define LVSM_BLUR_BLOCK layout(std140, binding = 4)\n";
    const std::string storeBindings = "#define LVSM_STORE_DEPTHS layout(binding = 2)\n"
                                      "#define LVSM_STORE_TARGET layout(binding = 3)\n"
                                      "#define LVSM_STORE_BLOCK layout(std140, binding = 4)\n";
    std::vector<Kernel> kernels;
    for (const Setting& setting : settings)
    {
        std::ifstream file(glslFolder + "/lvsm/passes/" + setting.pass + ".comp");
        std::string version;
        std::getline(file, version);
        const std::string rest(std::istreambuf_iterator<char>(file), {});
        const std::string& bindings = setting.pass == "blur" ? blurBindings : storeBindings;
        kernels.push_back({setting.name, version + '\n' + bindings + setting.macros + rest, ""});
    }
    return kernels;
}

} // namespace cost
