// lvsm_devices NAME: succeeds where a Vulkan device of that name opens, with the validation layer.
#include <vulkan_device.hpp>

#include <cstdio>

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::fprintf(stderr, "usage: lvsm_devices NAME\n");
        return 2;
    }
    const auto device = lvsm::support::VulkanDevice::open({argv[1], true});
    if (!device)
    {
        std::printf("no %s: %s\n", argv[1], device.error().c_str());
        return 77;
    }
    std::printf("%s (%s)\n", device->name().device.c_str(), device->name().driver.c_str());
    return 0;
}
