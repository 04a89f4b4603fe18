// What the device made beside what it has to make.
#include "mixtures_truth.hpp"

#include <algorithm>
#include <cmath>

namespace sampling
{

// Any depths: all that decides is far from equal for most texels.
float noiseDepth(int x, int y)
{
    const std::uint32_t hash =
        (static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u) * 2654435761u;
    return static_cast<float>(hash >> 8) / static_cast<float>(1 << 24);
}

// Slanted ground under bars of two heights.
float barDepth(int x, int y)
{
    const float ground = 0.7f + 0.004f * static_cast<float>(x) - 0.003f * static_cast<float>(y);
    const float noisy = 0.01f * noiseDepth(x, y);
    return (x / 3 % 3 == 0 ? 0.2f : y / 4 % 3 == 0 ? 0.45f : ground) + noisy;
}

namespace
{

// Bits of a word from begin on, as a number of two's complement where they are signed.
double fieldAt(std::uint32_t word, int begin, int bits, bool hasSign = false)
{
    const auto value = static_cast<int>(word >> begin & ((1u << bits) - 1u));
    return hasSign && value >= 1 << (bits - 1) ? value - (1 << bits) : value;
}

std::string placeOf(std::size_t i, int width)
{
    return std::to_string(i % static_cast<std::size_t>(width)) + ' ' +
           std::to_string(i / static_cast<std::size_t>(width));
}

// How far two packed components are from each other, in levels of each field. Depths are compared at the same place.
double levelsApart(const Packed& a, const Packed& b, const PackedField& field)
{
    const double levels = fieldOf(a, field) - static_cast<double>(fieldOf(b, field));
    if (&field != &kPackedFields[0])
        return levels;
    const auto first = unpacked(a), second = unpacked(b);
    const glm::dvec2 slope = lvsm::componentSlope(second);
    const glm::dvec2 away = first.place - second.place;
    return levels - (slope.x * away.x + slope.y * away.y) * ((1 << 20) - 1);
}

// Components are packed after each direction of a round, and rounding may decide otherwise each time: a level in two
// rounds four times, and once more for what they are made of. A place that is a level off, 1/64 texel, moves taps along
// their slope, and turns a plane whose taps are half a texel apart or more by a 32nd of it.
double levelsAllowed(const Packed& truth, const PackedField& field)
{
    const glm::dvec2 slope = lvsm::componentSlope(unpacked(truth));
    const double along = std::abs(slope.x) + std::abs(slope.y);
    if (&field == &kPackedFields[0])
        return 5 + along * (1 << 20) / 64;
    if (&field != &kPackedFields[5] && &field != &kPackedFields[6])
        return 5;
    const double own = std::abs(&field == &kPackedFields[5] ? slope.x : slope.y);
    return 5 + along / 32 / (2 * std::max(std::sqrt(own), 1e-3)) * 32767;
}

} // namespace

std::pair<std::size_t, std::size_t> compareComponents(Comparison& comparison, const Mixtures& made,
                                                      const Mixtures& expected, int count)
{
    std::size_t compared = 0, same = 0;
    for (std::size_t t = 0; t < made.texels.size(); ++t)
    {
        if (expected.texels[t].isTied)
            continue;
        ++compared;
        bool isSame = true;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
        {
            const Packed& truth = expected.texels[t].packed[k];
            isSame &= truth == made.texels[t].packed[k];
            for (const PackedField& field : kPackedFields)
                comparison.expect(levelsApart(made.texels[t].packed[k], truth, field), 0, levelsAllowed(truth, field),
                                  "texel " + placeOf(t, made.area.width) + " component " + std::to_string(k) + ' ' +
                                      field.name);
        }
        same += isSame ? 1 : 0;
    }
    return {compared, same};
}

bool compareCode(Comparison& comparison, int count, const Packed& made, const glm::uvec4& expected, double tolerance,
                 const std::string& where)
{
    bool isSame = true;
    for (int w = 0; w < count; ++w)
    {
        const std::uint32_t word = made[static_cast<std::size_t>(w)];
        isSame &= word == expected[w];
        // Deviations of all planes, or share and place; then slopes.
        const int low = w > 0 ? 4 : 12 / count;
        for (int begin = 0; begin < 12; begin += low)
            comparison.expect(fieldAt(word, begin, low), fieldAt(expected[w], begin, low), tolerance,
                              where + " word " + std::to_string(w) + " bit " + std::to_string(begin));
        for (const int begin : {12, 17})
            comparison.expect(fieldAt(word, begin, 5, true), fieldAt(expected[w], begin, 5, true), tolerance,
                              where + " word " + std::to_string(w) + " slope at bit " + std::to_string(begin));
        // A depth is coded for the place and slope that are coded.
        if ((word ^ expected[w]) << 10 == 0 && made[0] << 10 == expected[0] << 10)
            comparison.expect(fieldAt(word, 22, 10), fieldAt(expected[w], 22, 10), tolerance,
                              where + " word " + std::to_string(w) + " depth");
    }
    return isSame;
}

} // namespace sampling
