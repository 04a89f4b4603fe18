// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors

/** LVSM_VERSION of the headers: 10000 times the major number, 100 times the minor one, and the patch. */
export const version: number;

/** What lvsm::RelaxOptions is in C++, with the same defaults. splits: those to start from, with keepSplits. */
export interface RelaxOptions {
    maxIterations?: number;
    tolerance?: number;
    minVariance?: number;
    maxVariance?: number;
    splitsPerIteration?: number;
    keepSplits?: boolean;
    maxSamples?: number;
    splits?: Float32Array;
}

/** What lvsm::OptimalOptions is in C++, with the same defaults. splits: the previous ones, with a leastGain. */
export interface OptimalOptions {
    uniformShare?: number;
    minLength?: number;
    leastGain?: number;
    maxSamples?: number;
    splits?: Float32Array;
}

/**
 * Splits for layeredVisibility: lvsm::lloydRelax. depths: width x height of them, row by row, linear, in [0,1].
 * Gives layerCount + 1 splits and what describe() says in C++; throws a RangeError with that where the input makes no
 * sense.
 */
export function lloydRelax(depths: Float32Array, width: number, height: number, layerCount: number,
                           options?: RelaxOptions):
    {splits: Float32Array, message: string, iterations: number, movement: number};

/**
 * Splits for the bracketed functions: lvsm::optimalSplits. depths: width x height of them, row by row, linear, in [0,1].
 * Gives layerCount + 1 splits and what describe() says in C++; throws a RangeError with that where the input makes no
 * sense.
 */
export function optimalSplits(depths: Float32Array, width: number, height: number, layerCount: number,
                              options?: OptimalOptions):
    {splits: Float32Array, message: string, distortion: number};
