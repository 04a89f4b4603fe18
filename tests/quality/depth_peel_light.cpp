#include <algorithm>

#include <lvsm/depth.hpp>

#include "depth_peel.hpp"

namespace lvsm::quality
{
namespace
{

constexpr double kSpotDistance = 1.6; // in radii of the mesh's bounds, from its centre
constexpr double kBorder = 0.02;      // of the map's width and depth, left free on each side

glm::dvec3 towardsLight(float elevation, float azimuth)
{
    const double e = glm::radians(static_cast<double>(elevation));
    const double a = glm::radians(static_cast<double>(azimuth));
    return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

struct Bounds
{
    glm::dvec3 low{1e30}, high{-1e30};
    explicit Bounds(const Mesh& mesh)
    {
        for (const Triangle& triangle : mesh)
        {
            for (const glm::vec3& corner : triangle.corners)
            {
                low = glm::min(low, glm::dvec3(corner));
                high = glm::max(high, glm::dvec3(corner));
            }
        }
    }
    glm::dvec3 centre() const { return 0.5 * (low + high); }
    double radius() const { return 0.5 * glm::length(high - low); }
};

} // namespace

Light Light::directional(const Mesh& mesh, float elevation, float azimuth, int size)
{
    const glm::dvec3 towards = towardsLight(elevation, azimuth);
    return {mesh, false, Bounds(mesh).centre(), -towards, size};
}

Light Light::spot(const Mesh& mesh, float elevation, float azimuth, int size)
{
    const glm::dvec3 towards = towardsLight(elevation, azimuth);
    const Bounds bounds(mesh);
    return {mesh, true, bounds.centre() + towards * (kSpotDistance * bounds.radius()), -towards, size};
}

Light::Light(const Mesh& mesh, bool spot, glm::dvec3 origin, glm::dvec3 forward, int size)
    : m_spot(spot), m_origin(origin), m_right(glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)))),
      m_up(glm::cross(m_right, forward)), m_forward(forward), m_low(1e30), m_nearDistance(1e30), m_farDistance(-1e30)
{
    glm::dvec2 high(-1e30);
    for (const Triangle& triangle : mesh)
    {
        for (const glm::vec3& corner : triangle.corners)
        {
            const glm::dvec3 p = local(corner);
            m_low = glm::min(m_low, glm::dvec2(p));
            high = glm::max(high, glm::dvec2(p));
            m_nearDistance = std::min(m_nearDistance, distance(corner));
            m_farDistance = std::max(m_farDistance, distance(corner));
        }
    }
    const glm::dvec2 border = kBorder * (high - m_low);
    m_low -= border;
    high += border;
    const double margin = kBorder * (m_farDistance - m_nearDistance);
    m_nearDistance -= margin;
    m_farDistance += margin;
    m_texelsPerUnit = static_cast<double>(size) / (high - m_low);
}

glm::dvec3 Light::local(glm::dvec3 point) const
{
    const glm::dvec3 from = point - m_origin;
    const double along = glm::dot(from, m_forward);
    const glm::dvec2 across(glm::dot(from, m_right), glm::dot(from, m_up));
    return {m_spot ? across / along : across, along};
}

double Light::distance(glm::dvec3 point) const
{
    return m_spot ? glm::length(point - m_origin) : glm::dot(point - m_origin, m_forward);
}

Light::Ray Light::ray(double x, double y) const
{
    const glm::dvec2 across = m_low + glm::dvec2(x, y) / m_texelsPerUnit;
    const glm::dvec3 offset = across.x * m_right + across.y * m_up;
    return m_spot ? Ray{m_origin, m_forward + offset} : Ray{m_origin + offset, m_forward};
}

Light Light::moved(glm::dvec2 texels) const
{
    Light light = *this;
    light.m_low += texels / m_texelsPerUnit;
    return light;
}

glm::dvec3 Light::point(glm::dvec2 place, double depth) const
{
    const Ray from = ray(place.x, place.y);
    const double away = glm::mix(m_nearDistance, m_farDistance, depth);
    return from.origin + away * glm::normalize(from.direction);
}

glm::dvec2 Light::texel(glm::dvec3 point) const
{
    return (glm::dvec2(local(point)) - m_low) * m_texelsPerUnit;
}

double Light::depth(glm::dvec3 point) const
{
    return m_spot ? pointLightDepth(point, m_origin, m_nearDistance, m_farDistance)
                  : planeLightDepth(point, m_origin, m_forward, m_nearDistance, m_farDistance);
}

} // namespace lvsm::quality
