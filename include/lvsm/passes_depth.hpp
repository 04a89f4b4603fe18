// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, filter, passes.
// What the host gives passes that read a depth buffer: how its projected depths become linear ones.
// On the host alone: no shader has it.
#ifndef LVSM_PASSES_DEPTH_HPP
#define LVSM_PASSES_DEPTH_HPP

#include "passes.hpp"

namespace lvsm
{

/// The block lvsm_Depths.
struct DepthBlock
{
    float tangents[4];
    float distances[2];
    float range[2];
    std::int32_t isPerspective;
    std::int32_t unused[3];
};

/// Depths of an orthographic projection, as planeLightDepth has them.
/// nearPlane, farPlane: distances of the projected depths 0 and 1, or 1 and 0 where it is reversed.
/// nearDistance, farDistance: those of the linear depths 0 and 1, near < far.
inline DepthBlock orthographicDepths(float nearPlane, float farPlane, bool reversed, float nearDistance,
                                     float farDistance)
{
    DepthBlock block{};
    block.distances[0] = reversed ? farPlane : nearPlane;
    block.distances[1] = reversed ? nearPlane : farPlane;
    block.range[0] = nearDistance;
    block.range[1] = farDistance;
    return block;
}

/// Depths of a perspective projection, as distances along the view.
/// nearPlane, farPlane: distances of the projected depths 0 and 1, or 1 and 0 where it is reversed, 0 < near < far;
/// farPlane may be infinite. nearDistance, farDistance: those of the linear depths 0 and 1, near < far; the planes
/// themselves give linearDepth and linearDepthReversed.
inline DepthBlock perspectiveDepths(float nearPlane, float farPlane, bool reversed, float nearDistance,
                                    float farDistance)
{
    DepthBlock block = orthographicDepths(1.0f / nearPlane, 1.0f / farPlane, reversed, nearDistance, farDistance);
    block.isPerspective = 1;
    return block;
}

/// Depths of a perspective projection as distances to the light, as pointLightDepth has them: a spot light, or one face
/// of a cube.
/// nearPlane, farPlane, reversed, nearDistance, farDistance: as for perspectiveDepths. tangents: of half the angles of
/// the view, in x and in y; (1, 1) for the face of a cube. map: where the view is in its texture, in texels.
inline DepthBlock pointDepths(float nearPlane, float farPlane, bool reversed, float nearDistance, float farDistance,
                              const glm::vec2& tangents, const Rectangle& map)
{
    DepthBlock block = perspectiveDepths(nearPlane, farPlane, reversed, nearDistance, farDistance);
    const int corner[] = {map.x, map.y};
    const int size[] = {map.width, map.height};
    for (glm::vec2::length_type i = 0; i < 2; ++i)
    {
        const float extent = static_cast<float>(detail::maximum(size[i], 1));
        block.tangents[i] = 2.0f * tangents[i] / extent;
        block.tangents[2 + i] = -tangents[i] * (2.0f * static_cast<float>(corner[i]) / extent + 1.0f);
    }
    return block;
}

} // namespace lvsm

#endif
