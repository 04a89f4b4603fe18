#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "filter.hpp"
#include "parallel.hpp"

namespace lvsm::quality
{
namespace
{

// Between two points a surface may be steeper than at both: by this share of their slopes.
constexpr float kRoom = 0.25f;

void judge(const Scene& scene, const std::vector<double>& kernel, Receiver& receiver)
{
    const ShiftedKernel x(kernel, receiver.offset.x);
    const ShiftedKernel y(kernel, receiver.offset.y);
    const Surface& surface = receiver.surface;
    double lit = 0.0;
    double occluded = 0.0;
    double distance = 0.0;
    for (int dy = y.first(); dy <= y.last(); ++dy)
    {
        for (int dx = x.first(); dx <= x.last(); ++dx)
        {
            const glm::ivec2 offset{dx, dy};
            const float own = scene.mesh ? ownDepth(scene.peel, surface, receiver.x, receiver.y, offset)
                                         : surface.depth + glm::dot(surface.gradient, glm::vec2(offset));
            const float map = scene.peel.nearest(receiver.x + dx, receiver.y + dy).depth;
            const double weight = x.weight(dx) * y.weight(dy);
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
    receiver.visibility = static_cast<float>(lit);
    receiver.occluderDistance = static_cast<float>(occluded > 0.0 ? distance / occluded : 0.0);
}

} // namespace

void judgeAll(const Scene& scene, const std::vector<double>& kernel, std::vector<Receiver>& receivers)
{
    constexpr std::size_t kBatch = 1024;
    parallelFor((receivers.size() + kBatch - 1) / kBatch,
                [&](std::size_t batch)
                {
                    const std::size_t stop = std::min(receivers.size(), (batch + 1) * kBatch);
                    for (std::size_t i = batch * kBatch; i < stop; ++i)
                        judge(scene, kernel, receivers[i]);
                });
}

const Surface* ownSurface(const Peel& peel, const Surface& receiver, int x, int y, glm::ivec2 offset)
{
    const glm::vec2 step(offset);
    const float plane = receiver.depth + glm::dot(receiver.gradient, step);
    const Surface* own = nullptr;
    float least = 2.0f;
    for (const Surface* s = peel.begin(x + offset.x, y + offset.y); s != peel.end(x + offset.x, y + offset.y); ++s)
    {
        const float away = std::abs(s->depth - plane);
        const float bend = std::abs(glm::dot(s->gradient - receiver.gradient, step));
        const float room = kRoom * glm::length(step) * (glm::length(s->gradient) + glm::length(receiver.gradient));
        if (away < least && away <= bend + room + kSameDepth)
        {
            least = away;
            own = s;
        }
    }
    return own;
}

float ownDepth(const Peel& peel, const Surface& receiver, int x, int y, glm::ivec2 offset)
{
    const Surface* own = ownSurface(peel, receiver, x, y, offset);
    const float depth = own != nullptr ? own->depth : receiver.depth + glm::dot(receiver.gradient, glm::vec2(offset));
    return std::min(depth, 1.0f); // an empty texel's depth, which no plane is behind
}

std::vector<Receiver> receiversOf(const Scene& scene, const std::vector<double>& kernel, const Choice& choice)
{
    constexpr unsigned kThinningSeed = 9;
    const int margin = static_cast<int>(kernel.size()) / 2 + 5; // a tap, a neighbour, half resolution
    const int last = scene.peel.size() - 1 - margin;

    std::mt19937 random(kThinningSeed);
    const auto uniform = [&]
    {
        return static_cast<float>(random() >> 8) * 0x1p-24f;
    };
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
                if (thinned && middle && uniform() < 0.5f)
                    continue;
                const float toRight = uniform() - 0.5f;
                const glm::vec2 offset(toRight, uniform() - 0.5f);
                if (s->facing > 0.0f)
                    receivers.push_back({x, y, choice.centred ? glm::vec2(0.0f) : offset, *s, 0.0f, 0.0f});
            }
        }
    }
    // In any order, so that the first few of them are a fair sample: rows repeat, and so do surfaces along a ray.
    const std::size_t count = std::min(receivers.size(), choice.most);
    for (std::size_t i = 0; i < count; ++i)
        std::swap(receivers[i], receivers[i + random() % (receivers.size() - i)]);
    receivers.resize(count);
    judgeAll(scene, kernel, receivers);
    return receivers;
}

std::vector<Receiver> neighboursOf(const Scene& scene, const std::vector<Receiver>& receivers,
                                   const std::vector<double>& kernel)
{
    std::vector<Receiver> pairs;
    for (const Receiver& r : receivers)
    {
        const Surface* next = ownSurface(scene.peel, r.surface, r.x, r.y, {1, 0});
        if (next == nullptr)
            continue;
        pairs.push_back(r);
        pairs.push_back({r.x + 1, r.y, r.offset, *next, 0.0f, 0.0f});
    }
    judgeAll(scene, kernel, pairs);
    return pairs;
}

} // namespace lvsm::quality
