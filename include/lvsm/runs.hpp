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

// Calls visit(x, y, count) for runs of texels. Of more texels than maxSamples only so many runs are taken as hold about
// that: one of several, at a place among them that moves by the golden ratio, so that no pattern of the image is
// missed. 0 or less takes all.
template <typename Visit>
void forEachRun(int width, int height, int maxSamples, const Visit& visit)
{
    const std::ptrdiff_t runsOfRow = (static_cast<std::ptrdiff_t>(width) + kRun - 1) / kRun;
    const std::ptrdiff_t runs = runsOfRow * height;
    // The last run of a row is short, and in a narrow image all are.
    const double wanted = maximum(1.0, static_cast<double>(maxSamples) * static_cast<double>(runsOfRow) / width);
    const bool takesAll = maxSamples <= 0 || wanted >= static_cast<double>(runs);
    const std::ptrdiff_t visits = takesAll ? runs : static_cast<std::ptrdiff_t>(wanted);
    const double step = static_cast<double>(runs) / static_cast<double>(visits);
    double place = 0.0;
    std::ptrdiff_t first = 0;
    for (std::ptrdiff_t i = 1; i <= visits; ++i)
    {
        place += 0.6180339887498949;
        place -= place >= 1.0 ? 1.0 : 0.0;
        const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(static_cast<double>(i) * step);
        const std::ptrdiff_t run = first + static_cast<std::ptrdiff_t>(place * static_cast<double>(end - first));
        const int x = static_cast<int>(run % runsOfRow) * kRun;
        visit(x, static_cast<int>(run / runsOfRow), minimum(kRun, width - x));
        first = end;
    }
}

} // namespace detail
} // namespace lvsm

#endif
