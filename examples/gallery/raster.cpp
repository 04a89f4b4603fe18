#include "raster.hpp"

#include <array>
#include <cstddef>

namespace lvsm::gallery
{
namespace
{

constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;
constexpr std::uint32_t kLightBinding = 0;
constexpr std::uint32_t kViewBinding = 1;

std::vector<support::Binding> layoutOf(bool usesLight)
{
    std::vector<support::Binding> bindings{{kViewBinding, vk::DescriptorType::eUniformBuffer}};
    if (usesLight)
        bindings.push_back({kLightBinding, vk::DescriptorType::eUniformBuffer});
    return bindings;
}

support::RasterOptions optionsOf(const std::vector<vk::Format>& formats)
{
    constexpr auto vec3 = vk::Format::eR32G32B32Sfloat;
    support::RasterOptions options;
    options.colours = formats;
    options.depth = kDepthFormat;
    options.keep = false;
    options.vertexBytes = sizeof(Vertex);
    options.attributes = {{0, 0, vec3, offsetof(Vertex, position)},
                          {1, 0, vec3, offsetof(Vertex, normal)},
                          {2, 0, vec3, offsetof(Vertex, faceNormal)},
                          {3, 0, vec3, offsetof(Vertex, colour)},
                          {4, 0, vk::Format::eR32Sfloat, offsetof(Vertex, object)}};
    return options;
}

} // namespace

RasterPass::RasterPass(const VulkanContext& gpu, const std::string& fragmentShader, std::vector<vk::Format> formats,
                       bool usesLight)
    : m_gpu(gpu), m_formats(std::move(formats)),
      m_raster(gpu, compile("scene.vert", support::ShaderStage::Vertex),
               compile(fragmentShader, support::ShaderStage::Fragment), layoutOf(usesLight), optionsOf(m_formats))
{
}

std::vector<Texture> RasterPass::draw(const Buffer& vertices, const View& view, const support::Shape& size, float clear,
                                      const Buffer* light) const
{
    std::vector<Texture> images;
    std::vector<vk::ImageView> targets;
    std::vector<vk::ClearValue> clears;
    for (const vk::Format format : m_formats)
    {
        images.push_back(support::makeTexture(m_gpu, size, format));
        targets.push_back(*images.back().flat);
        clears.emplace_back(vk::ClearColorValue(std::array{clear, clear, clear, clear}));
    }
    const Texture depth = support::makeTexture(m_gpu, size, kDepthFormat);
    targets.push_back(*depth.flat);
    clears.emplace_back(vk::ClearDepthStencilValue(1.0f, 0));

    const Buffer viewBlock = support::makeBufferOf(m_gpu, std::vector{view});
    std::vector<support::Binding> bindings{support::uniformAt(kViewBinding, viewBlock)};
    if (light != nullptr)
        bindings.push_back(support::uniformAt(kLightBinding, *light));
    const auto count = static_cast<std::uint32_t>(vertices.size / sizeof(Vertex));
    m_raster.draw(bindings, targets, size.extent(), count, &vertices, clears);
    return images;
}

} // namespace lvsm::gallery
