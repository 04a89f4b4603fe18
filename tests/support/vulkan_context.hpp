#ifndef LVSM_TESTS_SUPPORT_VULKAN_CONTEXT_HPP
#define LVSM_TESTS_SUPPORT_VULKAN_CONTEXT_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <vulkan/vulkan_raii.hpp>

#include "vulkan_device.hpp"

namespace lvsm::support
{

/// What VulkanDevice holds. Members are destroyed from last to first.
struct VulkanContext
{
    DeviceName name;
    std::vector<std::string> validationMessages;
    vk::raii::Context loader;
    vk::raii::Instance instance{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger{nullptr};
    vk::raii::PhysicalDevice physical{nullptr};
    vk::raii::Device device{nullptr};
    std::uint32_t queueFamily = 0;
    vk::raii::Queue queue{nullptr};
    vk::raii::CommandPool commandPool{nullptr};
};

/// A buffer in memory that the host sees, mapped for its whole life.
struct Buffer
{
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Buffer buffer{nullptr};
    std::byte* data = nullptr;
    std::size_t size = 0;
};

/// The index of a memory type among `typeBits` that has the wanted properties.
std::uint32_t memoryType(const VulkanContext& context, std::uint32_t typeBits, vk::MemoryPropertyFlags wanted);

Buffer makeBuffer(const VulkanContext& context, std::size_t size, vk::BufferUsageFlags usage);

vk::raii::ShaderModule makeShader(const VulkanContext& context, const std::vector<std::uint32_t>& spirv);

/// Records commands, submits them and waits until the device has finished; the host and
/// later submissions see what they wrote.
void submit(const VulkanContext& context, const std::function<void(vk::raii::CommandBuffer&)>& record);

} // namespace lvsm::support

#endif
