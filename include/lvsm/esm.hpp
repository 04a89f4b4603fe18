// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, filter.
// Exponential shadow maps: the depth test as e^(-c d) e^(c z), which filters linearly in its second factor.
// Annen, Mertens, Seidel, Flerackers & Kautz, Exponential Shadow Maps, Graphics Interface 2008.
//
// Either store occluderTerm, filter it linearly, and judge with exponentialShadow: c is bound by the format. Or store
// the depth itself, filter with logAdd and logFiltered, and judge with logShadow: stable for any c.
#ifndef LVSM_ESM_HPP
#define LVSM_ESM_HPP

#include "filter.hpp"

namespace lvsm
{

// Largest c for which both factors are normal floats: 126 ln 2 = 87.33654, less 4e-5 for the error of exp,
// 3 + 2 |x| units in the last place. 80, which the paper uses in fp32, leaves room for a sum of 6141 samples.
template <typename T>
constexpr T kMaxTermExponent = T(87.3365);

/// Largest c whose occluder terms a storage format can hold and a filter can sum.
/// largest: the format's largest finite value, see kLargest constants; less than 1 counts as 1.
/// headRoom: how often an unnormalised filter sum holds its largest sample, >= 1 (1 for weights that sum to 1). Each
/// rounding to fp16 on the way needs 1/2048 more of it.
/// Result in [0, 87.3365]: 11.09 for fp16 and 87.3365 for fp32 without head room. Rounding by a share of the term (at
/// most 2^-11 in fp16, 2^-24 in fp32) changes visibility by the same share.
/// Source: headRoom e^c <= largest, solved for c; ESM section 3.1.
template <typename T>
T maxTermExponent(T largest, T headRoom)
{
    using glm::log;
    const T ratio = detail::maximum(T(1), largest) / detail::clamp(headRoom, T(1), kHuge<T>);
    return detail::clamp(log(detail::maximum(T(1), ratio)), T(0), kMaxTermExponent<T>);
}

/// Occluder term to store for one depth: e^(c z).
/// depth: in [0,1], clamped to it. exponent: c, clamped to [0, 87.3365]. Result in [1, 8.6e37], rising with depth.
/// A texel without any surface stores depth 1.
/// Source: ESM equation 3.
template <typename T>
T occluderTerm(T depth, T exponent)
{
    using glm::exp;
    return detail::maximum(T(1),
                       exp(detail::clamp(exponent, T(0), kMaxTermExponent<T>) * detail::clamp(depth, T(0), T(1))));
}

namespace detail
{

// The receiver's factor, e^(-c d).
template <typename T>
T receiverTerm(T depth, T exponent)
{
    using glm::exp;
    return exp(-clamp(exponent, T(0), kMaxTermExponent<T>) * clamp(depth, T(0), T(1)));
}

} // namespace detail

/// Visibility of a receiver from the filtered occluder term, clamped to 1.
/// occluder: as occluderTerm made it, filtered. depth: the receiver's, in [0,1], clamped to it. exponent: c as when
/// stored, clamped to [0, 87.3365]. Result in [0,1]. Not a bound: it darkens too little near an occluder, and where the
/// window holds depths beyond the receiver, see violatesThreshold and violatesZMax.
/// Source: ESM equation 4 and section 3.2.
template <typename T>
T exponentialShadow(T occluder, T depth, T exponent)
{
    return detail::clamp(detail::receiverTerm(depth, exponent) * occluder, T(0), T(1));
}

/// Whether the window must hold depths beyond the receiver, so that exponentialShadow is wrong: the cheap test.
/// occluder: the filtered occluder term. depth: the receiver's, in [0,1], clamped to it. exponent: c as when stored,
/// clamped to [0, 87.3365]. threshold: the accepted excess over 1, >= 0, less counts as 0; the paper shows 0.02.
/// Result: true where the unclamped shadow exceeds 1 + threshold. It can miss: only the filtered value is seen.
/// Source: ESM section 3.3, threshold classification.
template <typename T>
bool violatesThreshold(T occluder, T depth, T exponent, T threshold)
{
    return detail::receiverTerm(depth, exponent) * occluder > T(1) + detail::maximum(T(0), threshold);
}

/// Whether the window holds depths beyond the receiver, so that exponentialShadow is wrong: the conservative test.
/// depth: the receiver's. zMax: the greatest depth in the window, of a map made with maxDepth. offset: added to depth
/// so that a lit surface is not flagged by itself, >= 0; the paper shows 0.001. All clamped to [0,1].
/// Result: true where depth + offset < zMax.
/// Source: ESM section 3.3, Z-Max classification.
template <typename T>
bool violatesZMax(T depth, T zMax, T offset)
{
    return detail::clamp(depth, T(0), T(1)) + detail::clamp(offset, T(0), T(1)) < detail::clamp(zMax, T(0), T(1));
}

/// The greatest of four depths: one step of the max filter and of the mip chain that violatesZMax reads.
/// depths: each clamped to [0,1]. Result in [0,1].
/// Source: ESM section 3.3.
template <typename T, glm::qualifier Q>
T maxDepth(const glm::vec<4, T, Q>& depths)
{
    const T greatest = detail::maximum(detail::maximum(depths.x, depths.y), detail::maximum(depths.z, depths.w));
    return detail::clamp(greatest, T(0), T(1));
}

/// Visibility where exponentialShadow fails: four texels judged apart, then interpolated.
/// occluders: unfiltered terms of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy.
/// fraction: position between the centres of the first and the last, each component clamped to [0,1].
/// depth: the receiver's, in [0,1], clamped to it. exponent: c as when stored, clamped to [0, 87.3365].
/// Result in [0,1].
/// Source: ESM section 3.3, the custom filter.
template <typename T, glm::qualifier Q>
T exponentialShadow2x2(const glm::vec<4, T, Q>& occluders, const glm::vec<2, T, Q>& fraction, T depth, T exponent)
{
    const T receiver = detail::receiverTerm(depth, exponent);
    return bilinearVisibility(glm::vec<4, T, Q>(receiver * occluders.x, receiver * occluders.y,
                                                receiver * occluders.z, receiver * occluders.w),
                              fraction);
}

/// One more sample of a filter over occluder terms that are never formed: only their logarithms, the depths, are.
/// sum: (greatest depth, sum of weights relative to its term) so far, (0, 0) at first; clamped to [0,1] and [0, 2^125].
/// depth: the sample, or what logFiltered gave in an earlier pass, clamped to [0,1]. weight: of the sample, clamped to
/// [0, 2^125]. exponent: c, clamped to [1, 2^126]. Result: the new sum, in [0,1] and [0, 2^126].
/// Source: the sum of ESM equation 4 with its largest term taken out.
template <typename T, glm::qualifier Q>
glm::vec<2, T, Q> logAdd(const glm::vec<2, T, Q>& sum, T depth, T weight, T exponent)
{
    using glm::exp;
    const T c = detail::clamp(exponent, T(1), kHuge<T>);
    const T z = detail::clamp(depth, T(0), T(1));
    const T before = detail::clamp(sum.x, T(0), T(1));
    const T greatest = detail::maximum(before, z);
    const T kept = detail::clamp(sum.y, T(0), T(0.5) * kHuge<T>) * exp(c * (before - greatest));
    return {greatest, kept + detail::clamp(weight, T(0), T(0.5) * kHuge<T>) * exp(c * (z - greatest))};
}

/// The filtered value of a log-space filter: the depth whose occluder term is the filtered one.
/// sum: as logAdd left it, after weights that add up to 1. exponent: c, clamped to [1, 2^126].
/// Result in [0,1]: ln(sum of weight e^(c depth)) / c, between the least and the greatest depth.
/// Degenerate: no samples give 0.
/// Source: ESM equation 4, its logarithm divided by c.
template <typename T, glm::qualifier Q>
T logFiltered(const glm::vec<2, T, Q>& sum, T exponent)
{
    using glm::log;
    const T c = detail::clamp(exponent, T(1), kHuge<T>);
    return detail::clamp(detail::clamp(sum.x, T(0), T(1)) + log(detail::clamp(sum.y, kTiny<T>, kHuge<T>)) / c, T(0),
                         T(1));
}

/// Visibility of a receiver from a value filtered in log space: exponentialShadow for any c.
/// filtered: as logFiltered gave it, clamped to [0,1]. depth: the receiver's, in [0,1], clamped to it.
/// exponent: c, clamped to [1, 2^126]. Result in [0,1]: 1 where filtered is at depth or farther.
/// Source: ESM equation 4 and section 3.2.
template <typename T>
T logShadow(T filtered, T depth, T exponent)
{
    using glm::exp;
    const T difference = detail::clamp(filtered, T(0), T(1)) - detail::clamp(depth, T(0), T(1));
    return detail::clamp(exp(detail::clamp(exponent, T(1), kHuge<T>) * detail::minimum(T(0), difference)), T(0), T(1));
}

} // namespace lvsm

#endif
