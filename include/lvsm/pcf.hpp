// Percentage-closer filtering: the depth comparison first, the filter after it.
// Reeves, Salesin & Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987.
//
// A filter of N x N texels: start from (0, 0), pcfAdd the texels four at a time with the weights of the filter topic
// (a Gaussian's, or boxWeight of each texel's offset for a box of any width), and end with pcfVisibility.
#ifndef LVSM_PCF_HPP
#define LVSM_PCF_HPP

#include "filter.hpp"

#include <glm/vec3.hpp>

namespace lvsm
{

/// Plain shadow test of one texel.
/// occluder: depth in the map. depth: the receiver's, clamped to [0,1]. bias: what the receiver is moved towards the
/// light, clamped to [-1,1]. Result: 1 where the receiver is not behind the occluder, else 0.
/// Source: Williams, Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978.
template <typename T>
T depthTest(T occluder, T depth, T bias)
{
    return detail::clamp(depth, T(0), T(1)) - detail::clamp(bias, T(-1), T(1)) <= occluder ? T(1) : T(0);
}

/// Percentage-closer filtering over 2 x 2 texels, continuous in the receiver's position.
/// depths: of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy. fraction: position between the
/// centres of the first and the last, each component clamped to [0,1]. depth: the receiver's, clamped to [0,1].
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result in [0,1].
/// Source: Reeves et al. 1987, with bilinear weights.
template <typename T, glm::qualifier Q>
T pcfBilinear(const glm::vec<4, T, Q>& depths, const glm::vec<2, T, Q>& fraction, T depth, T bias)
{
    return bilinearVisibility(
        glm::vec<4, T, Q>(depthTest(depths.x, depth, bias), depthTest(depths.y, depth, bias),
                          depthTest(depths.z, depth, bias), depthTest(depths.w, depth, bias)),
        fraction);
}

namespace detail
{

template <typename T>
T pcfWeight(T weight)
{
    return clamp(weight, T(0), T(0.0625) * kHuge<T>);
}

} // namespace detail

/// Four more texels of a percentage-closer filter of any shape and size.
/// sum: (weight that is lit, weight of all) so far, (0, 0) at first, each clamped to [0, 2^125].
/// depths: of four texels. weights: theirs in the same order, each clamped to [0, 2^122].
/// depth: the receiver's, clamped to [0,1].
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result: both sums, in [0, 2^126].
/// Source: Reeves et al. 1987.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> pcfAdd(const glm::vec<2, T, Q>& sum, const glm::vec<4, T, Q>& depths,
                         const glm::vec<4, T, Q>& weights, T depth, T bias)
{
    const glm::vec<4, T, Q> w(detail::pcfWeight(weights.x), detail::pcfWeight(weights.y),
                              detail::pcfWeight(weights.z), detail::pcfWeight(weights.w));
    const T lit = w.x * depthTest(depths.x, depth, bias) + w.y * depthTest(depths.y, depth, bias) +
                  w.z * depthTest(depths.z, depth, bias) + w.w * depthTest(depths.w, depth, bias);
    const T limit = T(0.5) * kHuge<T>;
    return {detail::clamp(sum.x, T(0), limit) + lit, detail::clamp(sum.y, T(0), limit) + (w.x + w.y + w.z + w.w)};
}

/// Visibility from the sums of pcfAdd.
/// sum: (weight that is lit, weight of all). Result in [0,1]: their ratio.
/// Degenerate: no weight at all (under 2^-126) is lit.
/// Source: Reeves et al. 1987.
template <typename T, glm::qualifier Q>
T pcfVisibility(const glm::vec<2, T, Q>& sum)
{
    const T all = detail::min(kHuge<T>, sum.y);
    if (all < kTiny<T>)
        return T(1);
    return detail::clamp(sum.x / all, T(0), T(1));
}

/// Change of the receiver's depth with the map's texture coordinates, from screen derivatives.
/// dx, dy: change of (u, v, depth) to the next pixel in x and in y, each component clamped to [-1e15, 1e15].
/// Result: (d depth / du, d depth / dv), each in [-2^20, 2^20].
/// Degenerate: a receiver seen edge-on from the light (determinant under 2^-126) gives (0, 0).
/// Source: Isidoro, Shadow Mapping: GPU-based Tips and Techniques, GDC 2006; the chain rule solved for the gradient.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> receiverPlaneGradient(const glm::vec<3, T, Q>& dx, const glm::vec<3, T, Q>& dy)
{
    using std::abs;
    const auto bounded = [](T x) { return detail::clamp(x, T(-1.0e15), T(1.0e15)); };
    const glm::vec<3, T, Q> a(bounded(dx.x), bounded(dx.y), bounded(dx.z));
    const glm::vec<3, T, Q> b(bounded(dy.x), bounded(dy.y), bounded(dy.z));
    const T determinant = a.x * b.y - a.y * b.x;
    const T size = abs(determinant);
    if (size < kTiny<T>)
        return {T(0), T(0)};
    const T steepest = T(1048576.0);
    const T limit = steepest * size;
    const T alongU = detail::clamp(a.z * b.y - a.y * b.z, -limit, limit);
    const T alongV = detail::clamp(a.x * b.z - a.z * b.x, -limit, limit);
    return {detail::clamp(alongU / determinant, -steepest, steepest),
            detail::clamp(alongV / determinant, -steepest, steepest)};
}

/// Change of the receiver's depth from its own position in the map to a texel: what to add to depth for that tap.
/// gradient: of receiverPlaneGradient. offset: from the receiver's texture coordinates to the texel's centre.
/// Components of either are clamped to [-2^20, 2^20]. Result in [-1,1].
/// Source: Isidoro 2006, the receiver's plane extrapolated.
template <typename T, glm::qualifier Q>
T receiverPlaneBias(const glm::vec<2, T, Q>& gradient, const glm::vec<2, T, Q>& offset)
{
    const auto bounded = [](T x) { return detail::clamp(x, T(-1048576.0), T(1048576.0)); };
    const T change = bounded(gradient.x) * bounded(offset.x) + bounded(gradient.y) * bounded(offset.y);
    return detail::clamp(change, T(-1), T(1));
}

} // namespace lvsm

#endif
