#include "layer_splits.hpp"

#include <lvsm/optimal.hpp>

namespace lvsm::quality
{

Splits::Splits(const Map& map, int count, Placement placement)
{
    for (int i = 0; i <= count; ++i)
        m_values.push_back(uniformSplit<float>(i, count));
    if (placement == Placement::Uniform)
        return;

    const int size = map.peel.size();
    std::vector<float> depths;
    for (int y = 0; y < size; ++y)
    {
        for (int x = 0; x < size; ++x)
            depths.push_back(map.peel.nearest(x, y).depth);
    }
    optimalSplits(depths.data(), size, size, m_values.data(), count);
}

} // namespace lvsm::quality
