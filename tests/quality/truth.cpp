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

void judge(const Scene& scene, const std::vector<double>& kernel, const Footprint& footprint, Receiver& receiver)
{
    const PlacedWindow window(kernel, receiver.offset, footprint, receiver.direction);
    const Surface& surface = receiver.surface;
    double lit = 0.0;
    double occluded = 0.0;
    double distance = 0.0;
    for (int dy = window.first(); dy <= window.last(); ++dy)
    {
        for (int dx = window.first(); dx <= window.last(); ++dx)
        {
            const double weight = window.weight(dx, dy);
            if (!(weight > 0.0))
                continue;
            const glm::ivec2 offset{dx, dy};
            const float own = scene.mesh ? ownDepth(scene.peel, surface, receiver.x, receiver.y, offset)
                                         : surface.depth + glm::dot(surface.gradient, glm::vec2(offset));
            const float map = scene.peel.nearest(receiver.x + dx, receiver.y + dy).depth;
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

PlacedWindow::PlacedWindow(const std::vector<double>& kernel, glm::vec2 offset, const Footprint& footprint,
                           glm::vec2 direction)
    : m_first(-static_cast<int>(kernel.size()) / 2 - 1 - (footprint.minified() ? footprint.length : 0)),
      m_size(1 - 2 * m_first), m_weights(static_cast<std::size_t>(m_size) * static_cast<std::size_t>(m_size))
{
    // A place for each texel's length and width of the footprint, all with the same share.
    const int along = footprint.length;
    const int across = std::max(1, footprint.length / footprint.stretch);
    const float breadth = footprint.minified() ? footprint.across() : 1.0f;
    for (int i = 0; i < along * across; ++i)
    {
        const float u = static_cast<float>(i % along) - 0.5f * static_cast<float>(along - 1);
        const float v = breadth * ((static_cast<float>(i / along) + 0.5f) / static_cast<float>(across) - 0.5f);
        const glm::vec2 place = offset + u * direction + v * glm::vec2(-direction.y, direction.x);
        const ShiftedKernel x(kernel, place.x);
        const ShiftedKernel y(kernel, place.y);
        for (int dy = y.first(); dy <= y.last(); ++dy)
        {
            for (int dx = x.first(); dx <= x.last(); ++dx)
                m_weights[static_cast<std::size_t>(dy - m_first) * static_cast<std::size_t>(m_size) +
                          static_cast<std::size_t>(dx - m_first)] += x.weight(dx) * y.weight(dy) / (along * across);
        }
    }
}

void judgeAll(const Scene& scene, const std::vector<double>& kernel, std::vector<Receiver>& receivers,
              const Footprint& footprint)
{
    constexpr std::size_t kBatch = 1024;
    parallelFor((receivers.size() + kBatch - 1) / kBatch,
                [&](std::size_t batch)
                {
                    const std::size_t stop = std::min(receivers.size(), (batch + 1) * kBatch);
                    for (std::size_t i = batch * kBatch; i < stop; ++i)
                        judge(scene, kernel, footprint, receivers[i]);
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
    const int margin = static_cast<int>(kernel.size()) / 2 + 5 + // a tap, a neighbour, half resolution
                       (choice.footprint.minified() ? 2 * choice.footprint.length : 0);
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
    for (std::size_t i = 0; choice.footprint.minified() && i < count; ++i)
    {
        const float angle = 6.2831853f * uniform();
        receivers[i].direction = {std::cos(angle), std::sin(angle)};
    }
    judgeAll(scene, kernel, receivers, choice.footprint);
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
