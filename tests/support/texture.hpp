#ifndef LVSM_TESTS_SUPPORT_TEXTURE_HPP
#define LVSM_TESTS_SUPPORT_TEXTURE_HPP

#include <vector>

#include <glm/vec4.hpp>

#include "vulkan_context.hpp"

namespace lvsm::support
{

constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Sfloat;

struct Shape
{
    int width = 1;
    int height = 1;
    int slices = 1;
    int levels = 1;
    int samples = 1;

    vk::Extent2D extent() const { return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)}; }
    /// Texels of all slices and levels.
    std::size_t count() const;
    /// Where a texel lies: all slices of level 0 first, then of level 1. Coordinates beyond the edge are clamped to it.
    std::size_t indexOf(int x, int y, int slice, int level) const;
};

/// What a texture of format kFormat holds.
struct Pixels : Shape
{
    std::vector<glm::vec4> texels;

    Pixels(int width, int height, int slices = 1, int levels = 1);

    /// Coordinates beyond the edge are clamped to it.
    glm::vec4& at(int x, int y, int slice = 0, int level = 0) { return texels[indexOf(x, y, slice, level)]; }
    const glm::vec4& at(int x, int y, int slice = 0, int level = 0) const
    {
        return texels[indexOf(x, y, slice, level)];
    }
};

/// In the general layout for good, and fit for all that the device does with its format: sampling, storing, drawing,
/// copying. Six square slices make a cube.
struct Texture
{
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Image image{nullptr};
    vk::raii::ImageView array{nullptr};
    /// Of the first slice alone.
    vk::raii::ImageView flat{nullptr};
    Shape size;
    vk::Format format = kFormat;
};

/// With undefined contents.
Texture makeTexture(const VulkanContext& context, const Shape& shape, vk::Format format);

Texture makeTexture(const VulkanContext& context, const Pixels& pixels);

/// From texels of the format itself, in the order of Shape::indexOf.
Texture makeTexture(const VulkanContext& context, const Shape& shape, vk::Format format, const void* texels,
                    std::size_t bytes);

/// Some slices of some levels.
vk::raii::ImageView makeView(const VulkanContext& context, const Texture& texture, vk::ImageViewType type,
                             const vk::ImageSubresourceRange& range);
vk::raii::ImageView makeSliceView(const VulkanContext& context, const Texture& texture, int slice, int level = 0);
vk::raii::ImageView makeLevelView(const VulkanContext& context, const Texture& texture, int level);

/// A buffer with the texture's whole contents, in the order of Shape::indexOf.
Buffer readBytes(const VulkanContext& context, const Texture& texture, std::size_t texelBytes);

template <typename Texel>
std::vector<Texel> readTexels(const VulkanContext& context, const Texture& texture)
{
    const Buffer bytes = readBytes(context, texture, sizeof(Texel));
    const auto* texels = reinterpret_cast<const Texel*>(bytes.data);
    return {texels, texels + texture.size.count()};
}

/// For a texture of format kFormat.
Pixels readBack(const VulkanContext& context, const Texture& texture);

/// Clamped to the edge, the nearest level.
vk::raii::Sampler makeSampler(const VulkanContext& context, vk::Filter filter = vk::Filter::eLinear);

} // namespace lvsm::support

#endif
