// The splits placed on the device, against the host's.
#include "placing_truth.hpp"

namespace sampling
{
namespace
{

// What the device keeps from frame to frame.
class Placer
{
public:
    Placer(VulkanContext& context, const Form& form, const Placing& placing)
        : m_context(context), m_form(form), m_isProjected(placing.isProjected),
          m_histogram(makeBufferOf(context, std::vector<std::uint32_t>(kPlacedBins * (4 + kPlacedLayers), 0))),
          m_store(makeBufferOf(context, std::vector{placedBlock(placing.layerCount)})), m_sampler(makeSampler(context)),
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
    Shader shader(const std::string& file, const std::string& entry) const
    {
        const std::string path = m_form.isHlsl() ? m_form.hlslFolder + "/lvsm/passes/place.hlsl"
                                                 : m_form.glslFolder + "/lvsm/passes/" + file + ".comp";
        const std::string macro = m_form.isHlsl() ? "#define LVSM_DEPTH_SOURCE b4\n"
                                                  : "#define LVSM_DEPTH_SOURCE layout(binding = 4, std140)\n";
        return compile(m_form, path, vk::ShaderStageFlagBits::eCompute,
                       m_form.isHlsl() ? "lvsm_" + entry + "Compute" : "main", m_isProjected ? macro : "");
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
    bool m_isProjected;
    Buffer m_histogram;
    Buffer m_store;
    vk::raii::Sampler m_sampler;
    Buffer m_source;
    Kernel m_count;
    Kernel m_place;
};

} // namespace

bool checkPlacing(VulkanContext& context, const Form& form)
{
    bool passed = true;
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
