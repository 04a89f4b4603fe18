#include "radv.hpp"

#include <vulkan/vulkan_raii.hpp>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace cost
{

using lvsm::support::Failure;
using lvsm::support::Result;

struct Radv::State
{
    vk::raii::Context loader;
    vk::raii::Instance instance{nullptr};
    vk::raii::PhysicalDevice physical{nullptr};
    vk::raii::Device device{nullptr};
    vk::raii::DescriptorSetLayout setLayout{nullptr};
    vk::raii::PipelineLayout layout{nullptr};
};

namespace
{

constexpr const char* kExtension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
constexpr std::uint32_t kPushConstantBytes = 64;

// Where Debian and most other distributions keep the driver's description, by the name of the architecture.
std::string findDriver()
{
    for (const char* folder : {"/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d"})
    {
        std::error_code ignored;
        for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        {
            if (entry.path().filename().string().rfind("radeon_icd.", 0) == 0)
                return entry.path().string();
        }
    }
    return "";
}

vk::raii::Device makeDevice(const vk::raii::PhysicalDevice& physical)
{
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, 0, 1, &priority);
    const vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics(true);
    vk::DeviceCreateInfo info({}, queue, {}, kExtension);
    info.setPNext(&statistics);
    return {physical, info};
}

vk::raii::DescriptorSetLayout makeSetLayout(const vk::raii::Device& device)
{
    using Type = vk::DescriptorType;
    const std::array types{Type::eStorageBuffer, Type::eStorageBuffer, Type::eCombinedImageSampler,
                           Type::eStorageImage,  Type::eUniformBuffer, Type::eUniformBuffer};
    std::array<vk::DescriptorSetLayoutBinding, types.size()> bindings;
    for (std::uint32_t i = 0; i < bindings.size(); ++i)
        bindings[i] = {i, types[i], 1, vk::ShaderStageFlagBits::eCompute};
    return {device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

} // namespace

Radv::Radv(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Radv::Radv(Radv&&) noexcept = default;
Radv::~Radv() = default;

Result<Radv> Radv::open(const std::string& target)
try
{
    const std::string driver = findDriver();
    if (driver.empty())
        return Failure{"Mesa's Vulkan driver for AMD is not installed (Debian: mesa-vulkan-drivers)"};
    setenv("VK_ICD_FILENAMES", driver.c_str(), 1);
    setenv("VK_DRIVER_FILES", driver.c_str(), 1);
    setenv("RADV_FORCE_FAMILY", target.c_str(), 1);

    auto state = std::make_unique<State>();
    const vk::ApplicationInfo application("lvsm", 1, nullptr, 0, VK_API_VERSION_1_1);
    state->instance = {state->loader, vk::InstanceCreateInfo({}, &application)};
    vk::raii::PhysicalDevices devices(state->instance);
    const auto isTarget = [&target](const vk::raii::PhysicalDevice& device)
    {
        return std::strstr(device.getProperties().deviceName.data(), target.c_str()) != nullptr;
    };
    if (devices.empty() || !isTarget(devices.front()))
        return Failure{"RADV does not know the family " + target};
    state->physical = std::move(devices.front());
    state->device = makeDevice(state->physical);
    state->setLayout = makeSetLayout(state->device);
    const vk::PushConstantRange constants(vk::ShaderStageFlagBits::eCompute, 0, kPushConstantBytes);
    state->layout = {state->device, vk::PipelineLayoutCreateInfo({}, *state->setLayout, constants)};
    return Radv(std::move(state));
}
catch (const std::exception& error)
{
    return Failure{std::string("RADV: ") + error.what()};
}

std::string Radv::version() const
{
    const std::uint32_t version = m_state->physical.getProperties().driverVersion;
    return "RADV " + std::to_string(VK_VERSION_MAJOR(version)) + '.' + std::to_string(VK_VERSION_MINOR(version)) + '.' +
           std::to_string(VK_VERSION_PATCH(version));
}

Result<Statistics> Radv::compile(const std::vector<std::uint32_t>& spirv) const
try
{
    const vk::raii::ShaderModule shader(m_state->device, vk::ShaderModuleCreateInfo({}, spirv));
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
    const vk::raii::Pipeline pipeline(
        m_state->device, nullptr,
        vk::ComputePipelineCreateInfo(vk::PipelineCreateFlagBits::eCaptureStatisticsKHR, stage, *m_state->layout));
    Statistics statistics{-1, -1, -1};
    for (const auto& statistic : m_state->device.getPipelineExecutableStatisticsKHR({*pipeline, 0}))
    {
        const std::string name = statistic.name.data();
        if (name == "Instructions")
            statistics.instructions = static_cast<int>(statistic.value.u64);
        if (name == "Inverse Throughput")
            statistics.inverseThroughput = static_cast<int>(statistic.value.u64);
        if (name == "VGPRs")
            statistics.registers = static_cast<int>(statistic.value.u64);
    }
    if (statistics.instructions < 0 || statistics.inverseThroughput < 0 || statistics.registers < 0)
        return Failure{"this RADV does not tell instructions, inverse throughput and registers"};
    return statistics;
}
catch (const std::exception& error)
{
    return Failure{std::string("RADV: ") + error.what()};
}

} // namespace cost
