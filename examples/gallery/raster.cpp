#include "raster.hpp"

#include <array>
#include <optional>

namespace lvsm::gallery
{
namespace
{

constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;
constexpr auto kPushStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

vk::raii::RenderPass makeRenderPass(const VulkanContext& gpu, const std::vector<vk::Format>& formats)
{
    const auto attachment = [](vk::Format format, vk::ImageLayout from, vk::ImageLayout to)
    {
        return vk::AttachmentDescription({}, format, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eClear,
                                         vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                         vk::AttachmentStoreOp::eDontCare, from, to);
    };
    std::vector<vk::AttachmentDescription> attachments;
    std::vector<vk::AttachmentReference> colours;
    for (const vk::Format format : formats)
    {
        colours.emplace_back(static_cast<std::uint32_t>(colours.size()), vk::ImageLayout::eGeneral);
        attachments.push_back(attachment(format, vk::ImageLayout::eGeneral, vk::ImageLayout::eGeneral));
    }
    const vk::AttachmentReference depth(static_cast<std::uint32_t>(formats.size()),
                                        vk::ImageLayout::eDepthStencilAttachmentOptimal);
    attachments.push_back(
        attachment(kDepthFormat, vk::ImageLayout::eUndefined, vk::ImageLayout::eDepthStencilAttachmentOptimal));
    const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, colours, {}, &depth);
    return {gpu.device, vk::RenderPassCreateInfo({}, attachments, subpass)};
}

vk::raii::DescriptorSetLayout makeSetLayout(const VulkanContext& gpu, bool usesLight)
{
    const vk::DescriptorSetLayoutBinding light(0, vk::DescriptorType::eUniformBuffer, 1,
                                               vk::ShaderStageFlagBits::eFragment);
    vk::DescriptorSetLayoutCreateInfo info;
    if (usesLight)
        info.setBindings(light);
    return {gpu.device, info};
}

vk::raii::PipelineLayout makeLayout(const VulkanContext& gpu, const vk::raii::DescriptorSetLayout& set)
{
    const vk::PushConstantRange push(kPushStages, 0, sizeof(View));
    return {gpu.device, vk::PipelineLayoutCreateInfo({}, *set, push)};
}

vk::raii::Pipeline makePipeline(const VulkanContext& gpu, const std::string& fragmentShader, std::size_t colourCount,
                                const vk::raii::PipelineLayout& layout, const vk::raii::RenderPass& renderPass)
{
    const auto vertex = support::makeShader(gpu, compile("scene.vert", support::ShaderStage::Vertex));
    const auto fragment = support::makeShader(gpu, compile(fragmentShader, support::ShaderStage::Fragment));
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main")};

    constexpr auto vec3 = vk::Format::eR32G32B32Sfloat;
    const vk::VertexInputBindingDescription binding(0, sizeof(Vertex), vk::VertexInputRate::eVertex);
    const std::array attributes{
        vk::VertexInputAttributeDescription(0, 0, vec3, offsetof(Vertex, position)),
        vk::VertexInputAttributeDescription(1, 0, vec3, offsetof(Vertex, normal)),
        vk::VertexInputAttributeDescription(2, 0, vec3, offsetof(Vertex, faceNormal)),
        vk::VertexInputAttributeDescription(3, 0, vec3, offsetof(Vertex, colour)),
        vk::VertexInputAttributeDescription(4, 0, vk::Format::eR32Sfloat, offsetof(Vertex, object))};
    const vk::PipelineVertexInputStateCreateInfo input({}, binding, attributes);
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo rasterization;
    rasterization.setLineWidth(1.0f);
    const vk::PipelineMultisampleStateCreateInfo multisample;
    const vk::PipelineDepthStencilStateCreateInfo depth({}, VK_TRUE, VK_TRUE, vk::CompareOp::eLess);
    vk::PipelineColorBlendAttachmentState opaque;
    opaque.setColorWriteMask(vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags);
    const std::vector<vk::PipelineColorBlendAttachmentState> blends(colourCount, opaque);
    vk::PipelineColorBlendStateCreateInfo blend;
    blend.setAttachments(blends);
    const std::array dynamics{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamics);
    return {gpu.device, nullptr,
            vk::GraphicsPipelineCreateInfo({}, stages, &input, &assembly, nullptr, &viewport, &rasterization,
                                           &multisample, &depth, &blend, &dynamic, *layout, *renderPass)};
}

struct DepthBuffer
{
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Image image{nullptr};
    vk::raii::ImageView view{nullptr};
};

DepthBuffer makeDepthBuffer(const VulkanContext& gpu, vk::Extent2D extent)
{
    DepthBuffer result;
    vk::ImageCreateInfo info({}, vk::ImageType::e2D, kDepthFormat, vk::Extent3D(extent, 1), 1, 1);
    info.setUsage(vk::ImageUsageFlagBits::eDepthStencilAttachment);
    result.image = {gpu.device, info};
    const auto needs = result.image.getMemoryRequirements();
    const auto type = support::memoryType(gpu, needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    result.memory = {gpu.device, vk::MemoryAllocateInfo(needs.size, type)};
    result.image.bindMemory(*result.memory, 0);
    result.view = {gpu.device, vk::ImageViewCreateInfo({}, *result.image, vk::ImageViewType::e2D, kDepthFormat, {},
                                                       {vk::ImageAspectFlagBits::eDepth, 0, 1, 0, 1})};
    return result;
}

} // namespace

RasterPass::RasterPass(const VulkanContext& gpu, const std::string& fragmentShader, std::vector<vk::Format> formats,
                       bool usesLight)
    : m_gpu(gpu), m_formats(std::move(formats)), m_renderPass(makeRenderPass(gpu, m_formats)),
      m_setLayout(makeSetLayout(gpu, usesLight)), m_layout(makeLayout(gpu, m_setLayout)),
      m_pipeline(makePipeline(gpu, fragmentShader, m_formats.size(), m_layout, m_renderPass))
{
}

std::vector<Image> RasterPass::draw(const Buffer& vertices, const View& view, vk::Extent2D extent, float clear,
                                    const Buffer* light) const
{
    using Usage = vk::ImageUsageFlagBits;
    std::vector<Image> images;
    std::vector<vk::ImageView> views;
    std::vector<vk::ClearValue> clears;
    for (const vk::Format format : m_formats)
    {
        const auto usage = Usage::eColorAttachment | Usage::eSampled | Usage::eTransferSrc;
        images.push_back(makeImage(m_gpu, format, extent, 1, usage));
        views.push_back(*images.back().view);
        clears.emplace_back(vk::ClearColorValue(std::array{clear, clear, clear, clear}));
    }
    const DepthBuffer depth = makeDepthBuffer(m_gpu, extent);
    views.push_back(*depth.view);
    clears.emplace_back(vk::ClearDepthStencilValue(1.0f, 0));
    const vk::raii::Framebuffer framebuffer(
        m_gpu.device, vk::FramebufferCreateInfo({}, *m_renderPass, views, extent.width, extent.height, 1));

    const vk::DescriptorPoolSize poolSize(vk::DescriptorType::eUniformBuffer, 1);
    const vk::raii::DescriptorPool pool(
        m_gpu.device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, poolSize));
    const vk::raii::DescriptorSets sets(m_gpu.device, vk::DescriptorSetAllocateInfo(*pool, *m_setLayout));
    if (light != nullptr)
    {
        const vk::DescriptorBufferInfo block(*light->buffer, 0, VK_WHOLE_SIZE);
        m_gpu.device.updateDescriptorSets(
            vk::WriteDescriptorSet(*sets[0], 0, 0, vk::DescriptorType::eUniformBuffer, {}, block), {});
    }

    const vk::Rect2D area({0, 0}, extent);
    const vk::Viewport viewport(0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1);
    support::submit(m_gpu,
                    [&](vk::raii::CommandBuffer& commands)
                    {
                        commands.beginRenderPass(vk::RenderPassBeginInfo(*m_renderPass, *framebuffer, area, clears),
                                                 vk::SubpassContents::eInline);
                        commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *m_pipeline);
                        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, *sets[0], {});
                        commands.setViewport(0, viewport);
                        commands.setScissor(0, area);
                        commands.pushConstants<View>(*m_layout, kPushStages, 0, view);
                        commands.bindVertexBuffers(0, *vertices.buffer, vk::DeviceSize{0});
                        commands.draw(static_cast<std::uint32_t>(vertices.size / sizeof(Vertex)), 1, 0, 0);
                        commands.endRenderPass();
                    });
    return images;
}

Buffer uploadMesh(const VulkanContext& gpu, const Mesh& mesh)
{
    Buffer buffer = support::makeBuffer(gpu, mesh.size() * sizeof(Vertex), vk::BufferUsageFlagBits::eVertexBuffer);
    std::memcpy(buffer.data, mesh.data(), buffer.size);
    return buffer;
}

} // namespace lvsm::gallery
