// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, sampling/highp, sampling/common, sampling/combined/maps, sampling/combined/bracket, convolution, sampling/combined/convolution, filter, esm, sampling/combined/esm, sampling/combined/layers, components, mixture, receiver, sampling/combined/mixture, moments4, sampling/combined/moments4, pcf, sampling/combined/pcf, plane, sampling/combined/plane, quantised, sampling/combined/quantised, trigonometric, sampling/combined/trigonometric, exponential, sampling/combined/variance.
// Reading shadow maps from textures that carry their sampler: OpenGL's way, WebGL's, and one of Vulkan's two.
//
// One function a technique: it takes the map, the point where to read it and the receiver's depth. A point is made by
// mapPoint, for a map that has slices of an array for itself, such as a cascade, by atlasPoint or by cubePoint:
//   lvsm_MapPoint at = lvsm_mapPoint(uv, dFdx(uv), dFdy(uv), 0);
//   float visibility = lvsm_sampleBracketed2(map, at, depth, 0.5, 0.25 * LVSM_MIN_VARIANCE_FP16);
//
// A map is filtered linearly, wraps by clamping to its edge, and its texture coordinates go from 0 to 1. What is off
// the map is empty, and so lit: common.glsl has the rule, and highp.glsl the preamble that GLSL ES needs.
//
// A branch on the receiver's layer or position breaks the derivatives that a texture's level comes from. So the
// gradients of the coordinates are parameters: take them with dFdx and dFdy before any branch.
//
// For a technique alone, include its file in combined/. The files in separate/ and in HLSL are made from those:
// tests/sampling/forms.py.
#ifndef LVSM_SAMPLING_COMBINED_GLSL
#define LVSM_SAMPLING_COMBINED_GLSL

#include "combined/bracket.glsl"
#include "combined/convolution.glsl"
#include "combined/esm.glsl"
#include "combined/layers.glsl"
#include "combined/maps.glsl"
#include "combined/mixture.glsl"
#include "combined/moments4.glsl"
#include "combined/pcf.glsl"
#include "combined/plane.glsl"
#include "combined/quantised.glsl"
#include "combined/trigonometric.glsl"
#include "combined/variance.glsl"

#endif
