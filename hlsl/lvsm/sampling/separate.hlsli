// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, sampling/common, sampling/separate/maps, sampling/separate/bracket, convolution, sampling/separate/convolution, filter, esm, sampling/separate/esm, sampling/separate/layers, components, mixture, receiver, sampling/separate/mixture, moments4, sampling/separate/moments4, pcf, sampling/separate/pcf, plane, sampling/separate/plane, quantised, sampling/separate/quantised, trigonometric, sampling/separate/trigonometric, exponential, sampling/separate/variance.
// Reading shadow maps from textures and samplers.
//
// One function a technique: it takes the map, the point where to read it and the receiver's depth. A point is made by
// mapPoint, for a map that has slices of an array for itself, such as a cascade, by atlasPoint or by cubePoint:
//   lvsm_MapPoint at = lvsm_mapPoint(uv, ddx(uv), ddy(uv), 0);
//   float visibility = lvsm_sampleBracketed2(map, filtering, at, depth, 0.5, 0.25 * LVSM_MIN_VARIANCE_FP16);
//
// A map is filtered linearly, wraps by clamping to its edge, and its texture coordinates go from 0 to 1. What is off
// the map is empty, and so lit: common.hlsli has the rule. A map may be a texture of float, float2 or float4, as each
// function says.
//
// A branch on the receiver's layer or position breaks the derivatives that a texture's level comes from. So the
// gradients of the coordinates are parameters: take them with ddx and ddy before any branch.
//
// For a technique alone, include its file in separate/.
#ifndef LVSM_SAMPLING_SEPARATE_HLSLI
#define LVSM_SAMPLING_SEPARATE_HLSLI

#include "separate/bracket.hlsli"
#include "separate/convolution.hlsli"
#include "separate/esm.hlsli"
#include "separate/layers.hlsli"
#include "separate/maps.hlsli"
#include "separate/mixture.hlsli"
#include "separate/moments4.hlsli"
#include "separate/pcf.hlsli"
#include "separate/plane.hlsli"
#include "separate/quantised.hlsli"
#include "separate/trigonometric.hlsli"
#include "separate/variance.hlsli"

#endif
