// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config.
// Which texels of an image the host functions read: all, or runs spread evenly over it.
// On the host alone: no shader has it.
#ifndef LVSM_RUNS_HPP
#define LVSM_RUNS_HPP

#include "config.hpp"

#include <cstddef>

namespace lvsm
{
namespace detail
{

// Most texels of a run: they lie side by side in a row.
constexpr int kRun = 64;

// Calls visit(x, y, count) for runs of texels. Of more texels than maxSamples one run of several is taken, at a place
// among them that moves by the golden ratio, so that no pattern of the image is missed; 0 or less takes all.
template <typename Visit>
void forEachRun(int width, int height, int maxSamples, const Visit& visit)
{
    const std::ptrdiff_t runsOfRow = (static_cast<std::ptrdiff_t>(width) + kRun - 1) / kRun;
    const std::ptrdiff_t runs = runsOfRow * height;
    const std::ptrdiff_t stride = maxSamples > 0 ? max<std::ptrdiff_t>(1, runs * kRun / maxSamples) : 1;
    double place = 0.0;
    for (std::ptrdiff_t first = 0; first < runs; first += stride)
    {
        place += 0.6180339887498949;
        place -= place >= 1.0 ? 1.0 : 0.0;
        const auto offset = static_cast<std::ptrdiff_t>(place * static_cast<double>(stride));
        const std::ptrdiff_t run = min(first + offset, runs - 1);
        const int x = static_cast<int>(run % runsOfRow) * kRun;
        visit(x, static_cast<int>(run / runsOfRow), min(kRun, width - x));
    }
}

} // namespace detail
} // namespace lvsm

#endif
