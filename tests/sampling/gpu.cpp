#include "gpu.hpp"

#include <algorithm>
#include <array>

namespace sampling
{

using lvsm::support::makeBuffer;
using lvsm::support::makeShader;
using lvsm::support::memoryType;
using lvsm::support::submit;

namespace
{

std::size_t indexOf(const Pixels& pixels, int x, int y, int slice, int level)
{
    std::size_t index = 0;
    for (int i = 0; i < level; ++i)
        index += static_cast<std::size_t>((pixels.width >> i) * (pixels.height >> i) * pixels.slices);
    const int width = pixels.width >> level;
    const int height = pixels.height >> level;
    const int row = slice * height + std::clamp(y, 0, height - 1);
    return index + static_cast<std::size_t>(row * width + std::clamp(x, 0, width - 1));
}

vk::ImageSubresourceRange wholeRange(const Pixels& size)
{
    return {vk::ImageAspectFlagBits::eColor, 0, static_cast<std::uint32_t>(size.levels), 0,
            static_cast<std::uint32_t>(size.slices)};
}

std::vector<vk::BufferImageCopy> copiesOf(const Pixels& size)
{
    std::vector<vk::BufferImageCopy> copies;
    for (int level = 0; level < size.levels; ++level)
    {
        const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, static_cast<std::uint32_t>(level), 0,
                                                static_cast<std::uint32_t>(size.slices));
        const vk::Extent3D extent(static_cast<std::uint32_t>(size.width >> level),
                                  static_cast<std::uint32_t>(size.height >> level), 1);
        copies.emplace_back(indexOf(size, 0, 0, 0, level) * sizeof(glm::vec4), 0, 0, layers, vk::Offset3D(), extent);
    }
    return copies;
}

// The layouts and the set of a list of bindings, for one stage.
struct Layout
{
    vk::raii::DescriptorSetLayout set;
    vk::raii::PipelineLayout pipeline;
    vk::raii::DescriptorPool pool;
    vk::raii::DescriptorSets sets;
};

vk::raii::DescriptorSetLayout makeSetLayout(const VulkanContext& context, const std::vector<Binding>& bindings,
                                            vk::ShaderStageFlags stage)
{
    std::vector<vk::DescriptorSetLayoutBinding> layout;
    for (const Binding& binding : bindings)
        layout.emplace_back(binding.index, binding.type, 1, stage);
    return {context.device, vk::DescriptorSetLayoutCreateInfo({}, layout)};
}

vk::raii::DescriptorPool makePool(const VulkanContext& context, const std::vector<Binding>& bindings)
{
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const Binding& binding : bindings)
        sizes.emplace_back(binding.type, 1);
    return {context.device,
            vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
}

Layout makeLayout(const VulkanContext& context, const std::vector<Binding>& bindings, vk::ShaderStageFlags stage)
{
    auto set = makeSetLayout(context, bindings, stage);
    vk::raii::PipelineLayout pipeline(context.device, vk::PipelineLayoutCreateInfo({}, *set));
    auto pool = makePool(context, bindings);
    vk::raii::DescriptorSets sets(context.device, vk::DescriptorSetAllocateInfo(*pool, *set));
    for (const Binding& binding : bindings)
    {
        const vk::DescriptorBufferInfo buffer(binding.buffer, 0, VK_WHOLE_SIZE);
        const vk::DescriptorImageInfo image(binding.sampler, binding.view, vk::ImageLayout::eGeneral);
        vk::WriteDescriptorSet write(*sets[0], binding.index, 0, 1, binding.type, &image, &buffer);
        context.device.updateDescriptorSets(write, {});
    }
    return {std::move(set), std::move(pipeline), std::move(pool), std::move(sets)};
}

vk::raii::RenderPass makeRenderPass(const VulkanContext& context)
{
    using Layout = vk::ImageLayout;
    using Load = vk::AttachmentLoadOp;
    using Store = vk::AttachmentStoreOp;
    const vk::AttachmentDescription attachment({}, kFormat, vk::SampleCountFlagBits::e1, Load::eDontCare, Store::eStore,
                                               Load::eDontCare, Store::eDontCare, Layout::eGeneral, Layout::eGeneral);
    const vk::AttachmentReference reference(0, Layout::eGeneral);
    vk::SubpassDescription subpass;
    subpass.setColorAttachments(reference);
    return {context.device, vk::RenderPassCreateInfo({}, attachment, subpass)};
}

vk::raii::Pipeline makeDrawPipeline(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
                                    const vk::raii::PipelineLayout& layout, const vk::raii::RenderPass& pass,
                                    vk::Extent2D extent)
{
    const auto vertexModule = makeShader(context, vertex.spirv);
    const auto fragmentModule = makeShader(context, fragment.spirv);
    using Stage = vk::ShaderStageFlagBits;
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *vertexModule, vertex.entryPoint.c_str()),
        vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *fragmentModule, fragment.entryPoint.c_str())};
    const vk::PipelineVertexInputStateCreateInfo input;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::Viewport viewport(0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1);
    const vk::Rect2D scissor({}, extent);
    const vk::PipelineViewportStateCreateInfo viewports({}, viewport, scissor);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.lineWidth = 1;
    const vk::PipelineMultisampleStateCreateInfo samples;
    using Component = vk::ColorComponentFlagBits;
    vk::PipelineColorBlendAttachmentState blend;
    blend.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA;
    const vk::PipelineColorBlendStateCreateInfo blending({}, VK_FALSE, vk::LogicOp::eCopy, blend);
    return {context.device, nullptr,
            vk::GraphicsPipelineCreateInfo({}, stages, &input, &assembly, nullptr, &viewports, &raster, &samples,
                                           nullptr, &blending, nullptr, *layout, *pass)};
}

} // namespace

Pixels::Pixels(int width_, int height_, int slices_, int levels_)
    : width(width_), height(height_), slices(slices_), levels(levels_)
{
    texels.resize(indexOf(*this, 0, 0, 0, levels));
}

glm::vec4& Pixels::at(int x, int y, int slice, int level)
{
    return texels[indexOf(*this, x, y, slice, level)];
}

const glm::vec4& Pixels::at(int x, int y, int slice, int level) const
{
    return texels[indexOf(*this, x, y, slice, level)];
}

Texture makeTexture(const VulkanContext& context, const Pixels& pixels)
{
    using Usage = vk::ImageUsageFlagBits;
    Texture texture;
    texture.size = pixels;
    const vk::Extent3D extent(static_cast<std::uint32_t>(pixels.width), static_cast<std::uint32_t>(pixels.height), 1);
    const auto levels = static_cast<std::uint32_t>(pixels.levels);
    const auto slices = static_cast<std::uint32_t>(pixels.slices);
    texture.image = {context.device, vk::ImageCreateInfo({}, vk::ImageType::e2D, kFormat, extent, levels, slices,
                                                         vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                                         Usage::eSampled | Usage::eStorage | Usage::eColorAttachment |
                                                             Usage::eTransferSrc | Usage::eTransferDst)};
    const auto needs = texture.image.getMemoryRequirements();
    const auto type = memoryType(context, needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    texture.memory = {context.device, vk::MemoryAllocateInfo(needs.size, type)};
    texture.image.bindMemory(*texture.memory, 0);
    texture.array = {context.device, vk::ImageViewCreateInfo({}, *texture.image, vk::ImageViewType::e2DArray, kFormat,
                                                             {}, wholeRange(pixels))};
    vk::ImageSubresourceRange first = wholeRange(pixels);
    first.layerCount = 1;
    texture.flat = {context.device,
                    vk::ImageViewCreateInfo({}, *texture.image, vk::ImageViewType::e2D, kFormat, {}, first)};

    const Buffer staging = makeBufferOf(context, pixels.texels);
    submit(context,
           [&](vk::raii::CommandBuffer& commands)
           {
               using Access = vk::AccessFlagBits;
               using Stage = vk::PipelineStageFlagBits;
               const vk::ImageMemoryBarrier toGeneral({}, Access::eTransferWrite, vk::ImageLayout::eUndefined,
                                                      vk::ImageLayout::eGeneral, VK_QUEUE_FAMILY_IGNORED,
                                                      VK_QUEUE_FAMILY_IGNORED, *texture.image, wholeRange(pixels));
               commands.pipelineBarrier(Stage::eTopOfPipe, Stage::eTransfer, {}, {}, {}, toGeneral);
               commands.copyBufferToImage(*staging.buffer, *texture.image, vk::ImageLayout::eGeneral, copiesOf(pixels));
           });
    return texture;
}

Pixels readBack(const VulkanContext& context, const Texture& texture)
{
    Pixels pixels = texture.size;
    const Buffer staging = makeBufferOf(context, pixels.texels);
    submit(context,
           [&](vk::raii::CommandBuffer& commands) {
               commands.copyImageToBuffer(*texture.image, vk::ImageLayout::eGeneral, *staging.buffer, copiesOf(pixels));
           });
    const auto* texels = reinterpret_cast<const glm::vec4*>(staging.data);
    pixels.texels.assign(texels, texels + pixels.texels.size());
    return pixels;
}

vk::raii::Sampler makeSampler(const VulkanContext& context)
{
    const auto clamp = vk::SamplerAddressMode::eClampToEdge;
    vk::SamplerCreateInfo info({}, vk::Filter::eLinear, vk::Filter::eLinear, vk::SamplerMipmapMode::eNearest, clamp,
                               clamp, clamp);
    info.maxLod = VK_LOD_CLAMP_NONE;
    return {context.device, info};
}

void dispatch(const VulkanContext& context, const Shader& shader, const std::vector<Binding>& bindings,
              std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ)
{
    const Layout layout = makeLayout(context, bindings, vk::ShaderStageFlagBits::eCompute);
    const auto module = makeShader(context, shader.spirv);
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module,
                                                  shader.entryPoint.c_str());
    const vk::raii::Pipeline pipeline(context.device, nullptr,
                                      vk::ComputePipelineCreateInfo({}, stage, *layout.pipeline));
    submit(context,
           [&](vk::raii::CommandBuffer& commands)
           {
               commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
               commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout.pipeline, 0, *layout.sets[0], {});
               commands.dispatch(groupsX, groupsY, groupsZ);
           });
}

void draw(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
          const std::vector<Binding>& bindings, const Texture& target, std::uint32_t slice)
{
    const vk::Extent2D extent(static_cast<std::uint32_t>(target.size.width),
                              static_cast<std::uint32_t>(target.size.height));
    const vk::ImageSubresourceRange range(vk::ImageAspectFlagBits::eColor, 0, 1, slice, 1);
    const vk::raii::ImageView view(
        context.device, vk::ImageViewCreateInfo({}, *target.image, vk::ImageViewType::e2D, kFormat, {}, range));
    const auto pass = makeRenderPass(context);
    const vk::raii::Framebuffer framebuffer(
        context.device, vk::FramebufferCreateInfo({}, *pass, *view, extent.width, extent.height, 1));
    const Layout layout = makeLayout(context, bindings, vk::ShaderStageFlagBits::eFragment);
    const auto pipeline = makeDrawPipeline(context, vertex, fragment, layout.pipeline, pass, extent);
    submit(context,
           [&](vk::raii::CommandBuffer& commands)
           {
               commands.beginRenderPass(vk::RenderPassBeginInfo(*pass, *framebuffer, {{}, extent}),
                                        vk::SubpassContents::eInline);
               commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
               commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, *layout.sets[0], {});
               commands.draw(3, 1, 0, 0);
               commands.endRenderPass();
           });
}

} // namespace sampling
