#include "vulkan_device.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>

#include "vulkan_context.hpp"

namespace lvsm::support
{
namespace
{

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr const char* kSwiftShaderDriver = "/usr/lib/chromium/vk_swiftshader_icd.json";

bool isSet(const char* variable)
{
    return std::getenv(variable) != nullptr;
}

// Debian's SwiftShader lives outside the loader's search path; a driver list that the
// user has set is left as it is.
void makeSwiftShaderVisible()
{
    const bool chosenByUser = isSet("VK_ADD_DRIVER_FILES") || isSet("VK_DRIVER_FILES") || isSet("VK_ICD_FILENAMES");
    if (!chosenByUser && std::filesystem::exists(kSwiftShaderDriver))
    {
        setenv("VK_ADD_DRIVER_FILES", kSwiftShaderDriver, 0);
    }
}

// Printed at once too: what validation complains about can make a driver crash next.
VKAPI_ATTR VkBool32 VKAPI_CALL collectMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages)
{
    std::fprintf(stderr, "Vulkan validation: %s\n", data->pMessage);
    static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
    return VK_FALSE;
}

// Without the general type, the loader's own talk about other drivers, and without hints on performance.
vk::DebugUtilsMessengerCreateInfoEXT messengerInfo(std::vector<std::string>& messages)
{
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    return {{}, Severity::eWarning | Severity::eError, Type::eValidation, collectMessage, &messages};
}

bool hasValidationLayer(const vk::raii::Context& loader)
{
    const auto layers = loader.enumerateInstanceLayerProperties();
    return std::any_of(layers.begin(), layers.end(),
                       [](const vk::LayerProperties& layer)
                       { return std::strcmp(layer.layerName, kValidationLayer) == 0; });
}

vk::raii::Instance makeInstance(const vk::raii::Context& loader, bool validation, std::vector<std::string>& messages)
{
    const vk::ApplicationInfo application("lvsm", 1, nullptr, 0, VK_API_VERSION_1_1);
    const auto messenger = messengerInfo(messages);
    const std::array layers{kValidationLayer};
    const std::array extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
    vk::InstanceCreateInfo info({}, &application);
    if (validation)
    {
        info.setPEnabledLayerNames(layers).setPEnabledExtensionNames(extensions).setPNext(&messenger);
    }
    return {loader, info};
}

DeviceName describe(const vk::raii::PhysicalDevice& physical)
{
    const auto chain = physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    return {chain.get<vk::PhysicalDeviceProperties2>().properties.deviceName.data(),
            chain.get<vk::PhysicalDeviceDriverProperties>().driverName.data()};
}

bool matches(const DeviceName& name, const std::string& part)
{
    return name.device.find(part) != std::string::npos || name.driver.find(part) != std::string::npos;
}

std::optional<std::size_t> findDevice(const std::vector<DeviceName>& names, const std::string& part)
{
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const DeviceName& name) { return matches(name, part); });
    if (found == names.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

Result<std::size_t> chooseDevice(const std::vector<DeviceName>& names, std::string wanted)
{
    if (names.empty())
        return Failure{"no Vulkan device found"};
    const char* environment = std::getenv("LVSM_VULKAN_DEVICE");
    if (wanted.empty() && environment != nullptr)
        wanted = environment;
    if (wanted.empty())
        return findDevice(names, "llvmpipe").value_or(0);
    if (const auto index = findDevice(names, wanted))
        return *index;

    std::string message = "no Vulkan device is called '" + wanted + "'; there are:";
    for (const DeviceName& name : names)
        message += " '" + name.device + "'";
    return Failure{message};
}

std::uint32_t universalQueueFamily(const vk::raii::PhysicalDevice& physical)
{
    const auto families = physical.getQueueFamilyProperties();
    const auto wanted = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    const auto found = std::find_if(families.begin(), families.end(),
                                    [&](const auto& family) { return (family.queueFlags & wanted) == wanted; });
    if (found == families.end())
        throw vk::FeatureNotPresentError("no queue for graphics and compute");
    return static_cast<std::uint32_t>(found - families.begin());
}

vk::raii::Device makeDevice(const vk::raii::PhysicalDevice& physical, std::uint32_t queueFamily)
{
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, queueFamily, 1, &priority);
    const auto available = physical.getFeatures();
    vk::PhysicalDeviceFeatures features;
    features.shaderStorageImageExtendedFormats = available.shaderStorageImageExtendedFormats;
    features.sampleRateShading = available.sampleRateShading;
    features.samplerAnisotropy = available.samplerAnisotropy;
    return {physical, vk::DeviceCreateInfo({}, queue, {}, {}, &features)};
}

} // namespace

VulkanDevice::VulkanDevice(std::unique_ptr<VulkanContext> context) : m_context(std::move(context)) {}
VulkanDevice::VulkanDevice(VulkanDevice&&) noexcept = default;
VulkanDevice& VulkanDevice::operator=(VulkanDevice&&) noexcept = default;
VulkanDevice::~VulkanDevice() = default;

const DeviceName& VulkanDevice::name() const
{
    return m_context->name;
}

const std::vector<std::string>& VulkanDevice::validationMessages() const
{
    return m_context->validationMessages;
}

Result<std::vector<DeviceName>> VulkanDevice::list()
try
{
    makeSwiftShaderVisible();
    const vk::raii::Context loader;
    std::vector<std::string> messages;
    const vk::raii::Instance instance = makeInstance(loader, false, messages);
    std::vector<DeviceName> names;
    for (const auto& physical : vk::raii::PhysicalDevices(instance))
        names.push_back(describe(physical));
    return names;
}
catch (const std::exception& error)
{
    return Failure{std::string("Vulkan: ") + error.what()};
}

Result<VulkanDevice> VulkanDevice::open(const DeviceOptions& options)
try
{
    makeSwiftShaderVisible();
    auto context = std::make_unique<VulkanContext>();
    if (options.validation && !hasValidationLayer(context->loader))
    {
        return Failure{std::string(kValidationLayer) + " is not installed"};
    }
    context->instance = makeInstance(context->loader, options.validation, context->validationMessages);
    if (options.validation)
    {
        context->messenger = {context->instance, messengerInfo(context->validationMessages)};
    }

    vk::raii::PhysicalDevices devices(context->instance);
    std::vector<DeviceName> names;
    for (const auto& physical : devices)
        names.push_back(describe(physical));
    const auto chosen = chooseDevice(names, options.name);
    if (!chosen)
        return Failure{chosen.error()};

    context->name = names[*chosen];
    context->physical = std::move(devices[*chosen]);
    context->queueFamily = universalQueueFamily(context->physical);
    context->device = makeDevice(context->physical, context->queueFamily);
    context->queue = context->device.getQueue(context->queueFamily, 0);
    context->commandPool = {context->device, vk::CommandPoolCreateInfo({}, context->queueFamily)};
    return VulkanDevice(std::move(context));
}
catch (const std::exception& error)
{
    return Failure{std::string("Vulkan: ") + error.what()};
}

} // namespace lvsm::support
