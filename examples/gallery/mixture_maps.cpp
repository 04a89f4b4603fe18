// Maps of mixtures by the pass of that name.
#include <lvsm/passes_mixture.hpp>

#include "maps.hpp"

namespace lvsm::gallery
{
namespace
{

constexpr int kWindowTexels = 7;
constexpr vk::Format kMixtures = vk::Format::eR32G32B32A32Uint;

class MixtureMaker : public MapMaker
{
public:
    MixtureMaker(const VulkanContext& gpu, const Technique& technique)
        : m_gpu(gpu), m_technique(technique), m_sampler(support::makeSampler(gpu, vk::Filter::eNearest))
    {
        const int count = mixturePasses(kWindowTexels, false, {0, 0, 1, 1}, {0, 0, 1, 1}).count;
        for (int pass = 0; pass < count; ++pass)
            m_passes.push_back(makePass(pass == 0, pass + 1 == count));
    }

    Maps make(const LightDepths& depths, const Buffer&) const override
    {
        Texture map = support::makeTexture(m_gpu, depths.buffer.size, m_technique.texel->format);
        for (int face = 0; face < depths.faceCount(); ++face)
            makeFace(depths, face, map);
        return {std::move(map)};
    }

private:
    int components() const { return m_technique.texel->bits / 32; }

    Kernel makePass(bool isFirst, bool isLast) const
    {
        using Type = vk::DescriptorType;
        std::string macros = define("LVSM_MIXTURE_COUNT", std::to_string(components()));
        macros += isFirst ? depthMacro() : define("LVSM_MIXTURE_FROM_MIXTURES");
        macros += isLast ? "" : define("LVSM_MIXTURE_TO_MIXTURES");
        auto layout = bindingsOf({Type::eCombinedImageSampler, Type::eStorageImage, Type::eUniformBuffer});
        layout.push_back({kDepthBlockBinding, Type::eUniformBuffer});
        return {m_gpu, compilePass("mixture.comp", macros), layout};
    }

    void makeFace(const LightDepths& depths, int face, const Texture& map) const
    {
        const MixturePasses passes = mixturePasses(kWindowTexels, false, depths.area(), depths.area(), face);
        std::optional<Texture> before;
        for (int i = 0; i < passes.count; ++i)
        {
            std::optional<Texture> between;
            if (i + 1 < passes.count)
                between =
                    support::makeTexture(m_gpu, {passes.between.width, passes.between.height, components()}, kMixtures);
            auto bindings = faceBindings(depths, face, between ? *between : map, m_sampler);
            if (before)
                bindings[0] = support::sampledAt(0, before->array, m_sampler);
            const Pass<MixingBlock>& pass = passes.passes[i];
            const Buffer block = support::makeBufferOf(m_gpu, std::vector{pass.block});
            bindings.push_back(support::uniformAt(2, block));
            runPass(m_passes[static_cast<std::size_t>(i)], bindings, pass.groups);
            before = std::move(between);
        }
    }

    const VulkanContext& m_gpu;
    const Technique& m_technique;
    vk::raii::Sampler m_sampler;
    std::vector<Kernel> m_passes;
};

} // namespace

std::unique_ptr<MapMaker> makeMixtureMaker(const VulkanContext& gpu, const Technique& technique)
{
    return std::make_unique<MixtureMaker>(gpu, technique);
}

} // namespace lvsm::gallery
