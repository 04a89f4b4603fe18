// Least and greatest depths around a place: who is in front of all of them, or behind, needs no filter.
#include <algorithm>
#include <cmath>

#include "certain.hpp"

namespace lvsm::quality
{
namespace
{

/// A window of (2 reach + 1)^2 texels, in parts that are judged against the receiver's plane over each.
class Range : public Estimator
{
public:
    Range(int reach, Image ranges) : m_reach(static_cast<float>(reach)), m_ranges(std::move(ranges)) {}
    void store(const Surface& nearest, float* texel) const override { texel[0] = nearest.depth; }
    float visibility(const Query& q) const override { return judge(q).y ? 0.0f : 1.0f; }
    float least(const Query& q) const override { return judge(q).x ? 1.0f : 0.0f; }

protected:
    struct Part
    {
        glm::ivec2 texel; ///< of ranges
        glm::vec2 low, high;
    };
    /// Parts of the window: where their ranges are, and how far from the receiver they reach, in texels.
    virtual std::vector<Part> parts(glm::vec2 place) const = 0;

    float m_reach;

private:
    /// Whether it is in front of all, and whether behind all.
    glm::bvec2 judge(const Query& q) const
    {
        glm::bvec2 sure(true);
        for (const Part& part : parts(glm::vec2(q.x, q.y) + q.offset))
        {
            const glm::ivec2 texel = glm::clamp(part.texel, 0, m_ranges.size() - 1);
            const float* range = m_ranges.texel(texel.x, texel.y);
            const float plane = q.depth + glm::dot(q.gradient, 0.5f * (part.low + part.high));
            const float spread = glm::dot(glm::abs(q.gradient), 0.5f * (part.high - part.low));
            sure.x = sure.x && range[0] >= plane + spread - kSameDepth;
            sure.y = sure.y && range[1] < plane - spread;
        }
        return sure;
    }

    Image m_ranges;
};

/// A few fetches from a map where each texel has the range of all that are so near.
class WidenedRange : public Range
{
public:
    WidenedRange(const Peel& peel, int reach, int across)
        : Range(reach, widened(peel, radius(reach, across))), m_across(across),
          m_radius(static_cast<float>(radius(reach, across)))
    {
    }

private:
    static float width(float reach, int across) { return (2.0f * reach + 1.0f) / static_cast<float>(across); }
    static int radius(int reach, int across)
    {
        return static_cast<int>(std::ceil(0.5f * (width(static_cast<float>(reach), across) - 1.0f)));
    }

    static Image widened(const Peel& peel, int radius)
    {
        const int last = peel.size() - 1;
        Image image(peel.size(), 2);
        for (int i = 0; i < peel.size() * peel.size(); ++i)
        {
            const int x = i % peel.size(), y = i / peel.size();
            image.texel(x, y)[0] = image.texel(x, y)[1] = peel.nearest(x, y).depth;
        }
        for (const glm::ivec2 along : {glm::ivec2(1, 0), glm::ivec2(0, 1)})
        {
            const Image from = image;
            for (int i = 0; i < peel.size() * peel.size(); ++i)
            {
                const glm::ivec2 at(i % peel.size(), i / peel.size());
                float* range = image.texel(at.x, at.y);
                for (int step = -radius; step <= radius; ++step)
                {
                    const glm::ivec2 other = glm::clamp(at + step * along, 0, last);
                    range[0] = std::min(range[0], from.texel(other.x, other.y)[0]);
                    range[1] = std::max(range[1], from.texel(other.x, other.y)[1]);
                }
            }
        }
        return image;
    }

    std::vector<Part> parts(glm::vec2 place) const override
    {
        std::vector<Part> found;
        for (int i = 0; i < m_across * m_across; ++i)
        {
            const glm::vec2 away = glm::vec2(i % m_across, i / m_across) - 0.5f * static_cast<float>(m_across - 1);
            const glm::vec2 centre = glm::floor(place + width(m_reach, m_across) * away + 0.5f);
            found.push_back({glm::ivec2(centre), centre - place - m_radius, centre - place + m_radius});
        }
        return found;
    }

    int m_across;
    float m_radius;
};

/// The texels of a level of a pyramid that the window meets.
class PyramidRange : public Range
{
public:
    PyramidRange(const Peel& peel, int reach, int level)
        : Range(reach, blocks(peel, 1 << level)), m_block(static_cast<float>(1 << level))
    {
    }

private:
    static Image blocks(const Peel& peel, int block)
    {
        Image image(peel.size() / block, 2);
        for (int i = 0; i < image.size() * image.size(); ++i)
        {
            float* range = image.texel(i % image.size(), i / image.size());
            range[0] = 1.0f;
            for (int k = 0; k < block * block; ++k)
            {
                const float depth =
                    peel.nearest(block * (i % image.size()) + k % block, block * (i / image.size()) + k / block).depth;
                range[0] = std::min(range[0], depth);
                range[1] = std::max(range[1], depth);
            }
        }
        return image;
    }

    std::vector<Part> parts(glm::vec2 place) const override
    {
        std::vector<Part> found;
        const glm::ivec2 first(glm::floor((place - m_reach + 0.5f) / m_block));
        const glm::ivec2 last(glm::floor((place + m_reach + 0.5f) / m_block));
        for (int y = first.y; y <= last.y; ++y)
        {
            for (int x = first.x; x <= last.x; ++x)
            {
                const glm::vec2 low = m_block * glm::vec2(x, y) - place;
                found.push_back({{x, y}, glm::max(low, -m_reach), glm::min(low + (m_block - 1.0f), m_reach)});
            }
        }
        return found;
    }

    float m_block;
};

Technique ranges(const std::string& name, int fetches, Prepare prepare)
{
    Technique technique{
        name, true, 64, 1, Format::Fp32, false, std::move(prepare), "ranges of " + std::to_string(fetches)};
    technique.reading = Reading::Window;
    return technique;
}

} // namespace

std::vector<Technique> widenedRanges(const Window& window)
{
    std::vector<Technique> found;
    for (int reach = 1; reach <= static_cast<int>(window.cut(2.5).size()) / 2; ++reach)
    {
        for (const int across : {1, 2, 3})
        {
            found.push_back(
                ranges(std::to_string(across * across) + " fetches, reach " + std::to_string(reach), across * across,
                       [=](const Map& map) { return std::make_unique<WidenedRange>(map.peel, reach, across); }));
        }
    }
    return found;
}

std::vector<Technique> pyramidRanges(const Window& window)
{
    std::vector<Technique> found;
    for (int reach = 1; reach <= static_cast<int>(window.cut(2.5).size()) / 2; ++reach)
    {
        for (const int level : {1, 2, 3})
        {
            // So many blocks that a window of any place may meet.
            const int across = (2 * reach + 1 + (1 << level) - 2) / (1 << level) + 1;
            if (across <= 3)
                found.push_back(
                    ranges("level " + std::to_string(level) + ", reach " + std::to_string(reach), across * across,
                           [=](const Map& map) { return std::make_unique<PyramidRange>(map.peel, reach, level); }));
        }
    }
    return found;
}

} // namespace lvsm::quality
