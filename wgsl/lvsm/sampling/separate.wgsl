// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, sampling/common, sampling/separate/maps, sampling/separate/bracket, convolution, sampling/separate/convolution, filter, esm, sampling/separate/esm, sampling/separate/layers, components, mixture, receiver, sampling/separate/mixture, moments4, sampling/separate/moments4, pcf, sampling/separate/pcf, plane, sampling/separate/plane, quantised, sampling/separate/quantised, trigonometric, sampling/separate/trigonometric, exponential, sampling/separate/variance.
// Reading shadow maps from textures and samplers.
//
// One function a technique: it takes the map, its sampler, the point where to read it and the receiver's depth. A point
// is made by mapPoint, for a map that has slices of an array for itself, such as a cascade, by atlasPoint or cubePoint:
//   let at = lvsm_mapPoint(uv, dpdx(uv), dpdy(uv), 0);
//   let visibility = lvsm_sampleBracketed2(map, filtering, at, depth, 0.5, 0.25 * LVSM_MIN_VARIANCE_FP16);
//
// A map is a texture_2d_array<f32> that the device filters, such as rgba16float, its sampler filters linearly and clamps
// to the edge, and its texture coordinates go from 0 to 1. What is off the map is empty, and so lit: common.wgsl has the
// rule. Maps of codes, of mixtures, are a texture_2d_array<u32> and take no sampler.
//
// WGSL takes derivatives in uniform control flow alone. So the gradients of the coordinates are parameters: take them
// with dpdx and dpdy before any branch; then the wrappers may be called anywhere, and in compute shaders too.
//
// WGSL includes nothing: lvsm_separate.wgsl has all of these files and what they need. For a technique alone, paste its
// file in separate/ and those that its third line names.
