// What the wrappers that read maps of mixtures have to answer.
#include "mixtures_truth.hpp"

#include <cmath>

namespace sampling
{

MixtureMaps randomCodes()
{
    Random random;
    MixtureMaps maps;
    const auto word = [&]
    {
        return static_cast<std::uint32_t>(random.next() * 65536.0f) << 16 |
               static_cast<std::uint32_t>(random.next() * 65536.0f);
    };
    for (std::size_t i = 0; i < maps.shape.count(); ++i)
    {
        maps.two.emplace_back(word(), word());
        maps.four.emplace_back(word(), word(), word(), word());
    }
    return maps;
}

std::vector<MixtureReceiver> mixtureReceivers()
{
    Random random;
    std::vector<MixtureReceiver> receivers;
    for (int y = -3; y < 13 * 4; ++y)
    {
        // Nowhere at the border of two texels, where rounding would choose.
        for (int x = -5; x < 9 * 4; ++x)
            receivers.push_back({{(x + 0.3) / 32, (y + 0.7) / 48},
                                 static_cast<double>(random.next()),
                                 x % 2 == 0 ? 2.0 : 1.0,
                                 {0.02 * (static_cast<double>(random.next()) - 0.5), 0.01},
                                 0.5 + 4 * static_cast<double>(random.next()),
                                 y % 2 == 0 ? 1 : 0});
    }
    return receivers;
}

bool compareMixtureWrappers(const MixtureMaps& maps, const std::vector<MixtureReceiver>& receivers,
                            const std::vector<glm::vec4>& results)
{
    Comparison two("sampleMixture2");
    Comparison four("sampleMixture4");
    for (std::size_t i = 0; i < receivers.size(); ++i)
    {
        const MixtureReceiver& r = receivers[i];
        const double depth = lvsm::shiftReceiver(r.depth, r.gradient, 0.5);
        const double bias = lvsm::kMixtureBias<double>;
        for (int c = 0; c < 4; ++c)
        {
            const int part = c < 2 ? 1 : 2;
            const glm::dvec2 size(maps.shape.width / part, maps.shape.height / part);
            const glm::dvec2 position = r.uv * size;
            const glm::dvec2 texel = glm::floor(position);
            const glm::dvec2 offset = r.texels * (position - texel - 0.5);
            const bool isOff = texel.x < 0 || texel.y < 0 || texel.x >= size.x || texel.y >= size.y;
            const glm::ivec2 first(c < 2 ? glm::dvec2(0) : 0.5 * size);
            const std::size_t at = maps.shape.indexOf(first.x + static_cast<int>(texel.x),
                                                      first.y + static_cast<int>(texel.y), r.slice, 0);
            const bool isTwo = c % 2 == 0;
            const double visible =
                isTwo ? lvsm::mixtureVisibility2(maps.two[at], offset, depth, r.gradient, r.deviation, bias)
                      : lvsm::mixtureVisibility4(maps.four[at], offset, depth, r.gradient, r.deviation, bias);
            // Ten roundings of depths and slopes over the least deviation that a code has, times the root of 12.
            (isTwo ? two : four)
                .expect(static_cast<double>(results[i][c]), isOff ? 1 : visible,
                        10.0 / (1 << 24) / (std::sqrt(12.0) * lvsm::kLeastDeviation<double>)+35.0 / (1 << 23),
                        std::to_string(position.x) + ' ' + std::to_string(position.y) + " slice " +
                            std::to_string(r.slice));
        }
    }
    const bool passed = two.passed();
    return four.passed() && passed;
}

} // namespace sampling
