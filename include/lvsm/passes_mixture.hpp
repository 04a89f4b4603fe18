// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: GLM, config, filter, passes.
// What the host gives passes/mixture, which makes a map of mixtures from depths: the windows that it knows, its block,
// and what to run.
//
// A window is made in rounds, each of which mixes three texels a step apart, along x and then along y; the outer two get
// a share each, 1/4 at most. By width, mixtureWindow, all shares are 1/4. The last step is half of what the window reaches,
// rounded up, the one before half of what is left, and so on; but none is above 5, past which weights would rise again away
// from the middle. Steps are then 1, 2 and 4 where the width is 3, 7 or 15, and the window is a triangle. For other widths
// it is nearly one, somewhat narrower: weights that fall from the middle outwards, over exactly so many texels. By
// deviation, gaussianMixtureWindow, steps are 1, 2 and 4, and the last share is as small as it takes.
//
// One dispatch holds two rounds in 12.25 KiB of shared memory; more do not fit in the 16 KiB that Vulkan promises. Two
// rounds are 7 texels, or 14 of the depths at half resolution. A wider window takes one dispatch more for each round, and
// between them lie components, packed to 128 bits, as slices of a texture rgba32ui: two or four.
// On the host alone: no shader has it.
#ifndef LVSM_PASSES_MIXTURE_HPP
#define LVSM_PASSES_MIXTURE_HPP

#include "passes.hpp"

#include <cmath>

namespace lvsm
{

// Widest window, in texels of the map of mixtures, and the most rounds that a window has.
constexpr int kMaxMixtureWidth = 25;
constexpr int kMaxMixtureRounds = 4;

// Texels to each side that two rounds in one dispatch reach, and texels in the shared memory of a group, in x and in y.
constexpr int kMaxMixtureHalo = 3;
constexpr int kMixtureTile = 14;

/// A window of mixtures: its rounds, from the first, each a step in texels of the map and a share; how many texels of the
/// depths are one of the map along each axis; and its deviation along each axis in texels of the depths.
struct MixtureWindow
{
    int rounds;
    int steps[kMaxMixtureRounds];
    float shares[kMaxMixtureRounds];
    int texels;
    float deviation;
};

/// The block lvsm_Mixing.
struct MixingBlock
{
    std::int32_t map[4];
    std::int32_t region[4];
    std::int32_t origins[4];
    std::int32_t steps[2];
    std::int32_t spacing;
    std::int32_t texels;
    float deviation;
    std::int32_t slice;
    float shares[2];
};

/// What makes a map of mixtures: so many passes, in their order. The first reads depths, the last writes codes; between
/// them are mixtures, in textures of at least between.width x between.height texels.
struct MixturePasses
{
    Pass<MixingBlock> passes[2 * kMaxMixtureRounds];
    int count;
    Rectangle between;
    float deviation;
};

namespace detail
{

inline void addRound(MixtureWindow& window, int step, float share)
{
    window.steps[window.rounds] = step;
    window.shares[window.rounds++] = share;
}

// Two texels of the depths have the variance 1/4, and a step s with shares of w adds 2 w s^2.
inline MixtureWindow withDeviation(MixtureWindow window)
{
    float variance = 0.0f;
    for (int i = 0; i < window.rounds; ++i)
        variance += 2.0f * window.shares[i] * static_cast<float>(window.steps[i] * window.steps[i]);
    window.deviation = std::sqrt(window.texels > 1 ? 4.0f * variance + 0.25f : variance);
    return window;
}

} // namespace detail

/// The rounds that make a window of a width.
/// width: of the window in texels of the map of mixtures, odd, from 1 to 25; an even one is made odd by one less. half:
/// whether a texel of the map is one of 2 x 2 texels of the depths, whose window is twice as wide.
/// Result: deviation is what encodeMixture2 and 4 and the wrappers take.
/// Source: a step s with shares 1/4 adds the variance s^2 / 2; two texels of the depths have the variance 1/4.
inline MixtureWindow mixtureWindow(int width, bool half = false)
{
    int steps[kMaxMixtureRounds] = {};
    int rounds = 0;
    int left = (detail::clamp(width, 1, kMaxMixtureWidth) - 1) / 2;
    while (left > 0)
    {
        steps[rounds] = detail::minimum((left + 1) / 2, 5);
        left -= steps[rounds++];
    }
    MixtureWindow window{};
    window.texels = half ? 2 : 1;
    while (rounds > 0)
        detail::addRound(window, steps[--rounds], 0.25f);
    return detail::withDeviation(window);
}

/// The rounds that make a window of a deviation, as few as it takes: what is as wide as another technique's filter.
/// deviation: along each axis in texels of the depths, from 0 to 3.24, at half resolution from 0.5 to 6.5, clamped to it; a
/// binomial filter of n taps has sqrt(n - 1) / 2. half: as mixtureWindow takes it.
/// Result: a window of that variance to within 1/256, with weights that fall from the middle outwards.
/// Source: a step s with shares of w adds the variance 2 w s^2; the rounds before make a triangle as wide as the last step.
inline MixtureWindow gaussianMixtureWindow(float deviation, bool half = false)
{
    MixtureWindow window{};
    window.texels = half ? 2 : 1;
    const float wanted = detail::clamp(deviation, 0.0f, 8.0f);
    float left = half ? 0.25f * (wanted * wanted - 0.25f) : wanted * wanted;
    // What a rounding of the deviation leaves is worth no round.
    for (int step = 1; step <= 4 && left > 1.0f / 1024.0f; step *= 2)
    {
        const float most = 0.5f * static_cast<float>(step * step);
        detail::addRound(window, step, 0.25f * detail::minimum(left / most, 1.0f));
        left -= most;
    }
    return detail::withDeviation(window);
}

namespace detail
{

// One pass of a window: its steps and shares, and how far it reads in x and in y where it reads mixtures.
struct MixtureStage
{
    int steps[2];
    float shares[2];
    int spacing;
    int reach[2];
};

inline Rectangle grown(const Rectangle& r, int x, int y)
{
    return {r.x - x, r.y - y, r.width + 2 * x, r.height + 2 * y};
}

inline MixturePasses mixtureStages(const MixtureStage (&stages)[2 * kMaxMixtureRounds], int count,
                                   const MixtureWindow& window, const Rectangle& map, const Rectangle& region,
                                   int slice)
{
    const int texels = window.texels;
    const Rectangle inside = intersection(map, region);
    const bool isEmpty = inside.width == 0 || inside.height == 0;
    const int right = (inside.x + inside.width + texels - 1) / texels;
    const int bottom = (inside.y + inside.height + texels - 1) / texels;
    const Rectangle coded{inside.x / texels, inside.y / texels, isEmpty ? 0 : right - inside.x / texels,
                          isEmpty ? 0 : bottom - inside.y / texels};

    MixturePasses made{};
    made.count = count;
    made.deviation = window.deviation;
    Rectangle writes[2 * kMaxMixtureRounds] = {};
    writes[count - 1] = coded;
    for (int i = count - 1; i > 0; --i)
        writes[i - 1] = isEmpty ? coded : grown(writes[i], stages[i].reach[0], stages[i].reach[1]);
    const Rectangle& whole = writes[0];
    made.between = count > 1 ? Rectangle{0, 0, whole.width, whole.height} : Rectangle{};
    for (int i = 0; i < count; ++i)
    {
        const MixtureStage& stage = stages[i];
        const bool isLast = i + 1 == count;
        const Rectangle& written = writes[i];
        Pass<MixingBlock>& pass = made.passes[i];
        storeEnds(pass.block.map, map);
        storeEnds(pass.block.region, written);
        pass.block.origins[0] = i > 0 ? whole.x : 0;
        pass.block.origins[1] = i > 0 ? whole.y : 0;
        pass.block.origins[2] = isLast ? 0 : whole.x;
        pass.block.origins[3] = isLast ? 0 : whole.y;
        pass.block.steps[0] = stage.steps[0];
        pass.block.steps[1] = stage.steps[1];
        pass.block.spacing = stage.spacing;
        pass.block.texels = texels;
        pass.block.deviation = window.deviation;
        pass.block.slice = isLast ? slice : 0;
        pass.block.shares[0] = stage.shares[0];
        pass.block.shares[1] = stage.shares[1];
        // A group has texels that are the spacing apart.
        const int span = kPassGroupSize * stage.spacing;
        pass.groups = {(written.width + span - 1) / span * stage.spacing,
                       (written.height + span - 1) / span * stage.spacing, 1};
        pass.region = {written.x - pass.block.origins[2], written.y - pass.block.origins[3], written.width,
                       written.height};
    }
    return made;
}

} // namespace detail

/// The dispatches that make a map of mixtures from depths, by a window of any rounds.
/// window: of mixtureWindow or gaussianMixtureWindow. map: where the map is in the texture of depths, in its texels; at half
/// resolution x and y are even. region: what of it is to be made, in texels of the depths; what is off the map is left
/// out. A change of the depths by a rectangle changes that of the map by half the window's width on every side. slice: of
/// the target.
/// Result: one pass for two rounds, and one for each round more: for windows to 7 texels one, to 15 two, to 25 three. What a
/// texel of the depths has at (x, y) the codes have there, or at half resolution at (x / 2, y / 2).
inline MixturePasses mixturePassesOf(const MixtureWindow& window, const Rectangle& map, const Rectangle& region,
                                   int slice = 0)
{
    detail::MixtureStage stages[2 * kMaxMixtureRounds] = {
        {{window.steps[0], window.steps[1]}, {window.shares[0], window.shares[1]}, 1, {}}};
    int count = 1;
    for (int round = 2; round < window.rounds; ++round)
    {
        const int step = window.steps[round];
        stages[count++] = {{1}, {window.shares[round]}, step, {step, step}};
    }
    return detail::mixtureStages(stages, count, window, map, region, slice);
}

/// The dispatches that make a map of mixtures from depths.
/// width, half: as mixtureWindow takes them. map, region, slice: as mixturePassesOf takes them.
/// Result: its, for the window of that width.
inline MixturePasses mixturePasses(int width, bool half, const Rectangle& map, const Rectangle& region, int slice = 0)
{
    return mixturePassesOf(mixtureWindow(width, half), map, region, slice);
}

/// The draws that make a map of mixtures from depths, where there is no compute shader, by a window of any rounds: two for
/// each round.
/// window, map, region, slice: as mixturePassesOf takes them.
/// Result: each draws over its region of its target. A target of mixtures is two or four textures or slices, all drawn at
/// once.
inline MixturePasses mixtureDrawsOf(const MixtureWindow& window, const Rectangle& map, const Rectangle& region,
                                  int slice = 0)
{
    detail::MixtureStage stages[2 * kMaxMixtureRounds] = {{{}, {}, 1, {}}};
    for (int i = 0; i < 2 * window.rounds; ++i)
    {
        const int step = window.steps[i / 2];
        const bool down = i % 2 == 1;
        stages[i] = {{down ? 0 : step, down ? step : 0},
                     {window.shares[i / 2]},
                     1,
                     {down ? 0 : step, down ? step : 0}};
    }
    return detail::mixtureStages(stages, detail::maximum(2 * window.rounds, 1), window, map, region, slice);
}

/// The draws that make a map of mixtures from depths, where there is no compute shader.
/// width, half: as mixtureWindow takes them. map, region, slice: as mixturePassesOf takes them.
/// Result: mixtureDrawsOf for the window of that width.
inline MixturePasses mixtureDraws(int width, bool half, const Rectangle& map, const Rectangle& region, int slice = 0)
{
    return mixtureDrawsOf(mixtureWindow(width, half), map, region, slice);
}

} // namespace lvsm

#endif
