// A map of mixtures, made by rounds of the tree on the host, as a pass makes it.
#ifndef LVSM_TESTS_MIXTURES_MIXTURE_MAP_HPP
#define LVSM_TESTS_MIXTURES_MIXTURE_MAP_HPP

#include <lvsm/mixture.hpp>

#include <functional>
#include <vector>

namespace lvsm::mixtures
{

using DepthAt = std::function<float(int, int)>;

/// What a round mixes: each texel with the two that are so many texels of the map away, which get this share each.
struct MixtureRound
{
    int step;
    float share;
};

/// How a map is made of a shadow map.
struct MixturePlan
{
    int count;                        ///< of planes, two or four
    int level;                        ///< one texel for 1, 2 x 2, 4 x 4, ... of the shadow map
    std::vector<MixtureRound> rounds; ///< at level 0, or from level 1 on at level 1
};

/// Planes of a square map, as they are or coded: two in 64 bits, four in 128.
class MixtureMap
{
public:
    MixtureMap(const DepthAt& depth, int size, const MixturePlan& plan);

    /// One texel's, for a receiver that is offset from its centre. offset, gradient: in texels of the shadow map.
    float coded(int x, int y, const glm::vec2& offset, float depth, const glm::vec2& gradient, float bias) const;
    float uncoded(int x, int y, const glm::vec2& offset, float depth, const glm::vec2& gradient, float bias) const;

private:
    void mix(const MixtureRound& round, bool alongX);
    void halve();
    std::size_t at(int x, int y) const;

    int m_count;
    int m_size;
    int m_texel; ///< in texels of the shadow map
    float m_deviation;
    std::vector<Mixture<float>> m_mixtures;
    std::vector<glm::vec<4, std::uint32_t>> m_codes;
};

} // namespace lvsm::mixtures

#endif
