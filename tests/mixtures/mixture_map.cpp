#include "mixture_map.hpp"

#include <cmath>

namespace lvsm::mixtures
{

MixtureMap::MixtureMap(const DepthAt& depth, int size, const MixturePlan& plan)
    : m_count(plan.count), m_size(size), m_texel(1)
{
    for (int y = 0; y < m_size; ++y)
    {
        for (int x = 0; x < m_size; ++x)
        {
            m_mixtures.emplace_back();
            m_mixtures.back().components[0] = tapComponent(depth(x, y));
        }
    }
    float variance = 0.0f;
    for (int level = 0; level <= plan.level; ++level)
    {
        if (level > 0)
        {
            variance += 0.25f * static_cast<float>(m_texel * m_texel);
            halve();
        }
        for (std::size_t i = 0; level == std::min(plan.level, 1) && i < plan.rounds.size(); ++i)
        {
            const float step = static_cast<float>(plan.rounds[i].step * m_texel);
            variance += 2.0f * plan.rounds[i].share * step * step;
            mix(plan.rounds[i], true);
            mix(plan.rounds[i], false);
        }
    }
    m_deviation = std::sqrt(variance);
    for (Mixture<float>& mixture : m_mixtures)
    {
        simplifyMixture(mixture, m_count);
        const glm::vec<2, std::uint32_t> two = encodeMixture2(mixture, m_deviation);
        m_codes.push_back(m_count > 2 ? encodeMixture4(mixture, m_deviation)
                                      : glm::vec<4, std::uint32_t>(two.x, two.y, 0u, 0u));
    }
}

std::size_t MixtureMap::at(int x, int y) const
{
    const int last = m_size - 1;
    return static_cast<std::size_t>(detail::clamp(y, 0, last)) * static_cast<std::size_t>(m_size) +
           static_cast<std::size_t>(detail::clamp(x, 0, last));
}

void MixtureMap::mix(const MixtureRound& round, bool alongX)
{
    std::vector<Mixture<float>> mixed(m_mixtures.size());
    for (int y = 0; y < m_size; ++y)
    {
        for (int x = 0; x < m_size; ++x)
        {
            const int dx = alongX ? round.step : 0;
            const int dy = alongX ? 0 : round.step;
            const glm::vec2 offset = static_cast<float>(m_texel) * glm::vec2(dx, dy);
            mixed[at(x, y)] = mixtureStep(m_mixtures[at(x, y)], m_mixtures[at(x - dx, y - dy)],
                                          m_mixtures[at(x + dx, y + dy)], offset, round.share, m_count);
        }
    }
    m_mixtures.swap(mixed);
}

void MixtureMap::halve()
{
    std::vector<Mixture<float>> halved;
    const float reach = 0.5f * static_cast<float>(m_texel);
    for (int y = 0; y < m_size / 2; ++y)
    {
        for (int x = 0; x < m_size / 2; ++x)
        {
            halved.emplace_back();
            for (int k = 0; k < 4; ++k)
            {
                const glm::ivec2 side(k % 2, k / 2);
                const Mixture<float>& from = m_mixtures[at(2 * x + side.x, 2 * y + side.y)];
                for (int i = 0; i < m_count; ++i)
                {
                    const glm::vec2 offset = reach * glm::vec2(2 * side - 1);
                    insertComponent(halved.back(), moveComponent(from.components[i], offset, 0.25f), m_count);
                }
            }
        }
    }
    m_size /= 2;
    m_texel *= 2;
    m_mixtures.swap(halved);
}

float MixtureMap::coded(int x, int y, const glm::vec2& offset, float depth, const glm::vec2& gradient, float bias) const
{
    const glm::vec<4, std::uint32_t>& code = m_codes[at(x, y)];
    return m_count > 2 ? mixtureVisibility4(code, offset, depth, gradient, m_deviation, bias)
                       : mixtureVisibility2(glm::vec<2, std::uint32_t>(code.x, code.y), offset, depth, gradient,
                                            m_deviation, bias);
}

float MixtureMap::uncoded(int x, int y, const glm::vec2& offset, float depth, const glm::vec2& gradient,
                          float bias) const
{
    float weight = 0.0f;
    float lit = 0.0f;
    for (const MixtureComponent<float>& component : m_mixtures[at(x, y)].components)
    {
        const MixturePlane<float> plane = componentPlane(component);
        const float share = planeWeight(plane, offset, m_deviation);
        weight += share;
        lit += share * planeLight(plane, offset, depth, gradient, m_deviation, bias).x;
    }
    return weight > 0.0f ? detail::clamp(lit / weight, 0.0f, 1.0f) : 1.0f;
}

} // namespace lvsm::mixtures
