#include "raster.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/gtc/matrix_transform.hpp>

namespace lvsm::gallery
{
namespace
{

constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;
constexpr vk::Format kVec4 = vk::Format::eR32G32B32A32Sfloat;
constexpr std::uint32_t kViewBinding = 1;
constexpr std::uint32_t kBeforeBinding = 2;
// Of texels of a peel, from their centres: receivers lie anywhere between the map's.
constexpr glm::vec3 kOffCentre{0.31f, 0.17f, 0.0f};
// No scene has so many surfaces on a ray.
constexpr int kMostPeels = 64;

support::Raster makeRaster(const VulkanContext& gpu, const std::string& fragmentShader, std::size_t images,
                           const std::string& macros = "",
                           const std::vector<support::Binding>& bindings = {
                               {kViewBinding, vk::DescriptorType::eUniformBuffer}})
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
    return {gpu, compile("scene.vert", support::ShaderStage::Vertex),
            compile(fragmentShader, support::ShaderStage::Fragment, macros), bindings, options};
}

std::uint32_t countOf(const Buffer& vertices)
{
    return static_cast<std::uint32_t>(vertices.size / sizeof(Vertex));
}

const vk::ClearValue kFarthest(vk::ClearDepthStencilValue(1.0f, 0));

// Draws by surface.frag, into new images and a depth buffer that is 1.
Surface drawSurface(const VulkanContext& gpu, const support::Raster& raster,
                    const std::vector<support::Binding>& bindings, const Buffer& vertices, const Texture& depth)
{
    Surface surface;
    std::vector<vk::ImageView> targets;
    std::vector<vk::ClearValue> clears(kSurfaceImages, vk::ClearColorValue(std::array{0.0f, 0.0f, 0.0f, 0.0f}));
    for (std::size_t i = 0; i < kSurfaceImages; ++i)
    {
        surface.images.push_back(support::makeTexture(gpu, depth.size, kVec4));
        targets.push_back(*surface.images.back().flat);
    }
    targets.push_back(*depth.flat);
    clears.push_back(kFarthest);
    raster.draw(bindings, targets, depth.size.extent(), countOf(vertices), &vertices, clears);
    return surface;
}

// Adds what is a receiver. Whether anything was drawn.
bool addReceivers(Points& receivers, const Points& drawn)
{
    bool isAny = false;
    for (std::size_t i = 0; i < drawn[0].size(); ++i)
    {
        const bool isDrawn = drawn[3][i].w > 0.0f;
        isAny = isAny || isDrawn;
        for (std::size_t image = 0; image < kSurfaceImages && drawn[0][i].w > 0.0f; ++image)
            receivers[image].push_back(drawn[image][i]);
    }
    return isAny;
}

} // namespace

Points readPoints(const VulkanContext& gpu, const Surface& surface)
{
    Points points;
    for (std::size_t i = 0; i < kSurfaceImages; ++i)
        points[i] = support::readTexels<glm::vec4>(gpu, surface.images[i]);
    return points;
}

Surface makeSurface(const VulkanContext& gpu, const Points& points, int width)
{
    const int height = (static_cast<int>(points[0].size()) + width - 1) / width;
    const support::Shape size{width, std::max(height, 1)};
    Surface surface;
    for (std::vector<glm::vec4> image : points)
    {
        image.resize(size.count());
        surface.images.push_back(
            support::makeTexture(gpu, size, kVec4, image.data(), image.size() * sizeof(glm::vec4)));
    }
    return surface;
}

SurfacePass::SurfacePass(const VulkanContext& gpu)
    : m_gpu(gpu), m_raster(makeRaster(gpu, "surface.frag", kSurfaceImages))
{
}

Surface SurfacePass::draw(const Buffer& vertices, const View& view, const support::Shape& size) const
{
    const Buffer block = support::makeBufferOf(m_gpu, std::vector{view});
    return drawSurface(m_gpu, m_raster, {support::uniformAt(kViewBinding, block)}, vertices,
                       support::makeTexture(m_gpu, size, kDepthFormat));
}

PeelPass::PeelPass(const VulkanContext& gpu)
    : m_gpu(gpu), m_raster(makeRaster(gpu, "surface.frag", kSurfaceImages, define("PEELED"),
                                      {{kViewBinding, vk::DescriptorType::eUniformBuffer},
                                       {kBeforeBinding, vk::DescriptorType::eCombinedImageSampler}})),
      m_sampler(support::makeSampler(gpu, vk::Filter::eNearest))
{
}

std::vector<Points> PeelPass::draw(const Buffer& vertices, const Light& light) const
{
    std::vector<Points> peels;
    for (int face = 0; face < light.faceCount(); ++face)
        drawFace(vertices, light, face, peels);
    return peels;
}

void PeelPass::drawFace(const Buffer& vertices, const Light& light, int face, std::vector<Points>& peels) const
{
    const support::Shape size{light.mapSize / 2, light.mapSize / 2};
    const glm::mat4 aside = glm::translate(glm::mat4(1.0f), kOffCentre * (2.0f / static_cast<float>(size.width)));
    const LightBlock& own = light.block;
    const View view{aside * own.faces[static_cast<std::size_t>(face)].viewProjection,
                    light.isSpot() ? own.position : -own.direction};
    const Buffer block = support::makeBufferOf(m_gpu, std::vector{view});
    const std::vector<float> nothing(size.count());
    Texture before = support::makeTexture(m_gpu, size, kDepthFormat, nothing.data(), nothing.size() * sizeof(float));
    for (std::size_t i = 0; i < kMostPeels; ++i)
    {
        Texture depth = support::makeTexture(m_gpu, size, kDepthFormat);
        const Surface surface = drawSurface(
            m_gpu, m_raster,
            {support::uniformAt(kViewBinding, block), support::sampledAt(kBeforeBinding, before.flat, m_sampler)},
            vertices, depth);
        if (peels.size() <= i)
            peels.emplace_back();
        if (!addReceivers(peels[i], readPoints(m_gpu, surface)))
            break;
        before = std::move(depth);
    }
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
