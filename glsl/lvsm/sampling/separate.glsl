// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, layers, bracket, sampling/highp, sampling/common, sampling/separate/maps, sampling/separate/bracket, convolution, sampling/separate/convolution, filter, esm, sampling/separate/esm, sampling/separate/layers, components, mixture, receiver, sampling/separate/mixture, moments4, sampling/separate/moments4, pcf, sampling/separate/pcf, plane, sampling/separate/plane, quantised, sampling/separate/quantised, trigonometric, sampling/separate/trigonometric, exponential, sampling/separate/variance.
// Reading shadow maps from textures and samplers apart: Vulkan's other way. A shader may have both.
//
// Everything is as in combined.glsl, but that a sampler, filtering, follows the map.
#ifndef LVSM_SAMPLING_SEPARATE_GLSL
#define LVSM_SAMPLING_SEPARATE_GLSL

#include "separate/bracket.glsl"
#include "separate/convolution.glsl"
#include "separate/esm.glsl"
#include "separate/layers.glsl"
#include "separate/maps.glsl"
#include "separate/mixture.glsl"
#include "separate/moments4.glsl"
#include "separate/pcf.glsl"
#include "separate/plane.glsl"
#include "separate/quantised.glsl"
#include "separate/trigonometric.glsl"
#include "separate/variance.glsl"

#endif
