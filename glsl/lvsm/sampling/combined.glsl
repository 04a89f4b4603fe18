// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, filter, esm, sampling/highp, sampling/common, sampling/combined/maps, sampling/combined/esm, depth, moments, layers, sampling/combined/layers, pcf, receiver, sampling/combined/pcf.
// Reading shadow maps from textures that carry their sampler: OpenGL's way, WebGL's, and one of Vulkan's two.
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

#include "combined/esm.glsl"
#include "combined/layers.glsl"
#include "combined/maps.glsl"
#include "combined/pcf.glsl"

#endif
