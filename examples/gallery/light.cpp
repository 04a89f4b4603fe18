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
constexpr float kSpotNear = 1.0f;
constexpr float kLampNear = 0.05f;
constexpr float kLampReach = 1.6f;
constexpr float kMostBeyond = 1.5f;
// A cube's faces overlap by what the blur and the bilinear filter read beyond their edge.
constexpr int kCubeMargin = 6;

glm::mat4 lookAlong(glm::vec3 eye, glm::vec3 direction)
{
    return glm::lookAt(eye, eye + direction, {0, 0, -1});
}

Face faceOf(const glm::mat4& viewProjection)
{
    const glm::mat4 inverse = glm::inverse(viewProjection);
    const auto far = [&](float x, float y)
    {
        const glm::vec4 point = inverse * glm::vec4(x, y, 1, 1);
        return point / point.w;
    };
    return {viewProjection, far(-1, -1), far(1, -1) - far(-1, -1), far(-1, 1) - far(-1, -1)};
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
            corners.push_back(glm::mix(from, to, std::min(from.y / (from.y - to.y), 1.0f)));
    }
    return corners;
}

glm::vec2 distanceRange(const Scene& scene, const std::vector<glm::vec3>& others,
                        const std::function<float(glm::vec3)>& distance)
{
    glm::vec2 range(distance(scene.focus.corner(0)));
    const auto include = [&](glm::vec3 point)
    {
        range = {std::min(range.x, distance(point)), std::max(range.y, distance(point))};
    };
    for (int i = 0; i < kCorners; ++i)
        include(scene.focus.corner(i));
    // Ground at the horizon would leave what is in focus a sliver of the range.
    const float farthest = kMostBeyond * range.y;
    for (const glm::vec3 corner : others)
        include(corner);
    range.y = std::min(range.y, farthest);
    return range;
}

Rectangle wholeMap(int size)
{
    return {0, 0, size, size};
}

Light makeDirectional(const Scene& scene, int mapSize, glm::vec3 direction)
{
    const float reach = 0.5f * glm::length(scene.focus.high - scene.focus.low);
    const float farPlane = 4.0f * reach;
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
    const glm::mat4 viewProjection = glm::ortho(low.x, high.x, low.y, high.y, 0.0f, farPlane) * view;
    const glm::vec2 range = distanceRange(scene, groundCorners(glm::inverse(viewProjection)),
                                          [&](glm::vec3 point) { return glm::dot(point - origin, direction); });
    LightBlock block{glm::vec4(origin, 0), glm::vec4(direction, 0), glm::vec4(range, 0, 0), {1, 1, farPlane, 0}, {}};
    block.faces[0] = faceOf(viewProjection);
    return {"directional", "directional light", block, mapSize,
            orthographicDepths(0.0f, farPlane, false, range.x, range.y)};
}

Light makeSpot(const Scene& scene, int mapSize)
{
    constexpr float kFar = 4.0f * kSpotDistance;
    const glm::vec3 position = scene.focus.centre() - scene.lightDirection * kSpotDistance;
    const glm::mat4 view = lookAlong(position, scene.lightDirection);
    float slope = 0.0f;
    for (int i = 0; i < kCorners; ++i)
    {
        const glm::vec3 corner(view * glm::vec4(scene.focus.corner(i), 1));
        slope = std::max({slope, std::abs(corner.x / corner.z), std::abs(corner.y / corner.z)});
    }
    const glm::mat4 viewProjection = glm::perspective(2.0f * std::atan(slope), 1.0f, kSpotNear, kFar) * view;
    const glm::vec2 range = distanceRange(scene, groundCorners(glm::inverse(viewProjection)),
                                          [&](glm::vec3 point) { return glm::distance(point, position); });
    const float edge = std::cos(std::atan(slope));
    LightBlock block{glm::vec4(position, 1),
                     glm::vec4(scene.lightDirection, 0),
                     glm::vec4(range, edge, glm::mix(edge, 1.0f, 0.3f)),
                     {1, slope, kFar, 0},
                     {}};
    block.faces[0] = faceOf(viewProjection);
    return {"spot", "spot light", block, mapSize,
            pointDepths(kSpotNear, kFar, false, range.x, range.y, glm::vec2(slope), wholeMap(mapSize))};
}

Light makeLamp(const Scene& scene, int mapSize, glm::vec3 position)
{
    // Axes of each face: to the right, down and away from the light, as the faces of cube textures are turned.
    static const std::array<glm::mat3, kCubeFaces> kAxes{
        glm::mat3({0, 0, -1}, {0, -1, 0}, {1, 0, 0}), glm::mat3({0, 0, 1}, {0, -1, 0}, {-1, 0, 0}),
        glm::mat3({1, 0, 0}, {0, 0, 1}, {0, 1, 0}),   glm::mat3({1, 0, 0}, {0, 0, -1}, {0, -1, 0}),
        glm::mat3({1, 0, 0}, {0, -1, 0}, {0, 0, 1}),  glm::mat3({-1, 0, 0}, {0, -1, 0}, {0, 0, -1})};
    const glm::vec2 around = distanceRange(scene, {}, [&](glm::vec3 point) { return glm::distance(point, position); });
    // All that is in focus has the full light, which fades from there on.
    const float farPlane = around.y * kLampReach;
    const float size = static_cast<float>(mapSize);
    const float tangent = size / (size - 2.0f * kCubeMargin);
    LightBlock block{
        glm::vec4(position, 1), {0, -1, 0, 0}, {0, farPlane, -3, -2}, {kCubeFaces, tangent, farPlane, 0}, {}};
    glm::mat4 projection(0.0f);
    projection[0][0] = projection[1][1] = 1.0f / tangent;
    projection[2][2] = farPlane / (farPlane - kLampNear);
    projection[3][2] = -farPlane * kLampNear / (farPlane - kLampNear);
    projection[2][3] = 1.0f;
    for (std::size_t i = 0; i < kAxes.size(); ++i)
    {
        const glm::mat4 view = glm::mat4(glm::transpose(kAxes[i])) * glm::translate(glm::mat4(1.0f), -position);
        block.faces[i] = faceOf(projection * view);
    }
    return {"point", "point light", block, mapSize,
            pointDepths(kLampNear, farPlane, false, 0.0f, farPlane, glm::vec2(tangent), wholeMap(mapSize))};
}

} // namespace

glm::vec3 Light::towards(glm::vec3 point) const
{
    return isSpot() ? glm::normalize(glm::vec3(block.position) - point) : -glm::vec3(block.direction);
}

float Light::depthOf(glm::vec3 point) const
{
    const glm::vec3 from(block.position);
    const float distance = isSpot() ? glm::distance(point, from) : glm::dot(point - from, glm::vec3(block.direction));
    return (distance - block.range.x) / metresPerDepth();
}

std::vector<Light> makeLights(const Scene& scene, int mapSize, bool all)
{
    std::vector<LightKind> kinds = scene.lights;
    if (all)
        kinds.insert(kinds.end(), scene.furtherLights.begin(), scene.furtherLights.end());
    std::vector<Light> lights;
    for (const LightKind kind : kinds)
    {
        if (kind == LightKind::Spot)
            lights.push_back(makeSpot(scene, mapSize));
        else if (kind == LightKind::Lamp)
            lights.push_back(makeLamp(scene, mapSize / 2, scene.lamp));
        else
            lights.push_back(makeDirectional(scene, mapSize, scene.lightDirection));
    }
    return lights;
}

Light makeTurnedLight(const Scene& scene, int mapSize, float angle)
{
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), angle, {0, 1, 0});
    return makeDirectional(scene, mapSize, glm::vec3(turn * glm::vec4(scene.lightDirection, 0)));
}

} // namespace lvsm::gallery
