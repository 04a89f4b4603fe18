// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// Settings and constants that every topic shares.
#ifndef LVSM_CONFIG_GLSL
#define LVSM_CONFIG_GLSL

// Version of the library: 10000 times the major number, 100 times the minor one, and the patch.
#define LVSM_VERSION 100

// Settings. Define any of them before the first include.

// Most layers that an array of splits can hold; such an array has LVSM_MAX_LAYERS + 1 elements.
#ifndef LVSM_MAX_LAYERS
#define LVSM_MAX_LAYERS 8
#endif

// Keeps M2 - M1^2, which cancels, and sums that could overflow from being reassociated or contracted. A client may
// define it empty: sums of values in their documented range come out the same. It is empty where GLSL has no word for
// it, before 4.00 and ES 3.20. A flat occluder's variance may then be up to 2^-24 M1^2 and not 0, which a minVariance
// from 2^-24 = 6e-8 on covers, or the bias of four moments; without them there may be light right behind the occluder.
// And a receiver that is a line in the map may have any gradient.
#ifndef LVSM_PRECISE
#if defined(GL_ES)
#if __VERSION__ >= 320
#define LVSM_PRECISE precise
#else
#define LVSM_PRECISE
#endif
#elif __VERSION__ >= 400
#define LVSM_PRECISE precise
#else
#define LVSM_PRECISE
#endif
#endif

// Smallest normal float, 2^-126: GPUs may flush what is smaller, and promise nothing for division by it.
const float LVSM_TINY = 1.17549435e-38;

// 2^-63, the square root of 2^-126: a smaller distance has no normal square.
const float LVSM_ROOT_TINY = 1.08420217e-19;

// 2^126: the largest divisor for which Vulkan promises the precision of a division.
const float LVSM_HUGE = 8.50705917e37;

// Most layers that uniform splits are counted for: far more than any memory holds, and safe to multiply in float.
const int LVSM_MAX_UNIFORM_LAYERS = 65536;

#endif
