// The maps that estimates read: stored, blurred along x and y, and where they are codes, coded last.
#include "kernels.hpp"

namespace cost
{
namespace
{

struct Recipe
{
    const char* name;
    const char* stored;
    const char* format;
    int bits;
    bool slice;
    const char* code; ///< the pass that makes codes of it
};

constexpr Recipe kRecipes[] = {
    {"ESM", "ESM", "r32f", 32, false, ""},
    {"VSM", "VSM", "rg16", 32, false, ""},
    {"two layers", "two layers", "rgba16", 64, true, ""},
    {"two layers 8-bit", "two layers 8-bit", "rgba8", 32, true, ""},
    {"EVSM2", "EVSM2", "rg32f", 64, false, ""},
    {"EVSM4", "EVSM4", "rgba32f", 128, false, ""},
    {"MSM4", "MSM4", "rgba32f", 128, false, ""},
    {"MSM4 16-bit", "MSM4 16-bit", "rgba16", 64, false, ""},
    {"layered MSM4 16-bit", "layered MSM4 16-bit", "rgba16", 64, true, ""},
    {"trigonometric 16-bit", "trigonometric 16-bit", "rgba16", 64, false, ""},
    {"four terms 8-bit", "four sines 8-bit", "rgba8", 32, true, ""},
    {"MSM4 quantised 64-bit", "MSM4", "rgba32f", 64, false, "code MSM4 quantised 64-bit"},
    {"MSM4 quantised 32-bit", "MSM4", "rgba32f", 32, false, "code MSM4 quantised 32-bit"},
};

} // namespace

std::vector<Map> maps()
{
    std::vector<Map> all;
    for (const Recipe& recipe : kRecipes)
    {
        for (const int width : {3, 7, 15, 25})
        {
            const std::string format = recipe.format;
            Map map{recipe.name, width, 1.0, recipe.bits, recipe.slice, {}};
            map.passes = {{std::string("store ") + recipe.stored, 1.0},
                          {"blur " + std::to_string(width) + ' ' + format, 2.0}};
            Map half = map;
            half.resolution = 0.5;
            half.passes.emplace_back("mip " + format, 0.25);
            if (*recipe.code != 0)
            {
                map.passes.emplace_back(recipe.code, 1.0);
                half.passes.emplace_back(recipe.code, 0.25);
            }
            all.push_back(map);
            all.push_back(half);
        }
    }
    return all;
}

} // namespace cost
