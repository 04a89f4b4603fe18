#include "levels_truth.hpp"

#include <algorithm>

namespace sampling
{
namespace
{

// How much of texel j of n lies in cell i of m that divide them equally.
double shareOf(int j, int n, int i, int m)
{
    const double width = static_cast<double>(n) / m;
    return std::max(std::min(j + 1.0, (i + 1) * width) - std::max(double(j), i * width), 0.0) / width;
}

glm::dvec4 expectedTexel(const Pixels& pixels, const Levels& levels, int level, int x, int y, int slice)
{
    const lvsm::Rectangle before = lvsm::levelRectangle(levels.map, level - 1);
    const lvsm::Rectangle own = lvsm::levelRectangle(levels.map, level);
    glm::dvec4 mean(0);
    glm::dvec4 largest(-1e9);
    for (int i = 0; i < before.width * before.height; ++i)
    {
        const double weight = shareOf(i % before.width, before.width, x, own.width) *
                              shareOf(i / before.width, before.height, y, own.height);
        const glm::dvec4 texel(pixels.at(before.x + i % before.width, before.y + i / before.width, slice, level - 1));
        mean += weight * texel;
        if (weight > 1e-9)
            largest = glm::max(largest, texel);
    }
    return levels.maximum ? largest : mean;
}

} // namespace

Pixels randomLevels()
{
    Pixels pixels(kLevelsTexture.width, kLevelsTexture.height, kLevelsTexture.slices, kLevelsTexture.levels);
    Random random;
    for (glm::vec4& texel : pixels.texels)
        texel = {random.next(), random.next(), 4 * random.next(), -random.next()};
    return pixels;
}

int Levels::count() const
{
    return std::min(lvsm::levelCount(map), kLevelsTexture.levels);
}

std::vector<Levels> levelsOfTest()
{
    return {{"levels of a whole map", {0, 0, 48, 32}, false},
            {"levels of odd sizes in an atlas", {16, 0, 23, 15}, false},
            {"levels of the largest", {16, 0, 23, 15}, true}};
}

bool compareLevels(const std::string& what, const Levels& levels, const Pixels& made, bool isAlone)
{
    const Pixels pixels = randomLevels();
    Comparison comparison(levels.name + what);
    for (int level = 1; level < levels.count(); ++level)
    {
        const lvsm::Rectangle own = lvsm::levelRectangle(levels.map, level);
        for (int i = 0; i < (kLevelsTexture.width >> level) * (kLevelsTexture.height >> level) * kLevelsTexture.slices;
             ++i)
        {
            const int x = i % (kLevelsTexture.width >> level);
            const int y = i / (kLevelsTexture.width >> level) % (kLevelsTexture.height >> level);
            const int slice = i / ((kLevelsTexture.width >> level) * (kLevelsTexture.height >> level));
            const bool inside = x >= own.x && x < own.x + own.width && y >= own.y && y < own.y + own.height;
            // Drawing covers all of the level, of which the rest is not the pass's.
            if (!inside && !isAlone)
                continue;
            const glm::dvec4 expected = inside ? expectedTexel(made, levels, level, x - own.x, y - own.y, slice)
                                               : glm::dvec4(pixels.at(x, y, slice, level));
            for (int c = 0; c < 4; ++c)
                // Nine texels of up to 4, each with the roundings of two quotients, two products and a sum.
                comparison.expect(static_cast<double>(made.at(x, y, slice, level)[c]), expected[c],
                                  inside ? 8 * 4.0 / (1 << 23) : 0,
                                  std::to_string(x) + ' ' + std::to_string(y) + " level " + std::to_string(level));
        }
    }
    return comparison.passed();
}

} // namespace sampling
