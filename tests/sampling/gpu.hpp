// Textures, and shaders that read and write them: what tests of sampling need beyond tests/support.
#ifndef LVSM_SAMPLING_GPU_HPP
#define LVSM_SAMPLING_GPU_HPP

#include <vulkan_context.hpp>

#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace sampling
{

using lvsm::support::Buffer;
using lvsm::support::VulkanContext;

constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Sfloat;

// The texels of one level of one slice after the other: all slices of level 0, then of level 1.
struct Pixels
{
    int width = 0;
    int height = 0;
    int slices = 1;
    int levels = 1;
    std::vector<glm::vec4> texels;

    Pixels(int width, int height, int slices = 1, int levels = 1);

    // Coordinates beyond the edge are clamped to it.
    glm::vec4& at(int x, int y, int slice = 0, int level = 0);
    const glm::vec4& at(int x, int y, int slice = 0, int level = 0) const;
};

struct Texture
{
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Image image{nullptr};
    vk::raii::ImageView array{nullptr};
    // Of the first slice alone.
    vk::raii::ImageView flat{nullptr};
    Pixels size{1, 1};
};

// In the general layout for good: fit to be sampled, stored to, drawn to and read back.
Texture makeTexture(const VulkanContext& context, const Pixels& pixels);

Pixels readBack(const VulkanContext& context, const Texture& texture);

// Linear within a level, clamped to the edge, the nearest level.
vk::raii::Sampler makeSampler(const VulkanContext& context);

template <typename T>
Buffer makeBufferOf(const VulkanContext& context, const std::vector<T>& values)
{
    using Usage = vk::BufferUsageFlagBits;
    Buffer buffer = lvsm::support::makeBuffer(context, values.size() * sizeof(T),
                                              Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eTransferSrc |
                                                  Usage::eTransferDst);
    std::copy(values.begin(), values.end(), reinterpret_cast<T*>(buffer.data));
    return buffer;
}

// What a shader finds at a binding of set 0.
struct Binding
{
    std::uint32_t index;
    vk::DescriptorType type;
    vk::Buffer buffer = {};
    vk::ImageView view = {};
    vk::Sampler sampler = {};
};

struct Shader
{
    std::vector<std::uint32_t> spirv;
    std::string entryPoint = "main";
};

void dispatch(const VulkanContext& context, const Shader& shader, const std::vector<Binding>& bindings,
              std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ);

// Draws over the whole of one slice of the target.
void draw(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
          const std::vector<Binding>& bindings, const Texture& target, std::uint32_t slice);

} // namespace sampling

#endif
