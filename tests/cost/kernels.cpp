#include "kernels.hpp"

#include "../parity/kernel.hpp"

#include <lvsm/config.hpp>

#include <algorithm>
#include <cfloat>
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

const parity::Row kRows[] = {
#define FUNCTION(name, kind, arguments, domain, low, high) \
    {#name, #kind, #arguments, #domain, low, high, nullptr, nullptr, nullptr},
#include "../parity/functions.def"
#undef FUNCTION
};

} // namespace

std::vector<Kernel> functionKernels()
{
    std::vector<Kernel> kernels;
    for (const parity::Row& row : kRows)
        kernels.push_back(functionKernel(row.function, kLibrary));
    return kernels;
}

Kernel functionKernel(const std::string& function, const std::string& library)
{
    const auto row = std::find_if(std::begin(kRows), std::end(kRows),
                                  [&function](const parity::Row& r) { return r.function == function; });
    parity::Row loads = *row;
    loads.function = "loads";
    return {"function", function, parity::glslKernel(*row, library),
            parity::glslKernel(loads, library + kTotals + loadFunction(*row))};
}

} // namespace cost
