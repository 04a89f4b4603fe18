// Percentage-closer filtering, and what no storage can beat: the map's own depths, all of them.
#include <cmath>

#include <lvsm/pcf.hpp>

#include "filter.hpp"
#include "techniques.hpp"
#include "truth.hpp"

namespace lvsm::quality
{
namespace
{

class Depths : public Estimator
{
public:
    void store(const Surface& nearest, float* texel) const override { texel[0] = nearest.depth; }

protected:
    static float depthAt(const Query& q, int dx, int dy) { return q.image.texel(q.x + dx, q.y + dy)[0]; }
    /// The receiver's plane at the centre of another texel.
    static float planeAt(const Query& q, int dx, int dy)
    {
        return q.depth + glm::dot(q.gradient, glm::vec2(dx, dy) - q.offset);
    }
    static float litAt(const Query& q, int dx, int dy)
    {
        return depthTest(depthAt(q, dx, dy), planeAt(q, dx, dy), kSameDepth);
    }
    /// 2 x 2 depth tests mixed as hardware does, so many texels away.
    static float bilinear(const Query& q, glm::vec2 away)
    {
        const glm::vec2 at = q.offset + away;
        const glm::vec2 low = glm::floor(at);
        const glm::vec2 f = at - low;
        const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
        return glm::mix(glm::mix(litAt(q, x, y), litAt(q, x + 1, y), f.x),
                        glm::mix(litAt(q, x, y + 1), litAt(q, x + 1, y + 1), f.x), f.y);
    }
};

/// The share of the window that is not in front of the receiver's depth, or of its plane.
class WholeWindow : public Depths
{
public:
    WholeWindow(const std::vector<double>& kernel, const Footprint& footprint, bool plane)
        : m_kernel(kernel), m_footprint(footprint), m_plane(plane)
    {
    }

    float visibility(const Query& q) const override
    {
        const PlacedWindow window(m_kernel, q.offset, m_footprint, q.direction);
        double lit = 0.0;
        for (int dy = window.first(); dy <= window.last(); ++dy)
        {
            for (int dx = window.first(); dx <= window.last(); ++dx)
            {
                const double weight = window.weight(dx, dy);
                const float own = m_plane ? planeAt(q, dx, dy) : q.depth;
                if (weight > 0.0)
                    lit += weight * static_cast<double>(depthTest(depthAt(q, dx, dy), own, kSameDepth));
            }
        }
        return static_cast<float>(lit);
    }

private:
    std::vector<double> m_kernel;
    Footprint m_footprint;
    bool m_plane;
};

/// Bilinear depth tests in a square, each weighing the same.
class Box : public Depths
{
public:
    explicit Box(int width) : m_width(width) {}
    float visibility(const Query& q) const override
    {
        float sum = 0.0f;
        const float middle = 0.5f * static_cast<float>(m_width - 1);
        for (int i = 0; i < m_width * m_width; ++i)
        {
            const glm::vec2 away(static_cast<float>(i % m_width), static_cast<float>(i / m_width));
            sum += bilinear(q, away - middle);
        }
        return sum / static_cast<float>(m_width * m_width);
    }

private:
    int m_width;
};

/// Bilinear depth tests at sixteen places of a disc of the filter's deviation, or of an ellipse where the footprint adds
/// its own, turned by a hash of the receiver's place.
class Disc : public Depths
{
public:
    explicit Disc(const Map& map)
    {
        const float filter = static_cast<float>(deviationOf(map.window.kernel()));
        const auto reach = [&](float breadth)
        {
            return 2.0f * std::sqrt(filter * filter + (map.footprint.minified() ? breadth * breadth / 12.0f : 0.0f));
        };
        m_reach = {reach(static_cast<float>(map.footprint.length)), reach(map.footprint.across())};
    }
    float visibility(const Query& q) const override
    {
        constexpr int kSamples = 16;
        constexpr float kGoldenAngle = 2.3999632f;
        const glm::vec2 place(static_cast<float>(q.x) + q.offset.x, static_cast<float>(q.y) + q.offset.y);
        const float turn =
            6.2831853f * glm::fract(52.9829189f * glm::fract(0.06711056f * place.x + 0.00583715f * place.y));
        float sum = 0.0f;
        for (int i = 0; i < kSamples; ++i)
        {
            const float angle = turn + kGoldenAngle * static_cast<float>(i);
            const float radius = std::sqrt((static_cast<float>(i) + 0.5f) / kSamples);
            const glm::vec2 p = radius * m_reach * glm::vec2(std::cos(angle), std::sin(angle));
            sum += bilinear(q, p.x * q.direction + p.y * glm::vec2(-q.direction.y, q.direction.x));
        }
        return sum / kSamples;
    }

private:
    glm::vec2 m_reach;
};

Technique depths(const std::string& name, bool peer, const std::string& estimate, Prepare prepare)
{
    Technique technique{name, peer, peer ? 32 : 0, 1, Format::Fp32, false, std::move(prepare), estimate};
    technique.reading = Reading::Window;
    return technique;
}

Prepare whole(bool plane)
{
    return [plane](const Map& map)
    {
        return std::make_unique<WholeWindow>(map.window.kernel(), map.footprint, plane);
    };
}

/// The whole window's ends weigh next to nothing, and whoever pays for it by the texel leaves them out.
Technique cutWindow(double deviations, const std::string& name)
{
    Technique technique =
        depths("PCF, window cut at " + name, true, "PCF whole window",
               [deviations](const Map& map)
               { return std::make_unique<WholeWindow>(map.window.cut(deviations), map.footprint, true); });
    technique.cut = deviations;
    return technique;
}

} // namespace

std::vector<Technique> pcfPeers()
{
    return {depths("PCF, whole window", true, "PCF whole window", whole(true)),
            cutWindow(2.0, "2 deviations"),
            cutWindow(1.5, "1.5 deviations"),
            depths("PCF, 16 turned samples", true, "PCF 16 turned samples",
                   [](const Map& map) { return std::make_unique<Disc>(map); }),
            depths("PCF, 3 x 3", true, "PCF 3x3", fixed<Box>(3)),
            depths("PCF, 2 x 2", true, "PCF 2x2", fixed<Box>(1))};
}

std::vector<Technique> limits()
{
    return {depths("limit: exact distribution", false, "", whole(false)),
            depths("limit: exact, receiver's plane", false, "", whole(true))};
}

} // namespace lvsm::quality
