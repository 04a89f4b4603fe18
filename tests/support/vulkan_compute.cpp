#include <array>
#include <cstring>

#include "vulkan_context.hpp"

namespace lvsm::support
{
namespace
{

constexpr std::uint32_t kBufferCount = 2;

vk::raii::DescriptorSetLayout makeSetLayout(const VulkanContext& context)
{
    std::array<vk::DescriptorSetLayoutBinding, kBufferCount> bindings;
    for (std::uint32_t i = 0; i < kBufferCount; ++i)
    {
        bindings[i] = {i, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eCompute};
    }
    return {context.device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

vk::raii::DescriptorPool makePool(const VulkanContext& context)
{
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, kBufferCount);
    return {context.device,
            vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size)};
}

void bindBuffers(const VulkanContext& context, const vk::raii::DescriptorSet& set,
                 const std::array<const Buffer*, kBufferCount>& buffers)
{
    for (std::uint32_t i = 0; i < kBufferCount; ++i)
    {
        const vk::DescriptorBufferInfo buffer(*buffers[i]->buffer, 0, VK_WHOLE_SIZE);
        context.device.updateDescriptorSets(
            vk::WriteDescriptorSet(*set, i, 0, vk::DescriptorType::eStorageBuffer, {}, buffer), {});
    }
}

} // namespace

Result<std::vector<std::byte>> VulkanDevice::run(const ComputeJob& job)
try
{
    const Buffer input = makeBuffer(*m_context, job.inputBytes, vk::BufferUsageFlagBits::eStorageBuffer);
    const Buffer output = makeBuffer(*m_context, job.outputBytes, vk::BufferUsageFlagBits::eStorageBuffer);
    std::memcpy(input.data, job.input, job.inputBytes);
    std::memset(output.data, 0, job.outputBytes);

    const auto setLayout = makeSetLayout(*m_context);
    const auto pool = makePool(*m_context);
    const vk::raii::DescriptorSets sets(m_context->device, vk::DescriptorSetAllocateInfo(*pool, *setLayout));
    bindBuffers(*m_context, sets[0], {&input, &output});

    const vk::raii::PipelineLayout layout(m_context->device, vk::PipelineLayoutCreateInfo({}, *setLayout));
    const auto shader = makeShader(*m_context, *job.spirv);
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader,
                                                  job.entryPoint.c_str());
    const vk::raii::Pipeline pipeline(m_context->device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout));

    submit(*m_context,
           [&](vk::raii::CommandBuffer& commands)
           {
               commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
               commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, *sets[0], {});
               commands.dispatch(job.groupCount, 1, 1);
           });
    return std::vector<std::byte>(output.data, output.data + job.outputBytes);
}
catch (const std::exception& error)
{
    return Failure{std::string("Vulkan: ") + error.what()};
}

} // namespace lvsm::support
