// The fused pass, by Vulkan.
#include "fused_truth.hpp"

namespace sampling
{
namespace
{

Shader shaderOf(const Form& form)
{
    const std::string path =
        form.isHlsl() ? form.hlslFolder + "/lvsm/passes/fused.hlsl" : form.glslFolder + "/lvsm/passes/fused.comp";
    return compile(form, path, vk::ShaderStageFlagBits::eCompute, form.isHlsl() ? "lvsm_fusedCompute" : "main",
                   form.isHlsl() ? "" : "#define LVSM_STORE_FORMAT rgba32f\n");
}

Pixels runFused(VulkanContext& context, const Form& form, const Pixels& depths, const lvsm::FusedPasses& passes)
{
    const Texture source = makeTexture(context, depths);
    const Texture target = makeTexture(context, Pixels(kFusedSize.width, kFusedSize.height, kSlices));
    const auto sampler = makeSampler(context, vk::Filter::eNearest);
    const Buffer store = makeBufferOf(context, std::vector{passes.store.block});
    const Buffer fused = makeBufferOf(context, std::vector{passes.fused});
    using Type = vk::DescriptorType;
    const Binding read{0,
                       form.isHlsl() ? Type::eSampledImage : Type::eCombinedImageSampler,
                       {},
                       *source.flat,
                       form.isHlsl() ? vk::Sampler() : *sampler};
    dispatch(context, shaderOf(form), {read, storageAt(1, target.array), uniformAt(2, store), uniformAt(3, fused)},
             static_cast<std::uint32_t>(passes.store.groups.x), static_cast<std::uint32_t>(passes.store.groups.y), 1);
    return readBack(context, target);
}

} // namespace

bool checkFused(VulkanContext& context, const Form& form)
{
    bool passed = true;
    for (const Blur& blur : fusedBlurs())
        passed = compareFused("fused", blur, runFused(context, form, fusedDepths(), fusedPassesOf(blur))) && passed;
    return passed;
}

} // namespace sampling
