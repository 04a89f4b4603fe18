#include "placing_truth.hpp"
#include "web.hpp"

#include <cstring>

namespace sampling
{
namespace
{

std::vector<float> splitsOf(const std::vector<std::uint32_t>& words)
{
    lvsm::StoreBlock block{};
    if (words.size() * sizeof(std::uint32_t) != sizeof block)
        throw std::runtime_error("a block of another size");
    std::memcpy(&block, words.data(), sizeof block);
    return {block.splits, block.splits + kPlacedLayers + 1};
}

} // namespace

bool Web::checkPlacing()
{
    // WebGL has no pass that places splits at once: passes/step does, a step a frame.
    if (!m_script.isWgsl())
        return true;
    bool passed = true;
    for (const Placing& placing : fewPlacings())
    {
        Settings settings;
        if (placing.isProjected)
            settings.lines = {{"    return value;", "    return lvsm_convertedDepth(value, texel);"}};
        const int counting = pass("place", "lvsm_histogramCompute", settings);
        const int placer = pass("place", "lvsm_placeCompute");
        const lvsm::PlacePass made = placing.pass();
        const std::vector<char> zeros(made.histogramBytes, 0);
        const int histogram = m_script.buffer(zeros.data(), zeros.size());
        const lvsm::StoreBlock first = placedBlock(placing.layerCount);
        const int store = m_script.buffer(&first, sizeof first);
        const lvsm::DepthBlock depths = placedDepths();
        const WebScript::Block block{"lvsm_Place", 2, &made.block, sizeof made.block};
        std::vector<WebScript::Block> blocks{block};
        if (placing.isProjected)
            blocks.push_back({"lvsm_Depths", 4, &depths, sizeof depths});
        std::vector<std::vector<float>> splits;
        for (const Depths& image : placing.images)
        {
            const int texture = m_script.texture(image.pixels, false);
            m_script.dispatch(counting, {{"lvsm_depths", 0, texture}}, blocks, {{1, histogram}}, made.groups);
            m_script.dispatch(placer, {}, {block}, {{1, histogram}, {3, store}}, {1, 1, 1});
            splits.push_back(splitsOf(m_script.readBuffer(store)));
        }
        const std::vector<std::uint32_t> left = m_script.readBuffer(histogram);
        passed = !m_script.isPlayed() || (comparePlacing(placing, splits, left) && passed);
    }
    return passed;
}

} // namespace sampling
