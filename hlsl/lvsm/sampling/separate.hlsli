// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, esm, sampling/common, sampling/separate/maps, sampling/separate/esm, depth, moments, layers, sampling/separate/layers, pcf, receiver, sampling/separate/pcf.
// Reading shadow maps from textures and samplers.
//
// A map is filtered linearly, wraps by clamping to its edge, and its texture coordinates go from 0 to 1. What is off
// the map is empty, and so lit: common.hlsli has the rule. A map may be a Texture2D of float, float2 or float4, as each
// function says.
//
// A branch on the receiver's layer or position breaks the derivatives that a texture's level comes from. So the
// gradients of the coordinates are parameters: take them with ddx and ddy before any branch.
//
// For a technique alone, include its file in separate/.
#ifndef LVSM_SAMPLING_SEPARATE_HLSLI
#define LVSM_SAMPLING_SEPARATE_HLSLI

#include "separate/esm.hlsli"
#include "separate/layers.hlsli"
#include "separate/maps.hlsli"
#include "separate/pcf.hlsli"

#endif
