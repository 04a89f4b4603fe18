#include "web.hpp"

namespace sampling
{
namespace
{

// By when the splits of the images are at rest.
constexpr int kFrames = 60;

} // namespace

lvsm::PlaceStep Web::step(int frame, bool inPairs, const lvsm::RelaxOptions<float>& options) const
{
    return lvsm::placeStep(kLayers, kMaxLayers, kMap, inPairs ? frame : 0, options);
}

// All frames at once: the client comes to rest by itself.
std::vector<State> Web::drawSteps(const Depths& image, bool inPairs)
{
    lvsm::RelaxOptions<float> options;
    options.splitsPerIteration = inPairs ? 2 : 0;
    const int sumsProgram = pass("step_sums", "lvsm_stepSumsCompute");
    const int mipProgram = pass("mip", "lvsm_mipCompute", {"", {wide("Mip")}});
    const int moveProgram = pass("step_move", "lvsm_stepMoveCompute");
    const int levels = lvsm::levelCount(kMap);
    const int slices = inPairs ? 1 : kLayers / 2;
    const int sums = m_script.texture(Pixels(kMap.width, kMap.height, slices, levels), true);
    const State start = startState(kLayers);
    Pixels first(kStateWidth, 2);
    for (std::size_t i = 0; i < start.size(); ++i)
        first.texels[i / 4][static_cast<int>(i % 4)] = start[i];
    int states[] = {m_script.texture(first, false), m_script.texture(Pixels(kStateWidth, 2), false)};
    const int depths = m_script.texture(image.pixels, false);
    std::vector<State> all;
    for (int frame = 0; frame < (inPairs ? 2 : 1) * kFrames; ++frame)
    {
        const lvsm::PlaceStep now = step(frame, inPairs, options);
        const lvsm::GroupCount groups{(kMap.width + 7) / 8, (kMap.height + 7) / 8, slices};
        m_script.run(sumsProgram, {{"lvsm_depths", 0, depths}, {"lvsm_state", 3, states[0]}}, "lvsm_Step",
                     lvsm::Pass<lvsm::StepBlock>{now.block, groups, now.sums}, {sums}, slices);
        for (int level = 1; level < levels; ++level)
            m_script.run(mipProgram, {{"lvsm_source", 0, sums, level - 1}}, "lvsm_Mip",
                         lvsm::mipPass(now.sums, level, 0, slices), {sums, 0, level}, slices);
        m_script.run(moveProgram, {{"lvsm_sums", 0, sums, levels - 1}, {"lvsm_state", 3, states[0]}},
                     {{"lvsm_Step", 2, &now.block, sizeof now.block}}, {states[1]}, {0, 0, kStateWidth, 2}, {1, 1, 1});
        std::swap(states[0], states[1]);
        const Pixels made = m_script.read(states[0]);
        const float* numbers = &made.texels[0].x;
        all.emplace_back(numbers, numbers + 8 * kStateWidth);
    }
    return all;
}

bool Web::checkSteps(const Depths& image, bool inPairs)
{
    const std::vector<State> states = drawSteps(image, inPairs);
    if (!m_script.isPlayed())
        return true;
    Comparison steps("steps");
    Comparison ends("where steps of all come to rest");
    std::size_t frame = 0;
    const auto draw = [&](const lvsm::PlaceStep&, const Depths&)
    {
        if (frame == states.size())
            throw std::runtime_error("the splits are not at rest when the frames are over");
        return states[frame++];
    };
    compareSteps({image, kLayers, inPairs, false, inPairs ? "in pairs" : "all"}, draw, steps, ends);
    return steps.passed() && (inPairs || ends.passed());
}

} // namespace sampling
