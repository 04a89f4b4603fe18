#ifndef LVSM_TESTS_SUPPORT_VULKAN_DEVICE_HPP
#define LVSM_TESTS_SUPPORT_VULKAN_DEVICE_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "result.hpp"

namespace lvsm::support
{

struct DeviceName
{
    std::string device;
    std::string driver;
};

struct DeviceOptions
{
    /// Part of the device's or driver's name. Empty: the environment's LVSM_VULKAN_DEVICE,
    /// or else Mesa's lavapipe, or else the first device.
    std::string name;
    /// Fails to open when the validation layer is not installed.
    bool validation = false;
};

struct ComputeJob
{
    const std::vector<std::uint32_t>* spirv = nullptr;
    std::string entryPoint = "main";
    /// Contents of the storage buffer at set 0, binding 0.
    const void* input = nullptr;
    std::size_t inputBytes = 0;
    /// Size of the zeroed storage buffer at set 0, binding 1.
    std::size_t outputBytes = 0;
    std::uint32_t groupCount = 1;
};

struct VulkanContext;

/// A Vulkan device with one queue for graphics and compute. The devices of Mesa and,
/// where Debian's chromium is installed, SwiftShader are visible without any setting.
class VulkanDevice
{
public:
    static Result<std::vector<DeviceName>> list();
    static Result<VulkanDevice> open(const DeviceOptions& options = {});

    VulkanDevice(VulkanDevice&&) noexcept;
    VulkanDevice& operator=(VulkanDevice&&) noexcept;
    ~VulkanDevice();

    const DeviceName& name() const;

    /// What the validation layer has said so far: warnings and errors. Empty is good.
    const std::vector<std::string>& validationMessages() const;

    /// Runs a compute shader and returns the output buffer.
    Result<std::vector<std::byte>> run(const ComputeJob& job);

    /// For callers that need more than `run`: see vulkan_context.hpp.
    VulkanContext& context() { return *m_context; }

private:
    explicit VulkanDevice(std::unique_ptr<VulkanContext> context);
    std::unique_ptr<VulkanContext> m_context;
};

} // namespace lvsm::support

#endif
