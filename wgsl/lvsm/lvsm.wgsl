// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: every topic.
// lvsm: the maths of filterable shadow maps, the same in C++, GLSL, HLSL and WGSL.
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
//   names        lvsm::chebyshevUpperBound in C++ is lvsm_chebyshevUpperBound in GLSL, HLSL and WGSL, with the same
//                parameters in the same order. What a function changes in place it takes by pointer: &splits.
//   files        one a topic; WGSL includes nothing. Paste a file and the others that its third line names, in any order,
//                each once; lvsm_all.wgsl has all of them. LVSM_VERSION is the library's version.
//
// Topics: depth, moments, layers, bracket, plane, moments4, quantised, trigonometric, exponential, placement, receiver,
// esm, convolution, pcf, filter, components, mixture. A whole use, after lvsm_all.wgsl:
//
// WGSL
//
//   // Shadow pass, back faces culled: two layers in one texel, rgba16float, cleared to (1, 1, 1, 1). Then blur the map.
//   fn store(depth: f32, split: f32) -> vec4f
//   {
//       return lvsm_packLayers(lvsm_layerMoments(depth, vec2f(0.0, split)), lvsm_layerMoments(depth, vec2f(split, 1.0)));
//   }
//
//   // Lighting: texel is one linear sample of the blurred map. minVariance: 1e-5 for half floats, 1e-6 for fp32.
//   fn visibility(texel: vec4f, depth: f32, split: f32) -> f32
//   {
//       return lvsm_bracketedVisibility2(texel, depth, split, 1.0e-5);
//   }
