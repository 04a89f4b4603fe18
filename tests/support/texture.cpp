#include "texture.hpp"

#include <algorithm>
#include <cstring>

namespace lvsm::support
{
namespace
{

vk::ImageAspectFlags aspectOf(vk::Format format)
{
    const bool depth = format == vk::Format::eD32Sfloat || format == vk::Format::eD16Unorm;
    return depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

vk::ImageSubresourceRange wholeRange(const Texture& texture)
{
    return {aspectOf(texture.format), 0, static_cast<std::uint32_t>(texture.size.levels), 0,
            static_cast<std::uint32_t>(texture.size.slices)};
}

std::vector<vk::BufferImageCopy> copiesOf(const Texture& texture, std::size_t texelBytes)
{
    const Shape& size = texture.size;
    std::vector<vk::BufferImageCopy> copies;
    for (int level = 0; level < size.levels; ++level)
    {
        const vk::ImageSubresourceLayers layers(aspectOf(texture.format), static_cast<std::uint32_t>(level), 0,
                                                static_cast<std::uint32_t>(size.slices));
        const vk::Extent3D extent(static_cast<std::uint32_t>(size.width >> level),
                                  static_cast<std::uint32_t>(size.height >> level), 1);
        copies.emplace_back(size.indexOf(0, 0, 0, level) * texelBytes, 0, 0, layers, vk::Offset3D(), extent);
    }
    return copies;
}

vk::ImageUsageFlags usageOf(const VulkanContext& context, const Shape& shape, vk::Format format)
{
    using Feature = vk::FormatFeatureFlagBits;
    using Usage = vk::ImageUsageFlagBits;
    const auto features = context.physical.getFormatProperties(format).optimalTilingFeatures;
    vk::ImageUsageFlags usage = Usage::eTransferSrc | Usage::eTransferDst;
    const auto allow = [&](Feature feature, Usage bit)
    {
        if (features & feature)
            usage |= bit;
    };
    allow(Feature::eSampledImage, Usage::eSampled);
    allow(Feature::eColorAttachment, Usage::eColorAttachment);
    allow(Feature::eDepthStencilAttachment, Usage::eDepthStencilAttachment);
    if (shape.samples == 1)
        allow(Feature::eStorageImage, Usage::eStorage);
    return usage;
}

void toGeneralLayout(vk::raii::CommandBuffer& commands, const Texture& texture)
{
    using Access = vk::AccessFlagBits;
    using Stage = vk::PipelineStageFlagBits;
    const vk::ImageMemoryBarrier barrier({}, Access::eMemoryRead | Access::eMemoryWrite, vk::ImageLayout::eUndefined,
                                         vk::ImageLayout::eGeneral, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                         *texture.image, wholeRange(texture));
    commands.pipelineBarrier(Stage::eTopOfPipe, Stage::eAllCommands, {}, {}, {}, barrier);
}

} // namespace

std::size_t Shape::indexOf(int x, int y, int slice, int level) const
{
    std::size_t index = 0;
    for (int i = 0; i < level; ++i)
        index += static_cast<std::size_t>((width >> i) * (height >> i) * slices);
    const int across = width >> level;
    const int down = height >> level;
    const int row = slice * down + std::clamp(y, 0, down - 1);
    return index + static_cast<std::size_t>(row * across + std::clamp(x, 0, across - 1));
}

std::size_t Shape::count() const
{
    std::size_t count = 0;
    for (int i = 0; i < levels; ++i)
        count += static_cast<std::size_t>((width >> i) * (height >> i) * slices);
    return count;
}

Pixels::Pixels(int width_, int height_, int slices_, int levels_) : Shape{width_, height_, slices_, levels_}
{
    texels.resize(count());
}

Texture makeTexture(const VulkanContext& context, const Shape& shape, vk::Format format)
{
    Texture texture;
    texture.size = shape;
    texture.format = format;
    const bool cube = shape.slices == 6 && shape.width == shape.height;
    const auto flags = cube ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlagBits{};
    const vk::ImageCreateInfo info(flags, vk::ImageType::e2D, format, vk::Extent3D(shape.extent(), 1),
                                   static_cast<std::uint32_t>(shape.levels), static_cast<std::uint32_t>(shape.slices),
                                   static_cast<vk::SampleCountFlagBits>(shape.samples), vk::ImageTiling::eOptimal,
                                   usageOf(context, shape, format));
    texture.image = {context.device, info};
    const auto needs = texture.image.getMemoryRequirements();
    const auto type = memoryType(context, needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    texture.memory = {context.device, vk::MemoryAllocateInfo(needs.size, type)};
    texture.image.bindMemory(*texture.memory, 0);
    texture.array = makeView(context, texture, vk::ImageViewType::e2DArray, wholeRange(texture));
    vk::ImageSubresourceRange first = wholeRange(texture);
    first.layerCount = 1;
    texture.flat = makeView(context, texture, vk::ImageViewType::e2D, first);
    submit(context, [&](vk::raii::CommandBuffer& commands) { toGeneralLayout(commands, texture); });
    return texture;
}

Texture makeTexture(const VulkanContext& context, const Shape& shape, vk::Format format, const void* texels,
                    std::size_t bytes)
{
    Texture texture = makeTexture(context, shape, format);
    const Buffer staging = makeBuffer(context, bytes, vk::BufferUsageFlagBits::eTransferSrc);
    std::memcpy(staging.data, texels, bytes);
    submit(context,
           [&](vk::raii::CommandBuffer& commands)
           {
               commands.copyBufferToImage(*staging.buffer, *texture.image, vk::ImageLayout::eGeneral,
                                          copiesOf(texture, bytes / shape.count()));
           });
    return texture;
}

Texture makeTexture(const VulkanContext& context, const Pixels& pixels)
{
    return makeTexture(context, pixels, kFormat, pixels.texels.data(), pixels.texels.size() * sizeof(glm::vec4));
}

vk::raii::ImageView makeView(const VulkanContext& context, const Texture& texture, vk::ImageViewType type,
                             const vk::ImageSubresourceRange& range)
{
    return {context.device, vk::ImageViewCreateInfo({}, *texture.image, type, texture.format, {}, range)};
}

vk::raii::ImageView makeSliceView(const VulkanContext& context, const Texture& texture, int slice, int level)
{
    return makeView(
        context, texture, vk::ImageViewType::e2D,
        {aspectOf(texture.format), static_cast<std::uint32_t>(level), 1, static_cast<std::uint32_t>(slice), 1});
}

vk::raii::ImageView makeLevelView(const VulkanContext& context, const Texture& texture, int level)
{
    return makeView(context, texture, vk::ImageViewType::e2DArray,
                    {aspectOf(texture.format), static_cast<std::uint32_t>(level), 1, 0,
                     static_cast<std::uint32_t>(texture.size.slices)});
}

Buffer readBytes(const VulkanContext& context, const Texture& texture, std::size_t texelBytes)
{
    Buffer staging = makeBuffer(context, texture.size.count() * texelBytes, vk::BufferUsageFlagBits::eTransferDst);
    submit(context,
           [&](vk::raii::CommandBuffer& commands)
           {
               commands.copyImageToBuffer(*texture.image, vk::ImageLayout::eGeneral, *staging.buffer,
                                          copiesOf(texture, texelBytes));
           });
    return staging;
}

Pixels readBack(const VulkanContext& context, const Texture& texture)
{
    const Shape& size = texture.size;
    Pixels pixels(size.width, size.height, size.slices, size.levels);
    pixels.texels = readTexels<glm::vec4>(context, texture);
    return pixels;
}

vk::raii::Sampler makeSampler(const VulkanContext& context, vk::Filter filter)
{
    const auto clamp = vk::SamplerAddressMode::eClampToEdge;
    vk::SamplerCreateInfo info({}, filter, filter, vk::SamplerMipmapMode::eNearest, clamp, clamp, clamp);
    info.maxLod = VK_LOD_CLAMP_NONE;
    return {context.device, info};
}

} // namespace lvsm::support
