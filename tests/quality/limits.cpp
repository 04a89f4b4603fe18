// What no storage can beat: the map's own depths, all of them.
#include <lvsm/pcf.hpp>

#include "techniques.hpp"
#include "truth.hpp"

namespace lvsm::quality
{
namespace
{

/// The share of the window that is not in front of the receiver's depth, or of its plane.
class Exact : public Estimator
{
public:
    Exact(const std::vector<double>& kernel, bool plane) : m_kernel(kernel), m_plane(plane) {}

    void store(const Surface& nearest, float* texel) const override { texel[0] = nearest.depth; }

    float visibility(const Query& q) const override
    {
        const int radius = static_cast<int>(m_kernel.size()) / 2;
        double lit = 0.0;
        for (int dy = -radius; dy <= radius; ++dy)
        {
            for (int dx = -radius; dx <= radius; ++dx)
            {
                const float own = q.depth + (m_plane ? glm::dot(q.gradient, glm::vec2(dx, dy)) : 0.0f);
                const double weight =
                    m_kernel[static_cast<std::size_t>(dx + radius)] * m_kernel[static_cast<std::size_t>(dy + radius)];
                lit += weight * static_cast<double>(depthTest(q.image.texel(q.x + dx, q.y + dy)[0], own, kSameDepth));
            }
        }
        return static_cast<float>(lit);
    }

private:
    std::vector<double> m_kernel;
    bool m_plane;
};

} // namespace

std::vector<Technique> limits()
{
    const auto exact = [](bool plane)
    {
        return [plane](const Map& map)
        {
            return std::make_unique<Exact>(map.kernel, plane);
        };
    };
    return {{"limit: exact distribution", false, 0, 1, Format::Fp32, false, exact(false)},
            {"limit: exact, receiver's plane", false, 0, 1, Format::Fp32, false, exact(true)}};
}

} // namespace lvsm::quality
