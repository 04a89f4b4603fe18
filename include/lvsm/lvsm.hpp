// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: every topic.
// lvsm: the maths of filterable shadow maps, the same in C++, GLSL and HLSL.
//
// Conventions, relied on everywhere
//   depth        linear in light space, in [0,1]: 0 at the light, larger is farther. Distance to the light point or
//                plane, normalised. Not the projected z; linearDepth converts that.
//   visibility   in [0,1]: 1 lit, 0 in shadow.
//   moments      (M1, M2), means of a depth and of its square over a filter window, filtered linearly. Their space is
//                depth itself or a warp of it; the function says which. Filter moments.
//   empty texel  a texel without any surface holds depth 1: clear to depthMoments(1), layerMoments(1, interval),
//                depthMoments4(1), layerMoments4(1, interval), exponentialMoments(1, exponents) or
//                occluderTerm(1, exponent).
//   layers       counted from 0 at the light. N layers have N + 1 splits, splits[0] = 0 and splits[N] = 1, not
//                decreasing. Two neighbouring layers share a texel of four components.
//   minVariance  floor of the variance, in depth squared, unwarped; the functions carry it into each warp.
//   totality     any finite arguments give a finite result in the stated range; arguments outside their range are
//                clamped, and what is degenerate is said. Shaders promise nothing for NaN and infinity, since GPUs need
//                not keep them; in C++ results keep to their ranges for these too.
//   names        lvsm::chebyshevUpperBound in C++ is lvsm_chebyshevUpperBound in GLSL and HLSL, with the same
//                parameters in the same order.
//   files        one a topic. A file's third line names the others that it needs, in the order in which to paste them,
//                without their #include lines, where there is no #include. LVSM_VERSION is the library's version.
//   GLSL ES      3.00 or later. A shader says precision highp float; and precision highp int; before this file.
//
// Topics: depth, moments, layers, bracket, plane, moments4, quantised, trigonometric, exponential, placement, receiver,
// esm, convolution, pcf, filter, components, mixture; on the host also lloyd, optimal, passes, passes_depth,
// passes_fused, passes_mip, passes_mixture, passes_place and passes_step. A whole use, in each language:
//
// C++
//
//   #include <lvsm/lvsm.hpp>
//
//   // The split of two layers for this light, from its depth image.
//   float splits[3];
//   const auto placed = lvsm::optimalSplits(depths.data(), width, height, splits, 2);
//   if (!placed)
//       std::fprintf(stderr, "splits: %s\n", lvsm::describe(placed.status));
//
//   // One receiver, judged as the shader does.
//   const float visibility = lvsm::bracketedVisibility2(filteredTexel(0), depth, splits[1], 1.0e-5f);
//
// GLSL
//
//   #include "lvsm/lvsm.glsl"
//
//   // Shadow pass, back faces culled: two layers in one texel, rgba16f, cleared to (1, 1, 1, 1). Then blur the map.
//   vec4 store(float depth, float split)
//   {
//       return lvsm_packLayers(lvsm_layerMoments(depth, vec2(0.0, split)), lvsm_layerMoments(depth, vec2(split, 1.0)));
//   }
//
//   // Lighting: texel is one linear sample of the blurred map. minVariance: 1e-5 for half floats, 1e-6 for fp32.
//   float visibility(vec4 texel, float depth, float split)
//   {
//       return lvsm_bracketedVisibility2(texel, depth, split, 1.0e-5);
//   }
//
// HLSL
//
//   #include "lvsm/lvsm.hlsli"
//
//   // Shadow pass, back faces culled: two layers in one texel, rgba16f, cleared to (1, 1, 1, 1). Then blur the map.
//   float4 store(float depth, float split)
//   {
//       return lvsm_packLayers(lvsm_layerMoments(depth, float2(0.0, split)),
//                              lvsm_layerMoments(depth, float2(split, 1.0)));
//   }
//
//   // Lighting: texel is one linear sample of the blurred map. minVariance: 1e-5 for half floats, 1e-6 for fp32.
//   float visibility(float4 texel, float depth, float split)
//   {
//       return lvsm_bracketedVisibility2(texel, depth, split, 1.0e-5);
//   }
#ifndef LVSM_LVSM_HPP
#define LVSM_LVSM_HPP

#include "bracket.hpp"
#include "components.hpp"
#include "convolution.hpp"
#include "depth.hpp"
#include "esm.hpp"
#include "exponential.hpp"
#include "filter.hpp"
#include "layers.hpp"
#include "lloyd.hpp"
#include "mixture.hpp"
#include "moments.hpp"
#include "moments4.hpp"
#include "optimal.hpp"
#include "passes.hpp"
#include "passes_depth.hpp"
#include "passes_fused.hpp"
#include "passes_mip.hpp"
#include "passes_mixture.hpp"
#include "passes_place.hpp"
#include "passes_step.hpp"
#include "pcf.hpp"
#include "placement.hpp"
#include "plane.hpp"
#include "quantised.hpp"
#include "receiver.hpp"
#include "runs.hpp"
#include "trigonometric.hpp"

#endif
