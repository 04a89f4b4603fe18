#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "parallel.hpp"

namespace lvsm::quality
{
namespace
{

// Between two points a surface may be steeper than at both: by this share of their slopes.
constexpr float kRoom = 0.25f;

Receiver judged(const Scene& scene, const std::vector<double>& kernel, int x, int y, const Surface& surface)
{
    const int radius = static_cast<int>(kernel.size()) / 2;
    double lit = 0.0;
    double occluded = 0.0;
    double distance = 0.0;
    for (int dy = -radius; dy <= radius; ++dy)
    {
        for (int dx = -radius; dx <= radius; ++dx)
        {
            const glm::ivec2 offset{dx, dy};
            const float own = scene.mesh ? ownDepth(scene.peel, surface, x, y, offset)
                                         : surface.depth + glm::dot(surface.gradient, glm::vec2(offset));
            const float map = scene.peel.nearest(x + dx, y + dy).depth;
            const double weight =
                kernel[static_cast<std::size_t>(dx + radius)] * kernel[static_cast<std::size_t>(dy + radius)];
            if (map >= own - kSameDepth)
            {
                lit += weight;
            }
            else
            {
                occluded += weight;
                distance += weight * static_cast<double>(own - map);
            }
        }
    }
    const double mean = occluded > 0.0 ? distance / occluded : 0.0;
    return {x, y, surface, static_cast<float>(lit), static_cast<float>(mean)};
}

} // namespace

float ownDepth(const Peel& peel, const Surface& receiver, int x, int y, glm::ivec2 offset)
{
    const glm::vec2 step(offset);
    const float plane = receiver.depth + glm::dot(receiver.gradient, step);
    float own = plane;
    float least = 2.0f;
    for (const Surface* s = peel.begin(x + offset.x, y + offset.y); s != peel.end(x + offset.x, y + offset.y); ++s)
    {
        const float away = std::abs(s->depth - plane);
        const float bend = std::abs(glm::dot(s->gradient - receiver.gradient, step));
        const float room = kRoom * glm::length(step) * (glm::length(s->gradient) + glm::length(receiver.gradient));
        if (away < least && away <= bend + room + kSameDepth)
        {
            least = away;
            own = s->depth;
        }
    }
    return std::min(own, 1.0f); // an empty texel's depth, which no plane is behind
}

std::vector<Receiver> receiversOf(const Scene& scene, const std::vector<double>& kernel)
{
    constexpr unsigned kThinningSeed = 9;
    const int margin = static_cast<int>(kernel.size()) / 2 + 1;
    const int last = scene.peel.size() - 1 - margin;

    std::mt19937 random(kThinningSeed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    std::vector<Receiver> receivers;
    for (int y = margin; y <= last; ++y)
    {
        for (int x = margin; x <= last; ++x)
        {
            const Surface* const begin = scene.peel.begin(x, y);
            const Surface* const end = scene.peel.end(x, y);
            const bool thinned = !scene.mesh && end - begin > 3;
            for (const Surface* s = begin; s != end; ++s)
            {
                const bool middle = s != begin && s != end - 1;
                if (thinned && middle && uniform(random) < 0.5f)
                    continue;
                if (s->facing > 0.0f)
                    receivers.push_back({x, y, *s, 0.0f, 0.0f});
            }
        }
    }

    constexpr std::size_t kBatch = 4096;
    parallelFor((receivers.size() + kBatch - 1) / kBatch,
                [&](std::size_t batch)
                {
                    const std::size_t stop = std::min(receivers.size(), (batch + 1) * kBatch);
                    for (std::size_t i = batch * kBatch; i < stop; ++i)
                    {
                        Receiver& r = receivers[i];
                        r = judged(scene, kernel, r.x, r.y, r.surface);
                    }
                });
    return receivers;
}

} // namespace lvsm::quality
