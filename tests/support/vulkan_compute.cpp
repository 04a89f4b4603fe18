#include <cstring>

#include "gpu.hpp"

namespace lvsm::support
{

Result<std::vector<std::byte>> VulkanDevice::run(const ComputeJob& job)
try
{
    const Buffer input = makeBuffer(*m_context, job.inputBytes, vk::BufferUsageFlagBits::eStorageBuffer);
    const Buffer output = makeBuffer(*m_context, job.outputBytes, vk::BufferUsageFlagBits::eStorageBuffer);
    std::memcpy(input.data, job.input, job.inputBytes);
    std::memset(output.data, 0, job.outputBytes);
    dispatch(*m_context, {*job.spirv, job.entryPoint}, {bufferAt(0, input), bufferAt(1, output)}, job.groupCount, 1, 1);
    return std::vector<std::byte>(output.data, output.data + job.outputBytes);
}
catch (const std::exception& error)
{
    return Failure{std::string("Vulkan: ") + error.what()};
}

} // namespace lvsm::support
