#include "placer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lvsm::gallery
{
namespace
{

using Type = vk::DescriptorType;

// Where depths differ by less than a fifth of the range, (1/5)^2 / 4, there is little to bleed. Leaving them out keeps
// the splits from being drawn into the crown of a tree.
constexpr float kLeastBleedingVariance = 0.01f;

// Of a sum of floats, as optimalPass promises: what is better by less may as well be missed.
constexpr float kPrecision = 1.0f / (1 << 20);

constexpr std::uint32_t kSeenBinding = 5;

std::vector<support::Binding> layout(bool isByScreen = false)
{
    auto types = std::vector{Type::eCombinedImageSampler, Type::eStorageBuffer, Type::eUniformBuffer,
                             Type::eStorageBuffer, Type::eUniformBuffer};
    if (isByScreen)
        types.push_back(Type::eCombinedImageSampler);
    return bindingsOf(types);
}

std::string weightsMacro()
{
    return define("LVSM_PLACE_WEIGHTS", "layout(binding = " + std::to_string(kSeenBinding) + ")");
}

std::vector<float> uniformSplits(int layerCount)
{
    std::vector<float> splits;
    for (int i = 0; i <= layerCount; ++i)
        splits.push_back(static_cast<float>(i) / static_cast<float>(layerCount));
    return splits;
}

float largestDifference(const std::vector<float>& some, const std::vector<float>& others)
{
    float difference = 0.0f;
    for (std::size_t i = 0; i < some.size(); ++i)
        difference = std::max(difference, std::abs(some[i] - others[i]));
    return difference;
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

// What the placement is asked for, on the host as on the device.
RelaxOptions<float> relaxing()
{
    RelaxOptions<float> options;
    options.minVariance = kLeastBleedingVariance;
    return options;
}

} // namespace

Placer::Placer(const VulkanContext& gpu)
    : m_gpu(gpu), m_see(gpu, compile("seen.comp", support::ShaderStage::Compute),
                        bindingsOf({Type::eUniformBuffer, Type::eCombinedImageSampler, Type::eCombinedImageSampler,
                                    Type::eStorageImage})),
      m_count(gpu, compilePass("place_histogram.comp", depthMacro()), layout()),
      m_countSeen(gpu, compilePass("place_histogram.comp", depthMacro() + weightsMacro()), layout(true)),
      m_place(gpu, compilePass("place.comp", ""), layout()), m_sampler(support::makeSampler(gpu, vk::Filter::eNearest))
{
}

Texture Placer::countSeen(const Buffer& lightBlock, const LightDepths& depths, const Surface& surface,
                          const support::Shape& size) const
{
    const support::Shape& map = depths.buffer.size;
    const std::vector<std::uint32_t> none(map.count());
    Texture seen =
        support::makeTexture(m_gpu, map, vk::Format::eR32Uint, none.data(), none.size() * sizeof(std::uint32_t));
    runOver(m_see,
            {support::uniformAt(0, lightBlock), support::sampledAt(1, surface.positions().array, m_sampler),
             support::sampledAt(2, surface.planeNormals().array, m_sampler), support::storageAt(3, seen.array)},
            size);
    return seen;
}

Buffer Placer::place(const Technique& technique, const Scene& scene, const Light& light, const LightDepths& depths,
                     const std::optional<Texture>& seen) const
{
    const Layers& layers = technique.layers;
    const bool layered = layers.placing != Placing::None;
    const std::vector<float> start =
        layers.placing == Placing::Manual ? splitsAt(scene.cuts, light, layers.count) : uniformSplits(layers.count);
    const int count = layered ? layers.count : 0;
    Buffer splits =
        support::makeBufferOf(m_gpu, std::vector{storePass(start.data(), count, layers.overlap, depths.area()).block});
    if (layers.placing == Placing::Relaxed || layers.placing == Placing::InView)
        run(relaxPass(count, depths.area(), relaxing()), depths, splits, seen);
    if (layers.placing == Placing::Optimal)
        run(optimalPass(count, depths.area()), depths, splits);
    return splits;
}

void Placer::run(const PlacePass& pass, const LightDepths& depths, const Buffer& splits,
                 const std::optional<Texture>& seen) const
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
        if (seen)
        {
            const auto view = support::makeSliceView(m_gpu, *seen, face);
            auto withSeen = bindings;
            withSeen.push_back(support::sampledAt(kSeenBinding, view, m_sampler));
            runPass(m_countSeen, withSeen, pass.groups);
        }
        else
            runPass(m_count, bindings, pass.groups);
        if (face + 1 == depths.faceCount())
            runPass(m_place, bindings, {1, 1, 1});
    }
}

Differences Placer::compareWithHost(int layerCount, const LightDepths& depths) const
{
    const std::vector<float> image = support::readTexels<float>(m_gpu, depths.linear);
    const Rectangle area = depths.area();
    const auto optimise = [&](std::vector<float>& splits, float leastGain)
    {
        OptimalOptions<float> options;
        options.maxSamples = 0; // the device reads every texel
        options.leastGain = leastGain;
        return optimalSplits(image.data(), area.width, area.height, splits.data(), layerCount, options);
    };
    std::vector<float> relaxed = uniformSplits(layerCount);
    std::vector<float> optimal = relaxed;
    if (!lloydRelax(image.data(), area.width, area.height, relaxed.data(), layerCount, relaxing()) ||
        !optimise(optimal, 0.0f))
        throw std::runtime_error("the host cannot place layers for this map");
    std::vector<float> placed = placedBy(optimalPass(layerCount, area), depths);
    const float optimalDifference = largestDifference(placed, optimal);
    return {largestDifference(placedBy(relaxPass(layerCount, area, relaxing()), depths), relaxed), optimalDifference,
            optimise(placed, kPrecision).status == OptimalStatus::Kept};
}

std::vector<float> Placer::placedBy(const PlacePass& pass, const LightDepths& depths) const
{
    const int layerCount = pass.block.layerCount;
    const Buffer splits = support::makeBufferOf(
        m_gpu, std::vector{storePass(uniformSplits(layerCount).data(), layerCount, 0.0f, depths.area()).block});
    run(pass, depths, splits);
    return readSplits(splits, layerCount);
}

std::vector<float> readSplits(const Buffer& storeBlock, int layerCount)
{
    const auto* block = reinterpret_cast<const StoreBlock*>(storeBlock.data);
    return {block->splits, block->splits + layerCount + 1};
}

} // namespace lvsm::gallery
