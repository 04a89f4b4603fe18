// Mixtures of planes, which are filtered by merging and not channel by channel.
#include <cmath>

#include "../mixtures/mixture_map.hpp"
#include "techniques.hpp"

namespace lvsm::quality
{
namespace
{

/// Rounds that make the map's window: the filter's own, or from 2 x 2 texels on such as give the filter's deviation.
mixtures::MixturePlan planOf(const Map& map, int count)
{
    mixtures::MixturePlan plan{count, map.level, {}};
    if (map.level == 0)
    {
        for (const Round& round : map.window.rounds())
            plan.rounds.push_back({round.step, static_cast<float>(round.share)});
        return plan;
    }
    if (map.window.tree)
    {
        for (int step = 1; 2 * step <= (map.window.width + 1) / 4; step *= 2)
            plan.rounds.push_back({step, 0.25f});
        return plan;
    }
    // A round of one texel of such a map, two of the shadow map, adds a variance of 8 times the share, and 2 x 2 texels
    // have one of 1/4. A bilinear sample of the shadow map's texels, by which all are judged, adds 1/6 in the mean; one of
    // twice that size, which four decodes are, 4/6; and the receivers that read a texel where it lies are spread by 1/3.
    const double read = map.decoded ? -0.5 : 0.5;
    const double own = map.footprint.minified() ? 0.0 : 0.25 - read;
    const double variance = 0.25 * (map.window.width - 1) - own;
    const int rounds = static_cast<int>(std::ceil(0.5 * variance));
    for (int i = 0; i < rounds; ++i)
        plan.rounds.push_back({1, static_cast<float>(0.125 * variance / rounds)});
    return plan;
}

class MixtureOfPlanes : public Estimator
{
public:
    MixtureOfPlanes(const Map& map, int count, bool coded)
        : m_coded(coded), m_texel(static_cast<float>(1 << map.level)),
          m_map([&](int x, int y) { return map.peel.nearest(x, y).depth; }, map.peel.size(), planOf(map, count))
    {
    }

    void store(const Surface&, float*) const override {}
    float visibility(const Query& q) const override
    {
        const auto judge = m_coded ? &mixtures::MixtureMap::coded : &mixtures::MixtureMap::uncoded;
        return (m_map.*judge)(q.x, q.y, m_texel * q.offset, q.depth, q.gradient / m_texel,
                              q.bias * kMixtureBias<float>);
    }

private:
    bool m_coded;
    float m_texel; ///< of the map, in those of the shadow map
    mixtures::MixtureMap m_map;
};

Technique mixture(int count)
{
    const std::string bits = std::to_string(32 * count) + "-bit";
    Technique technique{"mixture K=" + std::to_string(count) + " " + bits,
                        false,
                        32 * count,
                        0,
                        Format::Fp32,
                        false,
                        [=](const Map& map) { return std::make_unique<MixtureOfPlanes>(map, count, true); },
                        "mixture " + bits};
    technique.reading = Reading::Nearest;
    technique.bias = true;
    technique.own = Own{0.5f};
    return technique;
}

} // namespace

std::vector<Technique> mixtureTechniques()
{
    Technique uncoded = mixture(4);
    uncoded.name = "limit: mixture K=4, not coded";
    uncoded.bits = 0;
    uncoded.prepare = [](const Map& map)
    {
        return std::make_unique<MixtureOfPlanes>(map, 4, false);
    };
    return {mixture(2), mixture(4), uncoded};
}

} // namespace lvsm::quality
