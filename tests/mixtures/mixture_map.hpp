// A map of mixtures, made by the tree on the host, as a pass makes it.
#ifndef LVSM_TESTS_MIXTURES_MIXTURE_MAP_HPP
#define LVSM_TESTS_MIXTURES_MIXTURE_MAP_HPP

#include <lvsm/mixture.hpp>

#include <functional>
#include <vector>

namespace lvsm::mixtures
{

using DepthAt = std::function<float(int, int)>;

/// Coded planes of a square map, two in 64 bits or four in 128.
class MixtureMap
{
public:
    /// rounds: of the tree. isHalf: one code for 2 x 2 texels, whose first round steps two texels.
    MixtureMap(const DepthAt& depth, int size, int rounds, int count, bool isHalf);

    /// One nearest fetch, at a place whose whole numbers are the centres of texels.
    float visibility(const glm::vec2& place, float depth, const glm::vec2& gradient) const;

private:
    void step(int texels, bool alongX);

    int m_texel; ///< of the map, in texels of the shadow map
    int m_size;
    int m_count;
    float m_deviation;
    std::vector<Mixture<float>> m_mixtures;
    std::vector<glm::vec<4, std::uint32_t>> m_codes;
};

} // namespace lvsm::mixtures

#endif
