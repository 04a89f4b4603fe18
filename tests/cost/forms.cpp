// What each part of the estimates from layers costs: their text without it, or in fewer operations. lvsm_quality --forms
// tells what the same is worth, by the same names.
#include "kernels.hpp"

#include "shader_text.hpp"

#include "../parity/kernel.hpp"

namespace cost
{
namespace
{

using Edits = std::vector<std::pair<std::string, std::string>>;

struct Form
{
    std::string name;
    std::string function;
    Edits edits;
};

const char* const kInFront = "float inFront = departures.x * shareInFront / clamp(1.0 - front.x, 0.001, 1.0);";
const char* const kBeyond = "float beyond = departures.z * left.x / clamp(behind.x, 0.001, 1.0);";
const char* const kScale = "    float scale = 1.0 / clamp(interval.y - interval.x, 0.0009765625, 1.0);\n";
const char* const kPlaneBracket = "vec4 left = lvsm_bracketMoments(front, moments, behind, least);";
// Nothing is divided by the share that is left, and the interval's length once for all.
Edits sums()
{
    return {{kScale, ""},
            {"    float least = lvsm_layerMinVariance(max(minVariance, 0.1 * spread), interval);\n",
             std::string(kScale) + "    float least = min(max(minVariance, 0.1 * spread) * (scale * scale), 0.25);\n"},
            {"float inverse = 1.0 / max(left.y, 0.001);", ""},
            {"float m1 = (left.z + (beyond - inFront)) * inverse;",
             "float m1 = clamp(left.z + (beyond - inFront), 0.0, left.y);"},
            {"float m2 = ((left.w - 2.0 * (departures.y - beyond)) + left.y * (spread * (scale * scale))) * inverse;",
             "float m2 = clamp(left.w - 2.0 * (departures.y - beyond) + left.y * (spread * (scale * scale)), 0.0, "
             "left.y);"},
            {"float bound = lvsm_boundedUpperBound(vec2(m1, m2), lvsm_layerWarp(depth, interval), least * inverse);",
             "float t = clamp((depth - interval.x) * scale, 0.0, 1.0);\n"
             "    float tail = lvsm_chebyshevMass(left.y, m1, m2, t, least);\n"
             "    float inverse = 1.0 / max(t, LVSM_TINY);\n"
             "    float parabolas = (min(m1, m1 * t + (m1 - m2)) + 2.25 * least * inverse) * inverse;\n"
             "    float share = t > 0.0 ? min(tail, parabolas) : left.y;\n"
             "    float less = clamp(amount, 0.0, 0.999);"},
            {"return clamp(left.x + left.y * lvsm_reduceLightBleeding(bound, amount), 0.0, 1.0);",
             "return clamp(left.x + clamp((share - less * left.y) * (1.0 / (1.0 - less)), 0.0, left.y), 0.0, 1.0);"}};
}

Edits sumsWithoutFront()
{
    Edits edits = sums();
    edits.push_back({kInFront, "float inFront = 0.0;"});
    return edits;
}

std::vector<Form> forms()
{
    const std::string plane = "planeBracketedVisibility";
    const std::string bounded = "bracketedBoundedVisibility";
    const std::string own = "2.0 * (departures.y - beyond)";
    const std::string share = "float share = t > 0.0 ? min(tail, parabolas) : left.y;";
    const auto bracket = [](const std::string& arguments, const std::string& floor)
    {
        return "vec4 left = lvsm_bracketMoments(" + arguments + ", " + floor + ");";
    };
    const std::string floor = "max(least, LVSM_NEIGHBOUR_MIN_VARIANCE)";
    const std::string boundedBracket = bracket("front, moments, behind", floor) + "\n    float t =";
    return {
        {"plane", plane, {}},
        {"plane: departure in front", plane, {{kInFront, "float inFront = 0.0;"}}},
        {"plane: departure behind", plane, {{kBeyond, "float beyond = 0.0;"}}},
        {"plane: own departure", plane, {{own, "2.0 * (0.0 - beyond)"}}},
        {"plane: the plane's variance", plane, {{" + left.y * (spread * (scale * scale))", ""}}},
        {"plane: share in front", plane, {{kPlaneBracket, bracket("vec2(1.0), moments, behind", "least")}}},
        {"plane: share behind", plane, {{kPlaneBracket, bracket("front, moments, vec2(0.0)", "least")}}},
        {"plane: parabolas",
         plane,
         {{"float bound = lvsm_boundedUpperBound", "float bound = lvsm_chebyshevUpperBound"}}},
        {"plane: bleeding reduced", plane, {{"left.y * lvsm_reduceLightBleeding(bound, amount)", "left.y * bound"}}},
        {"plane: a tenth as a floor", plane, {{"max(minVariance, 0.1 * spread), interval", "minVariance, interval"}}},
        {"plane in sums", plane, sums()},
        {"plane in sums: departure in front", plane, sumsWithoutFront()},
        {"bounded", bounded, {}},
        {"bounded: parabolas", bounded, {{share, "float share = tail;"}}},
        {"bounded: room for rounding",
         bounded,
         {{" + 2.25 * least * inverse) * inverse;\n    float share", ") * inverse;\n    float share"}}},
        {"bounded: share in front",
         bounded,
         {{boundedBracket, bracket("vec2(1.0), moments, behind", floor) + "\n    float t ="}}},
        {"bounded: share behind",
         bounded,
         {{boundedBracket, bracket("front, moments, vec2(0.0)", floor) + "\n    float t ="}}},
        {"bounded: floor of neighbours",
         bounded,
         {{boundedBracket, bracket("front, moments, behind", "least") + "\n    float t ="}}}};
}

} // namespace

std::vector<Kernel> formKernels(const std::string& glslFolder)
{
    const std::string library = withIncludes("#include \"lvsm/lvsm.glsl\"\n", glslFolder);
    std::vector<Kernel> kernels;
    for (const Form& form : forms())
    {
        std::string text = library;
        for (const auto& [what, by] : form.edits)
            text = replaced(text, what, by);
        kernels.push_back(functionKernel(form.function, text));
        kernels.back().kind = "form";
        kernels.back().name = form.name;
    }
    return kernels;
}

} // namespace cost
