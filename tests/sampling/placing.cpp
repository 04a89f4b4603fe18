// The splits placed on the device, against the host's, for still images and while a light moves.
#include "placing_images.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace sampling
{
namespace
{

using lvsm::PlacePass;

constexpr double kTolerance = 1.0 / 4096;
constexpr int kMaxLayers = 8;

// The splits begin where the shaders have them.
static_assert(offsetof(lvsm::StoreBlock, splits) == 8 * sizeof(float));

// What the device keeps from frame to frame.
class Placer
{
public:
    Placer(VulkanContext& context, const Form& form, int layerCount, bool projected = false)
        : m_context(context), m_form(form), m_projected(projected),
          m_histogram(makeBufferOf(context, std::vector<std::uint32_t>(1024 * (4 + kMaxLayers), 0))),
          m_store(makeBufferOf(context, std::vector{storeBlock(layerCount)})), m_sampler(makeSampler(context)),
          m_source(makeBufferOf(context, std::vector{lvsm::perspectiveDepths(1, kFar, true, 1, kFar)})),
          m_count(context, shader("place_histogram", "histogram"), bindings(m_store, m_store, m_histogram.buffer, {})),
          m_place(context, shader("place", "place"), bindings(m_store, m_store, m_histogram.buffer, {}))
    {
    }

    std::vector<float> place(const PlacePass& pass, const Depths& depths)
    {
        const Texture texture = makeTexture(m_context, depths.pixels);
        const Buffer block = makeBufferOf(m_context, std::vector{pass.block});
        const auto all = bindings(block, m_store, m_histogram.buffer, *texture.flat);
        m_count.run(all, static_cast<std::uint32_t>(pass.groups.x), static_cast<std::uint32_t>(pass.groups.y), 1);
        m_place.run(all, 1, 1, 1);
        const auto* stored = reinterpret_cast<const lvsm::StoreBlock*>(m_store.data);
        return {stored->splits, stored->splits + kMaxLayers + 1};
    }

    bool isHistogramEmpty() const
    {
        const auto* words = reinterpret_cast<const std::uint32_t*>(m_histogram.data);
        return std::all_of(words, words + 4 * 1024, [](std::uint32_t word) { return word == 0; });
    }

private:
    static lvsm::StoreBlock storeBlock(int layerCount)
    {
        float splits[kMaxLayers + 1];
        for (int i = 0; i <= layerCount; ++i)
            splits[i] = static_cast<float>(i) / static_cast<float>(layerCount);
        return lvsm::storePass(splits, layerCount, 0.01f, kMap).block;
    }

    Shader shader(const std::string& file, const std::string& entry) const
    {
        const std::string path = m_form.isHlsl() ? m_form.hlslFolder + "/lvsm/passes/place.hlsl"
                                                 : m_form.glslFolder + "/lvsm/passes/" + file + ".comp";
        const std::string macro = m_form.isHlsl() ? "#define LVSM_DEPTH_SOURCE b4\n"
                                                  : "#define LVSM_DEPTH_SOURCE layout(binding = 4, std140)\n";
        return compile(m_form, path, vk::ShaderStageFlagBits::eCompute,
                       m_form.isHlsl() ? "lvsm_" + entry + "Compute" : "main", m_projected ? macro : "");
    }

    std::vector<Binding> bindings(const Buffer& block, const Buffer& store, const vk::raii::Buffer& histogram,
                                  vk::ImageView depths) const
    {
        using Type = vk::DescriptorType;
        const Type texture = m_form.isHlsl() ? Type::eSampledImage : Type::eCombinedImageSampler;
        const vk::Sampler sampler = m_form.isHlsl() ? vk::Sampler() : *m_sampler;
        return {{0, texture, {}, depths, sampler},
                {1, Type::eStorageBuffer, *histogram},
                uniformAt(2, block),
                uniformAt(4, m_source),
                bufferAt(3, store)};
    }

    VulkanContext& m_context;
    const Form& m_form;
    bool m_projected;
    Buffer m_histogram;
    Buffer m_store;
    vk::raii::Sampler m_sampler;
    Buffer m_source;
    Kernel m_count;
    Kernel m_place;
};

bool areNear(const std::vector<float>& placed, const float* expected, int layerCount)
{
    for (int i = 0; i <= layerCount; ++i)
    {
        if (!(std::abs(placed[static_cast<std::size_t>(i)] - expected[i]) <= static_cast<float>(kTolerance)))
            return false;
    }
    return true;
}

void expectSplits(Comparison& comparison, const std::vector<float>& placed, const float* expected, int layerCount,
                  const std::string& where)
{
    for (int i = 0; i <= kMaxLayers; ++i)
    {
        const double wanted = i <= layerCount ? static_cast<double>(expected[i]) : 1.0;
        const bool end = i == 0 || i >= layerCount;
        comparison.expect(static_cast<double>(placed[static_cast<std::size_t>(i)]), wanted, end ? 0 : kTolerance,
                          where + " split " + std::to_string(i));
    }
}

// Whether the host finds splits no better than these but for the rounding of a sum of 16 floats: optimal ones may tie.
bool isAsGood(const Depths& image, std::vector<float> splits, int layerCount)
{
    lvsm::OptimalOptions<float> options;
    options.leastGain = 1.0f / (1 << 20);
    const auto result =
        lvsm::optimalSplits(image.values.data(), kMap.width, kMap.height, splits.data(), layerCount, options);
    return result.status == lvsm::OptimalStatus::Kept;
}

bool checkStill(VulkanContext& context, const Form& form, bool optimal)
{
    Comparison comparison(optimal ? "optimal, still" : "relaxed, still");
    const std::vector<Depths> images = stillImages();
    int ties = 0;
    for (const int layerCount : {1, 2, 3, 4, kMaxLayers})
    {
        Placer placer(context, form, layerCount);
        for (std::size_t i = 0; i < images.size(); ++i)
        {
            float expected[kMaxLayers + 1];
            const float* depths = images[i].values.data();
            if (optimal)
                lvsm::optimalSplits(depths, kMap.width, kMap.height, expected, layerCount);
            else
                lvsm::lloydRelax(depths, kMap.width, kMap.height, expected, layerCount);
            const PlacePass pass = optimal ? lvsm::optimalPass(layerCount, kMap) : lvsm::relaxPass(layerCount, kMap);
            const std::string where = std::to_string(layerCount) + " layers, image " + std::to_string(i);
            const std::vector<float> placed = placer.place(pass, images[i]);
            const bool tied =
                optimal && !areNear(placed, expected, layerCount) && isAsGood(images[i], placed, layerCount);
            if (!tied)
                expectSplits(comparison, placed, expected, layerCount, where);
            ties += tied ? 1 : 0;
            comparison.expect(placer.isHistogramEmpty() ? 1 : 0, 1, 0, where + ": histogram left empty");
        }
    }
    std::printf("     %d ties\n", ties);
    return comparison.passed();
}

// Each goes on from its own splits of the frame before.
bool checkMoving(VulkanContext& context, const Form& form, bool optimal)
{
    constexpr int kLayers = 4;
    constexpr int kFrames = 16;
    Comparison comparison(optimal ? "optimal, moving, with hysteresis" : "relaxed, moving");
    Placer placer(context, form, kLayers);
    lvsm::RelaxOptions<float> relax;
    relax.keepSplits = true;
    lvsm::OptimalOptions<float> options;
    options.leastGain = 0.02f;
    options.minLength = 0.22f;
    float expected[kLayers + 1] = {0, 0.25f, 0.5f, 0.75f, 1};
    int kept = 0;
    for (int frame = 0; frame < kFrames; ++frame)
    {
        const float time = static_cast<float>(frame) / kFrames;
        const Depths image([=](int x, int y) { return tree(x, y, time); });
        const float* depths = image.values.data();
        if (optimal)
        {
            const auto result = lvsm::optimalSplits(depths, kMap.width, kMap.height, expected, kLayers, options);
            kept += result.status == lvsm::OptimalStatus::Kept ? 1 : 0;
        }
        else
            lvsm::lloydRelax(depths, kMap.width, kMap.height, expected, kLayers, relax);
        const PlacePass pass =
            optimal ? lvsm::optimalPass(kLayers, kMap, options) : lvsm::relaxPass(kLayers, kMap, relax);
        expectSplits(comparison, placer.place(pass, image), expected, kLayers, "frame " + std::to_string(frame));
    }
    // Some frames keep and some do not, or hysteresis is not tested.
    if (optimal)
        comparison.expect(kept > 0 && kept < kFrames ? 1 : 0, 1, 0, std::to_string(kept) + " frames kept");
    return comparison.passed();
}

bool checkProjected(VulkanContext& context, const Form& form)
{
    constexpr int kLayers = 4;
    Comparison comparison("relaxed, from a depth buffer");
    const Depths image = projectedTree();
    float expected[kLayers + 1];
    lvsm::lloydRelax(image.values.data(), kMap.width, kMap.height, expected, kLayers);
    Placer placer(context, form, kLayers, true);
    expectSplits(comparison, placer.place(lvsm::relaxPass(kLayers, kMap), image), expected, kLayers, "");
    return comparison.passed();
}

} // namespace

bool checkPlacing(VulkanContext& context, const Form& form)
{
    bool passed = checkProjected(context, form);
    for (const bool optimal : {false, true})
    {
        passed = checkStill(context, form, optimal) && passed;
        passed = checkMoving(context, form, optimal) && passed;
    }
    return passed;
}

} // namespace sampling
