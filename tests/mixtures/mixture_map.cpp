#include "mixture_map.hpp"

#include <lvsm/receiver.hpp>

#include <cmath>

namespace lvsm::mixtures
{
namespace
{

std::size_t at(int x, int y, int size)
{
    const int last = size - 1;
    return static_cast<std::size_t>(detail::clamp(y, 0, last)) * static_cast<std::size_t>(size) +
           static_cast<std::size_t>(detail::clamp(x, 0, last));
}

} // namespace

MixtureMap::MixtureMap(const DepthAt& depth, int size, int rounds, int count, bool isHalf)
    : m_texel(isHalf ? 2 : 1), m_size(size / m_texel), m_count(count)
{
    for (int y = 0; y < m_size; ++y)
    {
        for (int x = 0; x < m_size; ++x)
        {
            Mixture<float> texel{};
            if (isHalf)
                texel = mixtureOfTaps(glm::vec4(depth(2 * x, 2 * y), depth(2 * x + 1, 2 * y), depth(2 * x, 2 * y + 1),
                                                depth(2 * x + 1, 2 * y + 1)),
                                      glm::vec4(-0.5f, 0.5f, -0.5f, 0.5f), glm::vec4(-0.5f, -0.5f, 0.5f, 0.5f), count);
            else
                texel.components[0] = tapComponent(depth(x, y));
            m_mixtures.push_back(texel);
        }
    }
    for (int round = 0; round < rounds; ++round)
    {
        step(1 << round, true);
        step(1 << round, false);
    }
    // 2 x 2 taps have the variance 1/4.
    const float scale = static_cast<float>(m_texel);
    const float tree = scale * mixtureDeviation(rounds);
    m_deviation = std::sqrt(tree * tree + (isHalf ? 0.25f : 0.0f));
    for (Mixture<float>& mixture : m_mixtures)
    {
        simplifyMixture(mixture, count);
        const glm::vec<2, std::uint32_t> two = encodeMixture2(mixture, m_deviation);
        m_codes.push_back(count > 2 ? encodeMixture4(mixture, m_deviation)
                                    : glm::vec<4, std::uint32_t>(two.x, two.y, 0u, 0u));
    }
}

void MixtureMap::step(int texels, bool alongX)
{
    std::vector<Mixture<float>> mixed(m_mixtures.size());
    for (int y = 0; y < m_size; ++y)
    {
        for (int x = 0; x < m_size; ++x)
        {
            for (const int side : {0, -1, 1})
            {
                const int dx = alongX ? side * texels : 0;
                const int dy = alongX ? 0 : side * texels;
                const glm::vec2 offset = static_cast<float>(m_texel) * glm::vec2(dx, dy);
                const Mixture<float>& from = m_mixtures[at(x + dx, y + dy, m_size)];
                for (int i = 0; i < m_count; ++i)
                    insertComponent(mixed[at(x, y, m_size)],
                                    moveComponent(from.components[i], offset, side == 0 ? 0.5f : 0.25f), m_count);
            }
        }
    }
    m_mixtures.swap(mixed);
}

float MixtureMap::visibility(const glm::vec2& place, float depth, const glm::vec2& gradient) const
{
    const float scale = static_cast<float>(m_texel);
    const glm::vec2 middle = (place - 0.5f * (scale - 1.0f)) / scale;
    const int x = detail::clamp(static_cast<int>(std::floor(middle.x + 0.5f)), 0, m_size - 1);
    const int y = detail::clamp(static_cast<int>(std::floor(middle.y + 0.5f)), 0, m_size - 1);
    const glm::vec2 offset = scale * (middle - glm::vec2(x, y));
    const glm::vec<4, std::uint32_t>& code = m_codes[at(x, y, m_size)];
    const float shifted = shiftReceiver(depth, gradient, 0.5f);
    const float bias = kMixtureBias<float>;
    return m_count > 2 ? mixtureVisibility4(code, offset, shifted, gradient, m_deviation, bias)
                       : mixtureVisibility2(glm::vec<2, std::uint32_t>(code.x, code.y), offset, shifted, gradient,
                                            m_deviation, bias);
}

} // namespace lvsm::mixtures
