#ifndef LVSM_TESTS_QUALITY_LAYER_SPLITS_HPP
#define LVSM_TESTS_QUALITY_LAYER_SPLITS_HPP

#include <lvsm/layers.hpp>

#include "techniques.hpp"

namespace lvsm::quality
{

enum class Placement
{
    Uniform,
    Optimal
};

constexpr const char* nameOf(Placement placement)
{
    return placement == Placement::Uniform ? "uniform" : "optimal";
}

/// The splits of a technique in one scene; its layers do not overlap.
class Splits
{
public:
    Splits(const Map& map, int count, Placement placement);

    int count() const { return static_cast<int>(m_values.size()) - 1; }
    int layerOf(float depth) const { return layerIndex(depth, m_values.data(), count()); }
    glm::vec2 interval(int layer) const
    {
        return layerInterval(m_values[static_cast<std::size_t>(layer)], m_values[static_cast<std::size_t>(layer) + 1],
                             0.0f);
    }
    float length(int layer) const { return interval(layer).y - interval(layer).x; }

private:
    std::vector<float> m_values;
};

} // namespace lvsm::quality

#endif
