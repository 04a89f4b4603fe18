// The steps of the placement that work on an array of splits, and the schedule.
#include <lvsm/layers.hpp>
#include <lvsm/placement.hpp>

#include "bytes.hpp"

#include <algorithm>

namespace
{

using namespace lvsm;
using namespace lvsm::fuzz;

template <typename T>
void step(Bytes& bytes)
{
    const int layers = bytes.between(1, 70);
    std::vector<T> splits = bytes.numbers<T>(layers + 1);
    const std::vector<T> weights = bytes.numbers<T>(layers + 1);
    const T value = bytes.number<T>();
    monotoneSplits(splits.data(), layers);
    LVSM_CLAIM(areSplits(splits));

    teleportSplits(splits.data(), weights.data(), layers);
    LVSM_CLAIM(areSplits(splits));

    const int layer = layerIndex(value, splits.data(), layers);
    LVSM_CLAIM(layer >= 0 && layer < layers);
    LVSM_CLAIM(!(value >= T(0) && value < T(1)) || (splits[static_cast<std::size_t>(layer)] <= value &&
                                                    value < splits[static_cast<std::size_t>(layer) + 1]));
    const int nearest = nearestSplit(value, splits.data(), layers);
    LVSM_CLAIM(layers < 2 ? nearest == 0 : nearest >= 1 && nearest < layers);
    const T moved = updateSplit(splits[static_cast<std::size_t>(nearest)], bytes.number<T>(), bytes.number<T>());
    LVSM_CLAIM(moved >= T(0) && moved <= T(1));

    const int count = bytes.raw<std::int32_t>();
    const int index = uniformLayerIndex(value, count);
    LVSM_CLAIM(index >= 0 && index < std::clamp(count, 1, kMaxUniformLayers));
    const T split = uniformSplit<T>(bytes.raw<std::int32_t>(), count);
    LVSM_CLAIM(split >= T(0) && split <= T(1));
    const glm::ivec2 pair = scheduledSplits(bytes.raw<std::int32_t>(), count);
    const int last = std::clamp(count, 1, kMaxUniformLayers) - 1;
    LVSM_CLAIM(pair.x >= std::min(1, last) && pair.x <= last && pair.y >= std::min(1, last) && pair.y <= last);
    const auto any = [&bytes]
    {
        return bytes.raw<std::int32_t>();
    };
    const glm::vec<2, T> place = neighbourhoodTexCoord<T>(glm::ivec2(any(), any()), glm::ivec2(any(), any()));
    LVSM_CLAIM(place.x > T(0) && place.x <= T(1) && place.y > T(0) && place.y <= T(1));
}

} // namespace

LVSM_FUZZ(step)
