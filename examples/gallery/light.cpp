#include "light.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/gtc/matrix_transform.hpp>

namespace lvsm::gallery
{
namespace
{

constexpr float kSpotDistance = 12.0f;
constexpr int kCorners = 8;

glm::mat4 lookAlong(glm::vec3 eye, glm::vec3 direction)
{
    return glm::lookAt(eye, eye + direction, {0, 0, -1});
}

// Where the frustum's edges meet the ground: the deepest receivers that the map can see.
std::vector<glm::vec3> groundCorners(const glm::mat4& inverseViewProjection)
{
    std::vector<glm::vec3> corners;
    for (const glm::vec2 edge : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
    {
        const glm::vec4 near = inverseViewProjection * glm::vec4(edge, 0, 1);
        const glm::vec4 far = inverseViewProjection * glm::vec4(edge, 1, 1);
        const glm::vec3 from = glm::vec3(near) / near.w;
        const glm::vec3 to = glm::vec3(far) / far.w;
        if (from.y > 0.0f && to.y < from.y)
            corners.push_back(glm::mix(from, to, from.y / (from.y - to.y)));
    }
    return corners;
}

glm::vec2 distanceRange(const Scene& scene, const glm::mat4& inverseViewProjection,
                        const std::function<float(glm::vec3)>& distance)
{
    glm::vec2 range(distance(scene.focus.corner(0)));
    const auto include = [&](glm::vec3 point)
    {
        range = {std::min(range.x, distance(point)), std::max(range.y, distance(point))};
    };
    for (int i = 0; i < kCorners; ++i)
        include(scene.focus.corner(i));
    for (const glm::vec3 corner : groundCorners(inverseViewProjection))
        include(corner);
    return range;
}

Light makeDirectional(const Scene& scene)
{
    const glm::vec3 direction = scene.lightDirection;
    const float reach = 0.5f * glm::length(scene.focus.high - scene.focus.low);
    const glm::vec3 origin = scene.focus.centre() - direction * reach;
    const glm::mat4 view = lookAlong(origin, direction);
    glm::vec2 low(reach);
    glm::vec2 high(-reach);
    for (int i = 0; i < kCorners; ++i)
    {
        const glm::vec2 corner(view * glm::vec4(scene.focus.corner(i), 1));
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const glm::mat4 viewProjection = glm::ortho(low.x, high.x, low.y, high.y, 0.0f, 4.0f * reach) * view;
    const glm::mat4 inverse = glm::inverse(viewProjection);
    const glm::vec2 range =
        distanceRange(scene, inverse, [&](glm::vec3 point) { return glm::dot(point - origin, direction); });
    return {"directional",
            "directional light",
            {viewProjection, inverse, glm::vec4(origin, 0), glm::vec4(direction, 0), glm::vec4(range, 0, 0)}};
}

Light makeSpot(const Scene& scene)
{
    const glm::vec3 position = scene.focus.centre() - scene.lightDirection * kSpotDistance;
    const glm::mat4 view = lookAlong(position, scene.lightDirection);
    float slope = 0.0f;
    for (int i = 0; i < kCorners; ++i)
    {
        const glm::vec3 corner(view * glm::vec4(scene.focus.corner(i), 1));
        slope = std::max({slope, std::abs(corner.x / corner.z), std::abs(corner.y / corner.z)});
    }
    const glm::mat4 viewProjection = glm::perspective(2.0f * std::atan(slope), 1.0f, 1.0f, 4.0f * kSpotDistance) * view;
    const glm::mat4 inverse = glm::inverse(viewProjection);
    const glm::vec2 range =
        distanceRange(scene, inverse, [&](glm::vec3 point) { return glm::distance(point, position); });
    const float edge = std::cos(std::atan(slope));
    const glm::vec4 rangeAndCone(range, edge, glm::mix(edge, 1.0f, 0.3f));
    return {"spot",
            "spot light",
            {viewProjection, inverse, glm::vec4(position, 1), glm::vec4(scene.lightDirection, 0), rangeAndCone}};
}

} // namespace

glm::vec3 Light::towards(glm::vec3 point) const
{
    return isSpot() ? glm::normalize(glm::vec3(block.position) - point) : -glm::vec3(block.direction);
}

std::vector<Light> makeLights(const Scene& scene)
{
    return {makeSpot(scene), makeDirectional(scene)};
}

} // namespace lvsm::gallery
