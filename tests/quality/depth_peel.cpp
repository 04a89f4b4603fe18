#include "depth_peel.hpp"

#include <algorithm>
#include <cmath>

namespace lvsm::quality
{
namespace
{

/// A triangle on the map, with the plane that its depths lie on.
class Projected
{
public:
    Projected(const Triangle& triangle, const Light& light) : m_light(light), m_twoSided(triangle.twoSided)
    {
        for (int i = 0; i < 3; ++i)
            m_points[i] = light.texel(triangle.corners[i]);
        m_corner = triangle.corners[0];
        m_normal = glm::cross(glm::dvec3(triangle.corners[1]) - m_corner, glm::dvec3(triangle.corners[2]) - m_corner);
        const double area = glm::length(m_normal);
        m_empty = !(area > 0.0);
        if (!m_empty)
            m_normal /= area;
        m_orientation = cross(m_points[0], m_points[1], m_points[2]) < 0.0 ? -1.0 : 1.0;
    }

    bool empty() const { return m_empty; }
    glm::dvec2 low() const { return glm::min(m_points[0], glm::min(m_points[1], m_points[2])); }
    glm::dvec2 high() const { return glm::max(m_points[0], glm::max(m_points[1], m_points[2])); }

    /// Of two triangles that share an edge, one covers each point on it.
    bool covers(glm::dvec2 p) const
    {
        for (int i = 0; i < 3; ++i)
        {
            const glm::dvec2 a = m_points[i];
            const glm::dvec2 b = m_points[(i + 1) % 3];
            const bool swapped =
                a.x > b.x || (a.x == b.x && a.y > b.y); // the same arithmetic from both sides of the edge
            const double side = m_orientation * (swapped ? -cross(b, a, p) : cross(a, b, p));
            const bool owned = swapped == (m_orientation > 0.0);
            if (side < 0.0 || (side == 0.0 && !owned))
                return false;
        }
        return true;
    }

    /// The surface at the centre of a texel.
    Surface at(int x, int y) const
    {
        const double cx = x + 0.5;
        const double cy = y + 0.5;
        const Light::Ray ray = m_light.ray(cx, cy);
        const double cosine = -glm::dot(m_normal, glm::normalize(ray.direction));
        const glm::dvec2 gradient(depth(cx + 0.5, cy) - depth(cx - 0.5, cy), depth(cx, cy + 0.5) - depth(cx, cy - 0.5));
        return {static_cast<float>(depth(cx, cy)), glm::clamp(glm::vec2(gradient), -1.0f, 1.0f),
                static_cast<float>(m_twoSided ? std::abs(cosine) : cosine)};
    }

private:
    static double cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p)
    {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }

    /// Depth of the triangle's plane, which goes on beyond its edges.
    double depth(double x, double y) const
    {
        const Light::Ray ray = m_light.ray(x, y);
        const double slope = glm::dot(m_normal, ray.direction);
        const double least = 1e-9 * glm::length(ray.direction);
        const double along = glm::dot(m_normal, m_corner - ray.origin) / (std::abs(slope) < least ? least : slope);
        return m_light.depth(ray.origin + along * ray.direction);
    }

    const Light& m_light;
    bool m_twoSided;
    bool m_empty;
    glm::dvec2 m_points[3];
    glm::dvec3 m_corner;
    glm::dvec3 m_normal;
    double m_orientation;
};

} // namespace

Peel depthPeel(const Mesh& mesh, const Light& light, int size)
{
    std::vector<std::vector<Surface>> texels(texelIndex(0, size, size));
    for (const Triangle& triangle : mesh)
    {
        const Projected projected(triangle, light);
        if (projected.empty())
            continue;
        const glm::ivec2 low = glm::max(glm::ivec2(glm::ceil(projected.low() - 0.5)), 0);
        const glm::ivec2 high = glm::min(glm::ivec2(glm::floor(projected.high() - 0.5)), size - 1);
        for (int y = low.y; y <= high.y; ++y)
        {
            for (int x = low.x; x <= high.x; ++x)
            {
                if (projected.covers({x + 0.5, y + 0.5}))
                    texels[texelIndex(x, y, size)].push_back(projected.at(x, y));
            }
        }
    }
    return Peel(size, std::move(texels));
}

} // namespace lvsm::quality
