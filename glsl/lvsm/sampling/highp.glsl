// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// What the wrappers and passes ask of GLSL: 3.30 or ES 3.00, and in ES highp.
//
// ES fragment shaders do not compute in highp by themselves, and the maths cannot ask for it; its constants do not exist
// in mediump. In front of the first include of lvsm, write
//   precision highp float;
//   precision highp int;
// and where the rest of the shader is to be mediump, say so again after it. Declare the maps as highp samplers.
#ifndef LVSM_SAMPLING_HIGHP_GLSL
#define LVSM_SAMPLING_HIGHP_GLSL

// In front of samplers, which ES reads in lowp or cannot declare without a precision. Empty elsewhere: there a fragment
// shader with one such word draws a warning for all that has none.
#ifdef GL_ES
#define LVSM_HIGHP highp
#if __VERSION__ < 300
#error lvsm needs GLSL ES 3.00
#elif !defined(GL_FRAGMENT_PRECISION_HIGH)
#error lvsm needs highp
#endif
#else
#define LVSM_HIGHP
#if __VERSION__ < 330
#error lvsm needs GLSL 3.30
#endif
#endif

#endif
