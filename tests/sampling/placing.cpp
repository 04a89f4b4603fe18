// The splits placed on the device, against the host's.
#include "placing_truth.hpp"

#include <algorithm>
#include <cmath>

namespace sampling
{
namespace
{

constexpr int kWeighedLayers = 4;

// What the device keeps from frame to frame.
class Placer
{
public:
    // seen: of each texel of the textures, where splits are placed by what is on the screen.
    Placer(VulkanContext& context, const Form& form, const Placing& placing,
           const std::vector<std::uint32_t>& seen = {})
        : m_context(context), m_form(form), m_isProjected(placing.isProjected), m_isWeighed(!seen.empty()),
          m_seen(textureOf(seen)),
          m_histogram(makeBufferOf(context, std::vector<std::uint32_t>(kPlacedBins * (4 + kPlacedLayers), 0))),
          m_store(makeBufferOf(context, std::vector{placedBlock(placing.layerCount)})),
          m_sampler(makeSampler(context, vk::Filter::eNearest)),
          m_source(makeBufferOf(context, std::vector{placedDepths()})),
          m_count(context, shader("place_histogram", "histogram"), bindings(m_store, m_store, m_histogram.buffer, {})),
          m_place(context, shader("place", "place"), bindings(m_store, m_store, m_histogram.buffer, {}))
    {
    }

    std::vector<float> place(const lvsm::PlacePass& pass, const Depths& depths)
    {
        const Texture texture = makeTexture(m_context, depths.pixels);
        const Buffer block = makeBufferOf(m_context, std::vector{pass.block});
        const auto all = bindings(block, m_store, m_histogram.buffer, *texture.flat);
        m_count.run(all, static_cast<std::uint32_t>(pass.groups.x), static_cast<std::uint32_t>(pass.groups.y), 1);
        m_place.run(all, 1, 1, 1);
        const auto* stored = reinterpret_cast<const lvsm::StoreBlock*>(m_store.data);
        return {stored->splits, stored->splits + kPlacedLayers + 1};
    }

    std::vector<std::uint32_t> histogram() const
    {
        const auto* words = reinterpret_cast<const std::uint32_t*>(m_histogram.data);
        return {words, words + 4 * kPlacedBins};
    }

private:
    Texture textureOf(std::vector<std::uint32_t> seen) const
    {
        const Shape size{kTexture, kTexture};
        seen.resize(size.count());
        return makeTexture(m_context, size, vk::Format::eR32Uint, seen.data(), seen.size() * sizeof(std::uint32_t));
    }

    std::string macro(const std::string& name, const std::string& hlsl, const std::string& glsl) const
    {
        return "#define " + name + " " + (m_form.isHlsl() ? hlsl : "layout(" + glsl + ")") + "\n";
    }

    Shader shader(const std::string& file, const std::string& entry) const
    {
        const std::string path = m_form.isHlsl() ? m_form.hlslFolder + "/lvsm/passes/place.hlsl"
                                                 : m_form.glslFolder + "/lvsm/passes/" + file + ".comp";
        std::string macros = m_isProjected ? macro("LVSM_DEPTH_SOURCE", "b4", "binding = 4, std140") : "";
        macros += m_isWeighed ? macro("LVSM_PLACE_WEIGHTS", "t5", "binding = 5") : "";
        return compile(m_form, path, vk::ShaderStageFlagBits::eCompute,
                       m_form.isHlsl() ? "lvsm_" + entry + "Compute" : "main", macros);
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
                {5, texture, {}, *m_seen.flat, sampler},
                bufferAt(3, store)};
    }

    VulkanContext& m_context;
    const Form& m_form;
    bool m_isProjected;
    bool m_isWeighed;
    Texture m_seen;
    Buffer m_histogram;
    Buffer m_store;
    vk::raii::Sampler m_sampler;
    Buffer m_source;
    Kernel m_count;
    Kernel m_place;
};

// How many pixels of a screen read a texel of the map: none in a third of it, and more to one side than count.
std::uint32_t seenAt(int x, int y)
{
    return y % 9 < 3 ? 0u : static_cast<std::uint32_t>(1 + 4 * x);
}

// The host's placement with weights, which for an image it takes none of: in double, by its own steps.
std::vector<double> placedByWeights(const Depths& image, bool isOptimal)
{
    lvsm::detail::OccluderHistogram occluders;
    std::vector<double> depths(lvsm::kMaxOptimalBins);
    const auto momentsAt = [&](int x, int y)
    {
        const int texel = std::min(y, kMap.height - 1) * kMap.width + std::min(x, kMap.width - 1);
        return lvsm::depthMoments(static_cast<double>(image.values[static_cast<std::size_t>(texel)]));
    };
    for (int y = 0; y < kMap.height; ++y)
    {
        for (int x = 0; x < kMap.width; ++x)
        {
            const glm::dvec2 moments = lvsm::neighbourhoodMoments(momentsAt(x, y), momentsAt(x + 1, y),
                                                                  momentsAt(x, y + 1), momentsAt(x + 1, y + 1));
            const double share = std::min(seenAt(x, y), 256u) / 256.0;
            const int bin =
                std::min(static_cast<int>(momentsAt(x, y).x * lvsm::kMaxOptimalBins), lvsm::kMaxOptimalBins - 1);
            depths[static_cast<std::size_t>(bin)] += share * std::sqrt(lvsm::variance(moments, 0.0));
            if (x + 1 < kMap.width && y + 1 < kMap.height)
                occluders.add(lvsm::secondOccluder(moments), share * lvsm::occluderWeight(moments, 1e-6, 0.25));
        }
    }
    std::vector<double> splits;
    for (int i = 0; i <= kWeighedLayers; ++i)
        splits.push_back(static_cast<double>(i) / kWeighedLayers);
    if (isOptimal)
        lvsm::optimalSplitsHistogram(depths.data(), lvsm::kMaxOptimalBins, splits.data(), kWeighedLayers);
    else
        lvsm::detail::relax(occluders, splits.data(), kWeighedLayers, lvsm::RelaxOptions<double>());
    return splits;
}

bool checkWeighed(VulkanContext& context, const Form& form)
{
    Comparison comparison("by what is on the screen");
    std::vector<std::uint32_t> seen(kTexture * kTexture, 1000); // what is beyond the map has no say
    for (int y = 0; y < kMap.height; ++y)
    {
        for (int x = 0; x < kMap.width; ++x)
            seen[static_cast<std::size_t>((kMap.y + y) * kTexture + kMap.x + x)] = seenAt(x, y);
    }
    const Depths image([](int x, int y) { return tree(x, y, 0.3f); });
    for (const bool isOptimal : {false, true})
    {
        const Placing placing{"", kWeighedLayers, isOptimal, false, false, {}};
        const std::vector<float> placed = Placer(context, form, placing, seen).place(placing.pass(), image);
        const std::vector<double> expected = placedByWeights(image, isOptimal);
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
            comparison.expect(static_cast<double>(placed[i]), expected[i], 1.0 / 4096,
                              std::string(isOptimal ? "optimal" : "relaxed") + " split " + std::to_string(i));
        }
    }
    return comparison.passed();
}

} // namespace

bool checkPlacing(VulkanContext& context, const Form& form)
{
    bool passed = checkWeighed(context, form);
    for (const Placing& placing : placings())
    {
        Placer placer(context, form, placing);
        std::vector<std::vector<float>> splits;
        for (const Depths& image : placing.images)
            splits.push_back(placer.place(placing.pass(), image));
        passed = comparePlacing(placing, splits, placer.histogram()) && passed;
    }
    return passed;
}

} // namespace sampling
