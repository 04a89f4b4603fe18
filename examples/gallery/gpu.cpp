#include "gpu.hpp"

#include <stdexcept>

namespace lvsm::gallery
{
namespace
{

constexpr std::uint32_t kGroupSize = 16;

std::vector<std::uint32_t> orThrow(support::Result<std::vector<std::uint32_t>> compiled)
{
    if (!compiled)
        throw std::runtime_error("a shader does not compile:\n" + compiled.error());
    return std::move(*compiled);
}

support::ShaderOptions options(support::ShaderStage stage, const std::string& preamble)
{
    support::ShaderOptions result;
    result.stage = stage;
    result.preamble = preamble;
    result.includeFolders = {LVSM_GALLERY_SHADERS, LVSM_GLSL};
    return result;
}

vk::ImageSubresourceRange everything(std::uint32_t layers)
{
    return {vk::ImageAspectFlagBits::eColor, 0, 1, 0, layers};
}

void changeLayout(vk::raii::CommandBuffer& commands, const Image& image, vk::ImageLayout from, vk::ImageLayout to)
{
    using Stage = vk::PipelineStageFlagBits;
    const auto access = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite;
    const vk::ImageMemoryBarrier barrier(access, access, from, to, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                         *image.image, everything(image.layers));
    commands.pipelineBarrier(Stage::eAllCommands, Stage::eAllCommands, {}, {}, {}, barrier);
}

vk::raii::Sampler makeSampler(const VulkanContext& gpu)
{
    vk::SamplerCreateInfo info({}, vk::Filter::eLinear, vk::Filter::eLinear);
    info.setAddressModeU(vk::SamplerAddressMode::eClampToEdge).setAddressModeV(vk::SamplerAddressMode::eClampToEdge);
    return {gpu.device, info};
}

vk::raii::DescriptorSetLayout makeSetLayout(const VulkanContext& gpu, const std::vector<vk::DescriptorType>& types)
{
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const vk::DescriptorType type : types)
    {
        bindings.emplace_back(static_cast<std::uint32_t>(bindings.size()), type, 1u, vk::ShaderStageFlagBits::eCompute);
    }
    return {gpu.device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

vk::raii::PipelineLayout makeLayout(const VulkanContext& gpu, const vk::raii::DescriptorSetLayout& set,
                                    std::uint32_t pushBytes)
{
    const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, pushBytes);
    vk::PipelineLayoutCreateInfo info({}, *set);
    if (pushBytes > 0)
        info.setPushConstantRanges(push);
    return {gpu.device, info};
}

vk::raii::Pipeline makePipeline(const VulkanContext& gpu, const std::vector<std::uint32_t>& spirv,
                                const vk::raii::PipelineLayout& layout)
{
    const auto shader = support::makeShader(gpu, spirv);
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
    return {gpu.device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout)};
}

void bind(const VulkanContext& gpu, vk::DescriptorSet set, std::uint32_t binding, const Resource& resource,
          vk::Sampler sampler)
{
    vk::WriteDescriptorSet write(set, binding, 0, 1);
    vk::DescriptorBufferInfo buffer;
    vk::DescriptorImageInfo image;
    if (const auto* uniform = std::get_if<Uniform>(&resource))
    {
        buffer = vk::DescriptorBufferInfo(*uniform->buffer.buffer, 0, VK_WHOLE_SIZE);
        write.setDescriptorType(vk::DescriptorType::eUniformBuffer).setBufferInfo(buffer);
    }
    else if (const auto* sampled = std::get_if<Sampled>(&resource))
    {
        image = vk::DescriptorImageInfo(sampler, *sampled->image.view, vk::ImageLayout::eGeneral);
        write.setDescriptorType(vk::DescriptorType::eCombinedImageSampler).setImageInfo(image);
    }
    else
    {
        image = vk::DescriptorImageInfo({}, *std::get<Storage>(resource).image.view, vk::ImageLayout::eGeneral);
        write.setDescriptorType(vk::DescriptorType::eStorageImage).setImageInfo(image);
    }
    gpu.device.updateDescriptorSets(write, {});
}

} // namespace

Image makeImage(const VulkanContext& gpu, vk::Format format, vk::Extent2D extent, std::uint32_t layers,
                vk::ImageUsageFlags usage)
{
    Image result;
    result.format = format;
    result.extent = extent;
    result.layers = layers;
    vk::ImageCreateInfo info({}, vk::ImageType::e2D, format, vk::Extent3D(extent, 1), 1, layers);
    info.setUsage(usage);
    result.image = {gpu.device, info};
    const auto needs = result.image.getMemoryRequirements();
    const auto type = support::memoryType(gpu, needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    result.memory = {gpu.device, vk::MemoryAllocateInfo(needs.size, type)};
    result.image.bindMemory(*result.memory, 0);
    result.view = {gpu.device, vk::ImageViewCreateInfo({}, *result.image, vk::ImageViewType::e2DArray, format, {},
                                                       everything(layers))};

    support::submit(gpu, [&](vk::raii::CommandBuffer& commands)
                    { changeLayout(commands, result, vk::ImageLayout::eUndefined, vk::ImageLayout::eGeneral); });
    return result;
}

std::vector<std::byte> readBytes(const VulkanContext& gpu, const Image& image, std::size_t texelBytes)
{
    const std::size_t size = texelBytes * image.extent.width * image.extent.height;
    const Buffer buffer = support::makeBuffer(gpu, size, vk::BufferUsageFlagBits::eTransferDst);
    const vk::BufferImageCopy region(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                     vk::Extent3D(image.extent, 1));
    support::submit(gpu,
                    [&](vk::raii::CommandBuffer& commands)
                    {
                        constexpr auto source = vk::ImageLayout::eTransferSrcOptimal;
                        changeLayout(commands, image, vk::ImageLayout::eGeneral, source);
                        commands.copyImageToBuffer(*image.image, source, *buffer.buffer, region);
                        changeLayout(commands, image, source, vk::ImageLayout::eGeneral);
                    });
    return {buffer.data, buffer.data + size};
}

std::vector<std::uint32_t> compile(const std::string& file, support::ShaderStage stage, const std::string& preamble)
{
    return orThrow(
        support::compileShaderFile(std::string(LVSM_GALLERY_SHADERS) + "/" + file, options(stage, preamble)));
}

std::vector<std::uint32_t> compileText(const std::string& text, support::ShaderStage stage, const std::string& preamble)
{
    return orThrow(support::compileShader(text, options(stage, preamble)));
}

Kernel::Kernel(const VulkanContext& gpu, const std::vector<std::uint32_t>& spirv,
               std::vector<vk::DescriptorType> bindings, std::uint32_t pushBytes)
    : m_gpu(gpu), m_bindings(std::move(bindings)), m_pushBytes(pushBytes), m_sampler(makeSampler(gpu)),
      m_setLayout(makeSetLayout(gpu, m_bindings)), m_layout(makeLayout(gpu, m_setLayout, pushBytes)),
      m_pipeline(makePipeline(gpu, spirv, m_layout))
{
}

void Kernel::run(const std::vector<Resource>& resources, vk::Extent2D extent, std::uint32_t layers,
                 const void* push) const
{
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const vk::DescriptorType type : m_bindings)
        sizes.emplace_back(type, 1u);
    const vk::raii::DescriptorPool pool(
        m_gpu.device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes));
    const vk::raii::DescriptorSets sets(m_gpu.device, vk::DescriptorSetAllocateInfo(*pool, *m_setLayout));
    for (std::uint32_t i = 0; i < resources.size(); ++i)
        bind(m_gpu, *sets[0], i, resources[i], *m_sampler);

    const auto groups = [](std::uint32_t texels)
    {
        return (texels + kGroupSize - 1) / kGroupSize;
    };
    support::submit(m_gpu,
                    [&](vk::raii::CommandBuffer& commands)
                    {
                        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *m_pipeline);
                        commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *m_layout, 0, *sets[0], {});
                        if (m_pushBytes > 0)
                        {
                            const auto* bytes = static_cast<const std::uint8_t*>(push);
                            commands.pushConstants<std::uint8_t>(
                                *m_layout, vk::ShaderStageFlagBits::eCompute, 0,
                                vk::ArrayProxy<const std::uint8_t>(m_pushBytes, bytes));
                        }
                        commands.dispatch(groups(extent.width), groups(extent.height), layers);
                    });
}

} // namespace lvsm::gallery
