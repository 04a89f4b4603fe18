#include "raster.hpp"

#include <array>
#include <cstddef>

namespace lvsm::gallery
{
namespace
{

constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;
constexpr vk::Format kVec4 = vk::Format::eR32G32B32A32Sfloat;
constexpr std::size_t kSurfaceImages = 6;
constexpr std::uint32_t kViewBinding = 1;

support::Raster makeRaster(const VulkanContext& gpu, const std::string& fragmentShader, std::size_t images)
{
    constexpr auto vec3 = vk::Format::eR32G32B32Sfloat;
    support::RasterOptions options;
    options.colours.assign(images, kVec4);
    options.depth = kDepthFormat;
    options.keep = false;
    options.vertexBytes = sizeof(Vertex);
    options.attributes = {{0, 0, vec3, offsetof(Vertex, position)},
                          {1, 0, vec3, offsetof(Vertex, normal)},
                          {2, 0, vec3, offsetof(Vertex, faceNormal)},
                          {3, 0, vec3, offsetof(Vertex, colour)},
                          {4, 0, vk::Format::eR32Sfloat, offsetof(Vertex, object)},
                          {5, 0, vk::Format::eR32G32Sfloat, offsetof(Vertex, place)}};
    return {gpu,
            compile("scene.vert", support::ShaderStage::Vertex),
            compile(fragmentShader, support::ShaderStage::Fragment),
            {{kViewBinding, vk::DescriptorType::eUniformBuffer}},
            options};
}

std::uint32_t countOf(const Buffer& vertices)
{
    return static_cast<std::uint32_t>(vertices.size / sizeof(Vertex));
}

const vk::ClearValue kFarthest(vk::ClearDepthStencilValue(1.0f, 0));

} // namespace

SurfacePass::SurfacePass(const VulkanContext& gpu)
    : m_gpu(gpu), m_raster(makeRaster(gpu, "surface.frag", kSurfaceImages))
{
}

Surface SurfacePass::draw(const Buffer& vertices, const View& view, const support::Shape& size) const
{
    Surface surface;
    std::vector<vk::ImageView> targets;
    std::vector<vk::ClearValue> clears(kSurfaceImages, vk::ClearColorValue(std::array{0.0f, 0.0f, 0.0f, 0.0f}));
    for (std::size_t i = 0; i < kSurfaceImages; ++i)
    {
        surface.images.push_back(support::makeTexture(m_gpu, size, kVec4));
        targets.push_back(*surface.images.back().flat);
    }
    const Texture depth = support::makeTexture(m_gpu, size, kDepthFormat);
    targets.push_back(*depth.flat);
    clears.push_back(kFarthest);
    const Buffer block = support::makeBufferOf(m_gpu, std::vector{view});
    m_raster.draw({support::uniformAt(kViewBinding, block)}, targets, size.extent(), countOf(vertices), &vertices,
                  clears);
    return surface;
}

ShadowPass::ShadowPass(const VulkanContext& gpu) : m_gpu(gpu), m_raster(makeRaster(gpu, "shadow.frag", 0)) {}

Texture ShadowPass::draw(const Buffer& vertices, const Light& light) const
{
    const support::Shape size{light.mapSize, light.mapSize, light.faceCount()};
    Texture depths = support::makeTexture(m_gpu, size, kDepthFormat);
    for (int face = 0; face < light.faceCount(); ++face)
    {
        const View view{light.block.faces[static_cast<std::size_t>(face)].viewProjection, light.block.position};
        const Buffer block = support::makeBufferOf(m_gpu, std::vector{view});
        const auto target = support::makeSliceView(m_gpu, depths, face);
        m_raster.draw({support::uniformAt(kViewBinding, block)}, {*target}, size.extent(), countOf(vertices), &vertices,
                      {kFarthest});
    }
    return depths;
}

} // namespace lvsm::gallery
