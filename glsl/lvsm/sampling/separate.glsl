// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, esm, sampling/highp, sampling/common, sampling/separate/maps, sampling/separate/esm, depth, moments, layers, sampling/separate/layers, pcf, receiver, sampling/separate/pcf.
// Reading shadow maps from textures and samplers apart: Vulkan's other way. A shader may have both.
//
// Everything is as in combined.glsl, but that a sampler, filtering, follows the map.
#ifndef LVSM_SAMPLING_SEPARATE_GLSL
#define LVSM_SAMPLING_SEPARATE_GLSL

#include "separate/esm.glsl"
#include "separate/layers.glsl"
#include "separate/maps.glsl"
#include "separate/pcf.glsl"

#endif
