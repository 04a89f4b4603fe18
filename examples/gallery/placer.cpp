#include "placer.hpp"

#include <algorithm>

namespace lvsm::gallery
{
namespace
{

using Type = vk::DescriptorType;

// Where depths differ by less than a fifth of the range, (1/5)^2 / 4, there is little to bleed. Leaving them out keeps
// the splits from being drawn into the crown of a tree.
constexpr float kLeastBleedingVariance = 0.01f;

std::vector<support::Binding> layout()
{
    return bindingsOf({Type::eCombinedImageSampler, Type::eStorageBuffer, Type::eUniformBuffer, Type::eStorageBuffer,
                       Type::eUniformBuffer});
}

std::vector<float> uniformSplits(int layerCount)
{
    std::vector<float> splits;
    for (int i = 0; i <= layerCount; ++i)
        splits.push_back(static_cast<float>(i) / static_cast<float>(layerCount));
    return splits;
}

std::vector<float> splitsAt(const std::vector<glm::vec3>& points, const Light& light, int layerCount)
{
    std::vector<float> splits{0.0f};
    for (const glm::vec3 point : points)
        splits.push_back(glm::clamp(light.depthOf(point), 0.0f, 1.0f));
    splits.resize(static_cast<std::size_t>(layerCount), 1.0f);
    splits.push_back(1.0f);
    std::sort(splits.begin(), splits.end());
    return splits;
}

} // namespace

RelaxOptions<float> relaxing()
{
    RelaxOptions<float> options;
    options.minVariance = kLeastBleedingVariance;
    return options;
}

Placer::Placer(const VulkanContext& gpu)
    : m_gpu(gpu), m_count(gpu, compilePass("place_histogram.comp", depthMacro()), layout()),
      m_place(gpu, compilePass("place.comp", ""), layout()), m_sampler(support::makeSampler(gpu, vk::Filter::eNearest))
{
}

Buffer Placer::place(const Technique& technique, const Scene& scene, const Light& light,
                     const LightDepths& depths) const
{
    const Layers& layers = technique.layers;
    const bool layered = layers.placing != Placing::None;
    const std::vector<float> start =
        layers.placing == Placing::Manual ? splitsAt(scene.cuts, light, layers.count) : uniformSplits(layers.count);
    const int count = layered ? layers.count : 0;
    Buffer splits =
        support::makeBufferOf(m_gpu, std::vector{storePass(start.data(), count, layers.overlap, depths.area()).block});
    if (layers.placing == Placing::Relaxed)
        run(relaxPass(count, depths.area(), relaxing()), depths, splits);
    if (layers.placing == Placing::Optimal)
        run(optimalPass(count, depths.area()), depths, splits);
    return splits;
}

void Placer::run(const PlacePass& pass, const LightDepths& depths, const Buffer& splits) const
{
    const Buffer block = support::makeBufferOf(m_gpu, std::vector{pass.block});
    const Buffer histogram =
        support::makeBufferOf(m_gpu, std::vector<std::uint32_t>(pass.histogramBytes / sizeof(std::uint32_t)));
    for (int face = 0; face < depths.faceCount(); ++face)
    {
        const std::vector<support::Binding> bindings{
            support::sampledAt(0, depths.faces[static_cast<std::size_t>(face)], m_sampler),
            support::bufferAt(1, histogram), support::uniformAt(2, block), support::bufferAt(3, splits),
            support::uniformAt(kDepthBlockBinding, depths.block)};
        runPass(m_count, bindings, pass.groups);
        if (face + 1 == depths.faceCount())
            runPass(m_place, bindings, {1, 1, 1});
    }
}

std::vector<float> readSplits(const Buffer& storeBlock, int layerCount)
{
    const auto* block = reinterpret_cast<const StoreBlock*>(storeBlock.data);
    return {block->splits, block->splits + layerCount + 1};
}

} // namespace lvsm::gallery
