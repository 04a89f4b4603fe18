#include "vulkan_context.hpp"

namespace lvsm::support
{

std::uint32_t memoryType(const VulkanContext& context, std::uint32_t typeBits, vk::MemoryPropertyFlags wanted)
{
    const auto memory = context.physical.getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    {
        const bool allowed = (typeBits >> i & 1u) != 0;
        if (allowed && (memory.memoryTypes[i].propertyFlags & wanted) == wanted)
            return i;
    }
    throw vk::OutOfDeviceMemoryError("no suitable memory type");
}

Buffer makeBuffer(const VulkanContext& context, std::size_t size, vk::BufferUsageFlags usage)
{
    using Property = vk::MemoryPropertyFlagBits;
    Buffer result;
    result.size = size;
    result.buffer = {context.device, vk::BufferCreateInfo({}, size, usage)};
    const auto needs = result.buffer.getMemoryRequirements();
    const auto type = memoryType(context, needs.memoryTypeBits, Property::eHostVisible | Property::eHostCoherent);
    result.memory = {context.device, vk::MemoryAllocateInfo(needs.size, type)};
    result.buffer.bindMemory(*result.memory, 0);
    result.data = static_cast<std::byte*>(result.memory.mapMemory(0, VK_WHOLE_SIZE));
    return result;
}

vk::raii::ShaderModule makeShader(const VulkanContext& context, const std::vector<std::uint32_t>& spirv)
{
    return {context.device, vk::ShaderModuleCreateInfo({}, spirv)};
}

void submit(const VulkanContext& context, const std::function<void(vk::raii::CommandBuffer&)>& record)
{
    const vk::CommandBufferAllocateInfo allocation(*context.commandPool, vk::CommandBufferLevel::ePrimary, 1);
    vk::raii::CommandBuffers commands(context.device, allocation);
    commands[0].begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record(commands[0]);
    using Access = vk::AccessFlagBits;
    using Stage = vk::PipelineStageFlagBits;
    const vk::MemoryBarrier toAll(Access::eMemoryWrite, Access::eMemoryRead | Access::eMemoryWrite | Access::eHostRead);
    commands[0].pipelineBarrier(Stage::eAllCommands, Stage::eAllCommands | Stage::eHost, {}, toAll, {}, {});
    commands[0].end();
    context.queue.submit(vk::SubmitInfo({}, {}, *commands[0]));
    context.queue.waitIdle();
}

} // namespace lvsm::support
