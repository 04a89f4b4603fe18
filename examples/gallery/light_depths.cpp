#include "light_depths.hpp"

#include <cstddef>
#include <cstring>

namespace lvsm::gallery
{

std::string depthMacro()
{
    return define("LVSM_DEPTH_SOURCE", "layout(binding = " + std::to_string(kDepthBlockBinding) + ", std140)");
}

std::vector<support::Binding> faceBindings(const LightDepths& depths, int face, const Texture& target,
                                           const vk::raii::Sampler& sampler)
{
    return {support::sampledAt(0, depths.faces[static_cast<std::size_t>(face)], sampler),
            support::storageAt(1, target.array), support::uniformAt(kDepthBlockBinding, depths.block)};
}

Kernel makeStore(const VulkanContext& gpu, const std::string& file, const std::string& store, const std::string& format,
                 const std::string& largest)
{
    using Type = vk::DescriptorType;
    std::string macros = depthMacro() + define("LVSM_STORE_FORMAT", format);
    if (!store.empty())
        macros += define("LVSM_STORE(depth, slice)", store) + define("LVSM_STORE_LARGEST", largest);
    return {gpu, compilePass(file, macros),
            bindingsOf({Type::eCombinedImageSampler, Type::eStorageImage, Type::eUniformBuffer, Type::eUniformBuffer,
                        Type::eUniformBuffer})};
}

void beginAtSlice(const Buffer& storeBlock, int slice)
{
    const std::int32_t first = slice;
    std::memcpy(storeBlock.data + offsetof(StoreBlock, firstSlice), &first, sizeof first);
}

DepthReader::DepthReader(const VulkanContext& gpu)
    : m_gpu(gpu), m_store(makeStore(gpu, "store.comp", "vec4(depth, 0.0, 0.0, 0.0)", "r32f", "1.0")),
      m_sampler(support::makeSampler(gpu, vk::Filter::eNearest))
{
}

LightDepths DepthReader::read(Texture buffer, const Light& light) const
{
    LightDepths depths{std::move(buffer), {}, support::makeBufferOf(m_gpu, std::vector{light.depths}), {}};
    depths.linear = support::makeTexture(m_gpu, depths.buffer.size, vk::Format::eR32Sfloat);
    const Pass<StoreBlock> pass = storePass(nullptr, 0, 0.0f, depths.area());
    const Buffer block = support::makeBufferOf(m_gpu, std::vector{pass.block});
    for (int face = 0; face < depths.faceCount(); ++face)
    {
        depths.faces.push_back(support::makeSliceView(m_gpu, depths.buffer, face));
        beginAtSlice(block, face);
        auto bindings = faceBindings(depths, face, depths.linear, m_sampler);
        bindings.push_back(support::uniformAt(2, block));
        bindings.push_back(support::uniformAt(3, block)); // the fused pass's, which no other reads
        runPass(m_store, bindings, pass.groups);
    }
    return depths;
}

} // namespace lvsm::gallery
