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
    : spot_(spot), origin_(origin), right_(glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)))),
      up_(glm::cross(right_, forward)), forward_(forward), low_(1e30), nearDistance_(1e30), farDistance_(-1e30)
{
    glm::dvec2 high(-1e30);
    for (const Triangle& triangle : mesh)
    {
        for (const glm::vec3& corner : triangle.corners)
        {
            const glm::dvec3 p = local(corner);
            low_ = glm::min(low_, glm::dvec2(p));
            high = glm::max(high, glm::dvec2(p));
            nearDistance_ = std::min(nearDistance_, distance(corner));
            farDistance_ = std::max(farDistance_, distance(corner));
        }
    }
    const glm::dvec2 border = kBorder * (high - low_);
    low_ -= border;
    high += border;
    const double margin = kBorder * (farDistance_ - nearDistance_);
    nearDistance_ -= margin;
    farDistance_ += margin;
    texelsPerUnit_ = static_cast<double>(size) / (high - low_);
}

glm::dvec3 Light::local(glm::dvec3 point) const
{
    const glm::dvec3 from = point - origin_;
    const double along = glm::dot(from, forward_);
    const glm::dvec2 across(glm::dot(from, right_), glm::dot(from, up_));
    return {spot_ ? across / along : across, along};
}

double Light::distance(glm::dvec3 point) const
{
    return spot_ ? glm::length(point - origin_) : glm::dot(point - origin_, forward_);
}

Light::Ray Light::ray(double x, double y) const
{
    const glm::dvec2 across = low_ + glm::dvec2(x, y) / texelsPerUnit_;
    const glm::dvec3 offset = across.x * right_ + across.y * up_;
    return spot_ ? Ray{origin_, forward_ + offset} : Ray{origin_ + offset, forward_};
}

glm::dvec2 Light::texel(glm::dvec3 point) const
{
    return (glm::dvec2(local(point)) - low_) * texelsPerUnit_;
}

double Light::depth(glm::dvec3 point) const
{
    return spot_ ? pointLightDepth(point, origin_, nearDistance_, farDistance_)
                 : planeLightDepth(point, origin_, forward_, nearDistance_, farDistance_);
}

} // namespace lvsm::quality
