#include "gpu.hpp"

#include <array>

namespace lvsm::support
{
namespace
{

constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

bool hasDepth(const RasterOptions& options)
{
    return options.depth != vk::Format::eUndefined;
}

vk::raii::RenderPass makeRenderPass(const VulkanContext& context, const RasterOptions& options)
{
    const auto general = vk::ImageLayout::eGeneral;
    const auto load = options.keep ? vk::AttachmentLoadOp::eLoad : vk::AttachmentLoadOp::eClear;
    std::vector<vk::AttachmentDescription> attachments;
    std::vector<vk::AttachmentReference> references;
    const auto attach = [&](vk::Format format)
    {
        references.emplace_back(static_cast<std::uint32_t>(attachments.size()), general);
        attachments.emplace_back(vk::AttachmentDescriptionFlags(), format,
                                 static_cast<vk::SampleCountFlagBits>(options.samples), load,
                                 vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                 vk::AttachmentStoreOp::eDontCare, general, general);
    };
    for (const vk::Format format : options.colours)
        attach(format);
    if (hasDepth(options))
        attach(options.depth);
    const auto* depth = hasDepth(options) ? &references.back() : nullptr;
    const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, 0, nullptr,
                                         static_cast<std::uint32_t>(options.colours.size()), references.data(), nullptr,
                                         depth);
    return {context.device, vk::RenderPassCreateInfo({}, attachments, subpass)};
}

vk::raii::Pipeline makePipeline(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
                                const RasterOptions& options, const vk::raii::PipelineLayout& layout,
                                const vk::raii::RenderPass& pass)
{
    using Stage = vk::ShaderStageFlagBits;
    const auto vertexModule = makeShader(context, vertex.spirv);
    const auto fragmentModule = makeShader(context, fragment.spirv);
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *vertexModule, vertex.entryPoint.c_str()),
        vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *fragmentModule, fragment.entryPoint.c_str())};
    const vk::VertexInputBindingDescription binding(0, options.vertexBytes, vk::VertexInputRate::eVertex);
    vk::PipelineVertexInputStateCreateInfo input;
    if (options.vertexBytes > 0)
        input.setVertexBindingDescriptions(binding).setVertexAttributeDescriptions(options.attributes);
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo rasterization;
    rasterization.setLineWidth(1.0f);
    const vk::PipelineMultisampleStateCreateInfo samples({}, static_cast<vk::SampleCountFlagBits>(options.samples));
    const vk::PipelineDepthStencilStateCreateInfo depth({}, hasDepth(options), hasDepth(options), vk::CompareOp::eLess);
    vk::PipelineColorBlendAttachmentState opaque;
    opaque.setColorWriteMask(vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags);
    const std::vector<vk::PipelineColorBlendAttachmentState> blends(options.colours.size(), opaque);
    vk::PipelineColorBlendStateCreateInfo blend;
    blend.setAttachments(blends);
    const std::array dynamics{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamics);
    return {context.device, nullptr,
            vk::GraphicsPipelineCreateInfo({}, stages, &input, &assembly, nullptr, &viewport, &rasterization, &samples,
                                           &depth, &blend, &dynamic, *layout, *pass)};
}

} // namespace

Raster::Raster(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
               const std::vector<Binding>& bindings, const RasterOptions& options)
    : m_context(context), m_layout(context, bindings, kStages), m_pass(makeRenderPass(context, options)),
      m_pipeline(makePipeline(context, vertex, fragment, options, m_layout.pipeline(), m_pass))
{
}

void Raster::draw(const std::vector<Binding>& bindings, const std::vector<vk::ImageView>& targets, vk::Extent2D extent,
                  std::uint32_t vertexCount, const Buffer* vertices, const std::vector<vk::ClearValue>& clears) const
{
    const vk::raii::Framebuffer framebuffer(
        m_context.device, vk::FramebufferCreateInfo({}, *m_pass, targets, extent.width, extent.height, 1));
    const vk::Rect2D area({0, 0}, extent);
    const vk::Viewport viewport(0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1);
    m_layout.submit(vk::PipelineBindPoint::eGraphics, bindings,
                    [&](vk::raii::CommandBuffer& commands)
                    {
                        commands.beginRenderPass(vk::RenderPassBeginInfo(*m_pass, *framebuffer, area, clears),
                                                 vk::SubpassContents::eInline);
                        commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *m_pipeline);
                        commands.setViewport(0, viewport);
                        commands.setScissor(0, area);
                        if (vertices != nullptr)
                            commands.bindVertexBuffers(0, *vertices->buffer, vk::DeviceSize{0});
                        commands.draw(vertexCount, 1, 0, 0);
                        commands.endRenderPass();
                    });
}

void draw(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
          const std::vector<Binding>& bindings, const Texture& target, std::uint32_t slice)
{
    RasterOptions options;
    options.colours = {target.format};
    const auto view = makeSliceView(context, target, static_cast<int>(slice));
    Raster(context, vertex, fragment, bindings, options).draw(bindings, {*view}, target.size.extent(), 3);
}

} // namespace lvsm::support
