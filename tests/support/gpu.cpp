#include "gpu.hpp"

namespace lvsm::support
{
namespace
{

vk::raii::DescriptorSetLayout makeSetLayout(const VulkanContext& context, const std::vector<Binding>& bindings,
                                            vk::ShaderStageFlags stages)
{
    std::vector<vk::DescriptorSetLayoutBinding> layout;
    for (const Binding& binding : bindings)
        layout.emplace_back(binding.index, binding.type, 1, stages);
    return {context.device, vk::DescriptorSetLayoutCreateInfo({}, layout)};
}

vk::raii::DescriptorPool makePool(const VulkanContext& context, const std::vector<Binding>& bindings)
{
    std::vector<vk::DescriptorPoolSize> sizes{{vk::DescriptorType::eUniformBuffer, 1}};
    for (const Binding& binding : bindings)
        sizes.emplace_back(binding.type, 1);
    return {context.device,
            vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
}

vk::raii::Pipeline makeComputePipeline(const VulkanContext& context, const Shader& shader,
                                       const vk::raii::PipelineLayout& layout)
{
    const auto module = makeShader(context, shader.spirv);
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module,
                                                  shader.entryPoint.c_str());
    return {context.device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout)};
}

} // namespace

Binding uniformAt(std::uint32_t index, const Buffer& buffer)
{
    return {index, vk::DescriptorType::eUniformBuffer, *buffer.buffer};
}

Binding bufferAt(std::uint32_t index, const Buffer& buffer)
{
    return {index, vk::DescriptorType::eStorageBuffer, *buffer.buffer};
}

Binding sampledAt(std::uint32_t index, const vk::raii::ImageView& view, const vk::raii::Sampler& sampler)
{
    return {index, vk::DescriptorType::eCombinedImageSampler, {}, *view, *sampler};
}

Binding storageAt(std::uint32_t index, const vk::raii::ImageView& view)
{
    return {index, vk::DescriptorType::eStorageImage, {}, *view};
}

Layout::Layout(const VulkanContext& context, const std::vector<Binding>& bindings, vk::ShaderStageFlags stages)
    : m_context(context), m_set(makeSetLayout(context, bindings, stages)),
      m_pipeline(context.device, vk::PipelineLayoutCreateInfo({}, *m_set))
{
}

void Layout::submit(vk::PipelineBindPoint point, const std::vector<Binding>& bindings,
                    const std::function<void(vk::raii::CommandBuffer&)>& record) const
{
    const auto pool = makePool(m_context, bindings);
    const vk::raii::DescriptorSets sets(m_context.device, vk::DescriptorSetAllocateInfo(*pool, *m_set));
    for (const Binding& binding : bindings)
    {
        const vk::DescriptorBufferInfo buffer(binding.buffer, 0, VK_WHOLE_SIZE);
        const vk::DescriptorImageInfo image(binding.sampler, binding.view, vk::ImageLayout::eGeneral);
        const vk::WriteDescriptorSet write(*sets[0], binding.index, 0, 1, binding.type, &image, &buffer);
        m_context.device.updateDescriptorSets(write, {});
    }
    support::submit(m_context,
                    [&](vk::raii::CommandBuffer& commands)
                    {
                        commands.bindDescriptorSets(point, *m_pipeline, 0, *sets[0], {});
                        record(commands);
                    });
}

Kernel::Kernel(const VulkanContext& context, const Shader& shader, const std::vector<Binding>& bindings)
    : m_layout(context, bindings, vk::ShaderStageFlagBits::eCompute),
      m_pipeline(makeComputePipeline(context, shader, m_layout.pipeline()))
{
}

void Kernel::run(const std::vector<Binding>& bindings, std::uint32_t groupsX, std::uint32_t groupsY,
                 std::uint32_t groupsZ) const
{
    m_layout.submit(vk::PipelineBindPoint::eCompute, bindings,
                    [&](vk::raii::CommandBuffer& commands)
                    {
                        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *m_pipeline);
                        commands.dispatch(groupsX, groupsY, groupsZ);
                    });
}

void dispatch(const VulkanContext& context, const Shader& shader, const std::vector<Binding>& bindings,
              std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ)
{
    Kernel(context, shader, bindings).run(bindings, groupsX, groupsY, groupsZ);
}

} // namespace lvsm::support
