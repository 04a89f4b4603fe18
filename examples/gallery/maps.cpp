// Maps by the passes store, fused and blur.
#include "maps.hpp"

#include <lvsm/passes_fused.hpp>

namespace lvsm::gallery
{
namespace
{

constexpr int kBlurTaps = 9;

Kernel makeBlur(const VulkanContext& gpu, const std::string& format, const std::string& macros = {})
{
    using Type = vk::DescriptorType;
    return {gpu, compilePass("blur.comp", macros + define("LVSM_BLUR_FORMAT", format)),
            bindingsOf({Type::eCombinedImageSampler, Type::eStorageImage, Type::eUniformBuffer})};
}

class FilteredMaker : public MapMaker
{
public:
    FilteredMaker(const VulkanContext& gpu, const Technique& technique)
        : m_gpu(gpu), m_technique(technique), m_linear(support::makeSampler(gpu)),
          m_nearest(support::makeSampler(gpu, vk::Filter::eNearest))
    {
        const Storage& texel = *technique.texel;
        if (technique.making != Making::Stored)
            m_blur.emplace(makeBlur(gpu, texel.qualifier));
        if (isFused())
            m_fused.emplace(makeStore(gpu, "fused.comp", technique.store, texel.qualifier, texel.largest));
        if (!isFused() || isBeside())
            m_store.emplace(makeStore(gpu, "store.comp", technique.store, texel.qualifier, texel.largest));
        if (hasGreatest())
            m_maximum.emplace(makeBlur(gpu, "r32f", define("LVSM_BLUR_MAXIMUM")));
    }

    Maps make(const LightDepths& depths, const Buffer& splits) const override
    {
        if (m_technique.making == Making::Stored)
            return {stored(depths, splits)};
        if (hasGreatest())
            return {fused(depths, splits), stored(depths, splits), greatestDepths(depths)};
        if (isBeside())
            return {fused(depths, splits), stored(depths, splits)};
        if (isFused())
            return {fused(depths, splits)};
        Texture map = stored(depths, splits);
        blurSlices(map, depths);
        return {std::move(map)};
    }

private:
    // The fused pass has one border for all slices.
    bool isFused() const { return m_technique.making != Making::Stored && m_technique.border.size() == 1; }
    bool isBeside() const { return m_technique.making == Making::BlurredBeside || hasGreatest(); }
    bool hasGreatest() const { return m_technique.making == Making::BlurredWithGreatest; }

    Texture makeMap(const LightDepths& depths) const
    {
        support::Shape size = depths.buffer.size;
        size.slices *= m_technique.slices;
        return support::makeTexture(m_gpu, size, m_technique.texel->format);
    }

    Texture stored(const LightDepths& depths, const Buffer& splits) const
    {
        Texture map = makeMap(depths);
        GroupCount groups = storePass(nullptr, 0, 0.0f, depths.area()).groups;
        groups.z = m_technique.slices;
        for (int face = 0; face < depths.faceCount(); ++face)
            runStore(*m_store, depths, face, map, splits, splits, groups);
        return map;
    }

    Texture fused(const LightDepths& depths, const Buffer& splits) const
    {
        FusedPasses passes = fusedPasses(binomialKernel(kBlurTaps), nullptr, 0, 0.0f, depths.area(), depths.area(),
                                         m_technique.border.front());
        passes.fused.sliceCount = m_technique.slices;
        const Buffer block = support::makeBufferOf(m_gpu, std::vector{passes.fused});
        const Texture halfway = makeMap(depths);
        Texture map = makeMap(depths);
        for (int face = 0; face < depths.faceCount(); ++face)
            runStore(*m_fused, depths, face, halfway, splits, block, passes.store.groups);
        passes.down.groups.z = map.size.slices;
        blur(*m_blur, halfway, map, passes.down);
        return map;
    }

    void runStore(const Kernel& kernel, const LightDepths& depths, int face, const Texture& target,
                  const Buffer& splits, const Buffer& fusedBlock, const GroupCount& groups) const
    {
        beginAtSlice(splits, face * m_technique.slices);
        auto bindings = faceBindings(depths, face, target, m_nearest);
        bindings.push_back(support::uniformAt(2, splits));
        bindings.push_back(support::uniformAt(3, fusedBlock));
        runPass(kernel, bindings, groups);
    }

    // For maps whose slices have borders of their own.
    void blurSlices(Texture& map, const LightDepths& depths) const
    {
        const Texture halfway = makeMap(depths);
        for (int slice = 0; slice < map.size.slices; ++slice)
        {
            const auto& border = m_technique.border[static_cast<std::size_t>(slice % m_technique.slices)];
            const BlurPasses passes =
                blurPasses(binomialKernel(kBlurTaps), depths.area(), depths.area(), border, slice);
            blur(*m_blur, map, halfway, passes.across);
            blur(*m_blur, halfway, map, passes.down);
        }
    }

    // As the Z-Max test of ESM needs them.
    Texture greatestDepths(const LightDepths& depths) const
    {
        const Texture across = support::makeTexture(m_gpu, depths.linear.size, depths.linear.format);
        Texture greatest = support::makeTexture(m_gpu, depths.linear.size, depths.linear.format);
        const BlurPasses passes = blurPasses(boxKernel(kBlurTaps, false), depths.area(), depths.area(), glm::vec4(1.0f),
                                             0, depths.faceCount());
        blur(*m_maximum, depths.linear, across, passes.across);
        blur(*m_maximum, across, greatest, passes.down);
        return greatest;
    }

    void blur(const Kernel& kernel, const Texture& from, const Texture& to, const Pass<BlurBlock>& pass) const
    {
        const Buffer block = support::makeBufferOf(m_gpu, std::vector{pass.block});
        runPass(kernel,
                {support::sampledAt(0, from.array, m_linear), support::storageAt(1, to.array),
                 support::uniformAt(2, block)},
                pass.groups);
    }

    const VulkanContext& m_gpu;
    const Technique& m_technique;
    vk::raii::Sampler m_linear;
    vk::raii::Sampler m_nearest;
    std::optional<Kernel> m_store;
    std::optional<Kernel> m_fused;
    std::optional<Kernel> m_blur;
    std::optional<Kernel> m_maximum;
};

} // namespace

std::unique_ptr<MapMaker> makeMapMaker(const VulkanContext& gpu, const Technique& technique)
{
    if (technique.making == Making::Mixed)
        return makeMixtureMaker(gpu, technique);
    return std::make_unique<FilteredMaker>(gpu, technique);
}

} // namespace lvsm::gallery
