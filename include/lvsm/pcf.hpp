// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, filter.
// Percentage-closer filtering: the depth comparison first, the filter after it.
// Reeves, Salesin & Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987.
//
// A filter of N x N texels: start from (0, 0), pcfAdd the texels four at a time with the weights of the filter topic
// (a Gaussian's, or boxWeight of each texel's offset for a box of any width), and end with pcfVisibility. A slanted
// receiver needs a bias for each texel: pass planeDepth of the receiver topic at each, the receiver-plane depth bias.
#ifndef LVSM_PCF_HPP
#define LVSM_PCF_HPP

#include "filter.hpp"

namespace lvsm
{

/// Plain shadow test of one texel.
/// occluder: depth in the map. depth: the receiver's, clamped to [0,1]. bias: what the receiver is moved towards the
/// light, clamped to [-1,1]. Result in [0,1]: 1 where the receiver is not behind the occluder, else 0.
/// Source: Williams, Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978.
template <typename T>
T depthTest(T occluder, T depth, T bias)
{
    return detail::clamp(depth, T(0), T(1)) - detail::clamp(bias, T(-1), T(1)) <= occluder ? T(1) : T(0);
}

namespace detail
{

// The plain test of four texels.
template <typename T, glm::qualifier Q>
glm::vec<4, T, Q> depthTests(const glm::vec<4, T, Q>& depths, const glm::vec<4, T, Q>& receivers, T bias)
{
    return {depthTest(depths.x, receivers.x, bias), depthTest(depths.y, receivers.y, bias),
            depthTest(depths.z, receivers.z, bias), depthTest(depths.w, receivers.w, bias)};
}

template <typename T>
T pcfWeight(T weight)
{
    return clamp(weight, T(0), T(0.0625) * kHuge<T>);
}

} // namespace detail

/// Percentage-closer filtering over 2 x 2 texels, continuous in the receiver's position.
/// depths: of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy. fraction: position between the
/// centres of the first and the last, each component clamped to [0,1].
/// receivers: depth of the receiver at each texel, clamped to [0,1]: one depth for all, or that of its plane.
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result in [0,1].
/// Source: Reeves et al. 1987, with bilinear weights.
template <typename T, glm::qualifier Q>
T pcfBilinear(const glm::vec<4, T, Q>& depths, const glm::vec<2, T, Q>& fraction, const glm::vec<4, T, Q>& receivers,
              T bias)
{
    return bilinearVisibility(detail::depthTests(depths, receivers, bias), fraction);
}

/// Four more texels of a percentage-closer filter of any shape and size.
/// sum: (weight that is lit, weight of all) so far, (0, 0) at first, each clamped to [0, 2^125].
/// depths: of four texels. weights: theirs in the same order, each clamped to [0, 2^122].
/// receivers: depth of the receiver at each texel, clamped to [0,1]: one depth for all, or that of its plane.
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result: both sums, in [0, 2^126].
/// Source: Reeves et al. 1987.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> pcfAdd(const glm::vec<2, T, Q>& sum, const glm::vec<4, T, Q>& depths,
                         const glm::vec<4, T, Q>& weights, const glm::vec<4, T, Q>& receivers, T bias)
{
    const glm::vec<4, T, Q> w(detail::pcfWeight(weights.x), detail::pcfWeight(weights.y),
                              detail::pcfWeight(weights.z), detail::pcfWeight(weights.w));
    const glm::vec<4, T, Q> lit = detail::depthTests(depths, receivers, bias);
    const T limit = T(0.5) * kHuge<T>;
    const auto add = [](T a, T b) { return detail::rounded(a + b); };
    const T newLit = add(add(add(w.x * lit.x, w.y * lit.y), w.z * lit.z), w.w * lit.w);
    return {detail::clamp(sum.x, T(0), limit) + newLit,
            detail::clamp(sum.y, T(0), limit) + add(add(add(w.x, w.y), w.z), w.w)};
}

/// Visibility from the sums of pcfAdd.
/// sum: (weight that is lit, weight of all). Result in [0,1]: their ratio.
/// Degenerate: no weight at all (under 2^-126) is lit.
/// Source: Reeves et al. 1987.
template <typename T, glm::qualifier Q>
T pcfVisibility(const glm::vec<2, T, Q>& sum)
{
    const T all = detail::minimum(kHuge<T>, sum.y);
    if (all < kTiny<T>)
        return T(1);
    return detail::clamp(sum.x / all, T(0), T(1));
}

} // namespace lvsm

#endif
