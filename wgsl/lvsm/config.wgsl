// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// Settings and constants that every topic shares.

// Version of the library: 10000 times the major number, 100 times the minor one, and the patch.
const LVSM_VERSION: i32 = 100;

// The setting, to change here: most layers that an array of splits can hold; such an array has LVSM_MAX_LAYERS + 1
// elements.
const LVSM_MAX_LAYERS: i32 = 8;

// WGSL has no word that keeps M2 - M1^2, which cancels, from being contracted, nor sums from being reassociated. A flat
// occluder's variance may then be up to 2^-24 M1^2 and not 0, which a minVariance from 2^-24 = 6e-8 on covers, or the
// bias of four moments; without them there may be light right behind the occluder. Sums of values in their documented
// range come out the same, but sums of four that are not may overflow. And a receiver that is a line in the map may have
// any gradient.

// Smallest normal float, 2^-126: GPUs may flush what is smaller, and promise nothing for division by it.
const LVSM_TINY: f32 = 1.17549435e-38;

// 2^-63, the square root of 2^-126: a smaller distance has no normal square.
const LVSM_ROOT_TINY: f32 = 1.08420217e-19;

// 2^126: the largest divisor for which Vulkan promises the precision of a division.
const LVSM_HUGE: f32 = 8.50705917e37;

// Most layers that uniform splits are counted for: far more than any memory holds, and safe to multiply in float.
const LVSM_MAX_UNIFORM_LAYERS: i32 = 65536;
