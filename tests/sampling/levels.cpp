// The levels of a map by the mip pass, by Vulkan.
#include "levels_truth.hpp"

namespace sampling
{
namespace
{

Shader shaderOf(const Form& form, bool compute, bool maximum)
{
    const std::string folder = (form.isHlsl() ? form.hlslFolder : form.glslFolder) + "/lvsm/passes/mip";
    const std::string macros = std::string(form.isHlsl() ? "" : "#define LVSM_MIP_FORMAT rgba32f\n") +
                               (maximum ? "#define LVSM_MIP_MAXIMUM\n" : "");
    return compile(form,
                   folder + (form.isHlsl() ? ".hlsl"
                             : compute     ? ".comp"
                                           : ".frag"),
                   compute ? vk::ShaderStageFlagBits::eCompute : vk::ShaderStageFlagBits::eFragment,
                   form.isHlsl() ? (compute ? "lvsm_mipCompute" : "lvsm_mipPixel") : "main", macros);
}

// Makes one level: by compute in all slices, or drawn over the whole of one slice's level.
void makeLevel(VulkanContext& context, const Form& form, bool compute, const Levels& levels, int level,
               const Texture& texture)
{
    auto pass = lvsm::mipPass(levels.map, level, 0, kLevelsTexture.slices);
    const auto before = makeLevelView(context, texture, level - 1);
    const auto sampler = makeSampler(context, vk::Filter::eNearest);
    using Type = vk::DescriptorType;
    const Binding source{0,
                         form.isHlsl() ? Type::eSampledImage : Type::eCombinedImageSampler,
                         {},
                         *before,
                         form.isHlsl() ? vk::Sampler() : *sampler};
    const Shader shader = shaderOf(form, compute, levels.maximum);
    if (compute)
    {
        const auto own = makeLevelView(context, texture, level);
        const Buffer block = makeBufferOf(context, std::vector{pass.block});
        dispatch(context, shader, {source, storageAt(1, own), uniformAt(2, block)},
                 static_cast<std::uint32_t>(pass.groups.x), static_cast<std::uint32_t>(pass.groups.y),
                 static_cast<std::uint32_t>(pass.groups.z));
        return;
    }
    const Form glsl{"combined", form.glslFolder, form.hlslFolder, form.kernelFolder, {}};
    const Shader vertex =
        compile(glsl, form.kernelFolder + "/triangle.vert", vk::ShaderStageFlagBits::eVertex, "main", "");
    RasterOptions options;
    options.colours = {texture.format};
    const vk::Extent2D extent(static_cast<std::uint32_t>(texture.size.width >> level),
                              static_cast<std::uint32_t>(texture.size.height >> level));
    for (int slice = 0; slice < kLevelsTexture.slices; ++slice)
    {
        pass.block.slice = slice;
        const Buffer block = makeBufferOf(context, std::vector{pass.block});
        const std::vector<Binding> bindings{source, uniformAt(2, block)};
        const auto target = makeSliceView(context, texture, slice, level);
        Raster(context, vertex, shader, bindings, options).draw(bindings, {*target}, extent, 3);
    }
}

bool checkMap(VulkanContext& context, const Form& form, bool compute, const Levels& levels)
{
    const Texture texture = makeTexture(context, randomLevels());
    for (int level = 1; level < levels.count(); ++level)
        makeLevel(context, form, compute, levels, level, texture);
    // Drawing covers all of the level, of which the rest is not the pass's.
    return compareLevels(compute ? ", compute" : ", fragment", levels, readBack(context, texture), compute);
}

} // namespace

bool checkLevels(VulkanContext& context, const Form& form)
{
    bool passed = true;
    for (const bool compute : {true, false})
    {
        for (const Levels& levels : levelsOfTest())
            passed = checkMap(context, form, compute, levels) && passed;
    }
    return passed;
}

} // namespace sampling
