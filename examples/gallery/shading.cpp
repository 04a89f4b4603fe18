#include "shading.hpp"

#include <algorithm>

#include <lvsm/moments.hpp>

namespace lvsm::gallery
{
namespace
{

using Type = vk::DescriptorType;

// How much of the light a lit flat receiver may lose to the rounding of what is stored.
constexpr float kWorstDarkening = 0.01f;
// Storing and two blur passes each round once.
constexpr float kRoundings = 3.0f;
constexpr float kBiasMetres = 0.004f;
constexpr std::size_t kMostTaps = 68;

// The uniform block of shaders/shade.comp.
struct ShadingBlock
{
    float bias;
    float transition;
    std::int32_t slicesOfFace;
    float unused;
};

// The uniform block of shaders/exact.comp.
struct WindowBlock
{
    std::int32_t reach;
    float extent;
    float falloff;
    float unused;
    float taps[kMostTaps];
};

bool isMixture(const Technique& technique)
{
    return technique.making == Making::Mixed;
}

support::Shader compileShading(const Technique& technique)
{
    const float floor = recommendedMinVariance(kRoundings * technique.texel->depthError, kWorstDarkening);
    return compile("shade.comp", support::ShaderStage::Compute,
                   define("MAP_TYPE", isMixture(technique) ? "usampler2DArray" : "sampler2DArray") +
                       define("MIN_VARIANCE", std::to_string(floor * 1e9f) + "e-9") +
                       define("VISIBILITY", technique.visibility));
}

std::vector<support::Binding> sampled(const std::vector<const Texture*>& textures, std::uint32_t first,
                                      const vk::raii::Sampler& sampler)
{
    std::vector<support::Binding> bindings;
    for (const Texture* texture : textures)
    {
        const auto index = first + static_cast<std::uint32_t>(bindings.size());
        bindings.push_back(support::sampledAt(index, texture->array, sampler));
    }
    return bindings;
}

} // namespace

TechniqueRunner::TechniqueRunner(const VulkanContext& gpu, const Technique& technique)
    : m_gpu(gpu), m_technique(technique), m_maps(makeMapMaker(gpu, technique)),
      m_shade(gpu, compileShading(technique),
              bindingsOf({Type::eUniformBuffer, Type::eUniformBuffer, Type::eUniformBuffer, Type::eCombinedImageSampler,
                          Type::eCombinedImageSampler, Type::eCombinedImageSampler, Type::eCombinedImageSampler,
                          Type::eCombinedImageSampler, Type::eCombinedImageSampler, Type::eStorageImage})),
      m_sampler(support::makeSampler(gpu, isMixture(technique) ? vk::Filter::eNearest : vk::Filter::eLinear))
{
}

std::vector<glm::vec2> TechniqueRunner::run(const Light& light, const Buffer& lightBlock, const LightDepths& depths,
                                            const Buffer& splits, const Surface& surface) const
{
    const Maps maps = m_maps->make(depths, splits);
    const ShadingBlock shading{kBiasMetres / light.metresPerDepth(), m_technique.layers.transition, m_technique.slices,
                               0.0f};
    const Buffer block = support::makeBufferOf(m_gpu, std::vector{shading});
    const Texture result = support::makeTexture(m_gpu, surface.positions().size, vk::Format::eR32G32Sfloat);
    // A wrapper that needs one map does not look at the others.
    auto bindings = sampled({&maps.map, maps.unfiltered ? &*maps.unfiltered : &depths.linear,
                             maps.greatest ? &*maps.greatest : &depths.linear, &surface.positions(), &surface.alongX(),
                             &surface.alongY()},
                            3, m_sampler);
    bindings.push_back(support::uniformAt(0, lightBlock));
    bindings.push_back(support::uniformAt(1, block));
    bindings.push_back(support::uniformAt(2, splits));
    bindings.push_back(support::storageAt(9, result.array));
    runOver(m_shade, bindings, result.size);
    return support::readTexels<glm::vec2>(m_gpu, result);
}

TruthFinder::TruthFinder(const VulkanContext& gpu)
    : m_gpu(gpu), m_exact(gpu, compile("exact.comp", support::ShaderStage::Compute),
                          bindingsOf({Type::eUniformBuffer, Type::eCombinedImageSampler, Type::eCombinedImageSampler,
                                      Type::eCombinedImageSampler, Type::eCombinedImageSampler, Type::eStorageImage,
                                      Type::eUniformBuffer})),
      m_sampler(support::makeSampler(gpu, vk::Filter::eNearest))
{
}

Truth TruthFinder::find(const Buffer& lightBlock, const LightDepths& depths, const Surface& surface,
                        const Window& window) const
{
    WindowBlock values{window.reach, window.extent, 0.0f, 0.0f, {}};
    if (window.deviation > 0.0f)
        values.falloff = 0.5f / (window.deviation * window.deviation);
    std::copy(window.taps.begin(), window.taps.end(), values.taps);
    const Buffer block = support::makeBufferOf(m_gpu, std::vector{values});
    const Texture result = support::makeTexture(m_gpu, surface.positions().size, vk::Format::eR32G32B32A32Sfloat);
    auto bindings = sampled({&surface.positions(), &surface.shadingNormals(), &surface.planeNormals(), &depths.linear},
                            1, m_sampler);
    bindings.push_back(support::uniformAt(0, lightBlock));
    bindings.push_back(support::storageAt(5, result.array));
    bindings.push_back(support::uniformAt(6, block));
    runOver(m_exact, bindings, result.size);
    return support::readTexels<glm::vec4>(m_gpu, result);
}

} // namespace lvsm::gallery
