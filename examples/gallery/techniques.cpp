#include "techniques.hpp"

#include <algorithm>
#include <stdexcept>

#include <lvsm/lvsm.hpp>

namespace lvsm::gallery
{
namespace
{

using Type = vk::DescriptorType;

// How much of the light a lit flat receiver may lose to the rounding of what is stored.
constexpr float kWorstDarkening = 0.01f;
// Encoding and two blur passes each round once.
constexpr float kRoundings = 3.0f;
constexpr float kBiasMetres = 0.004f;
constexpr float kUnfilteredBiasMetres = 0.02f;
constexpr float kOverlap = 0.01f;
constexpr float kTransition = 0.01f;
// Where depths differ by less than a fifth of the range, (1/5)^2 / 4, there is little to bleed. Leaving them out keeps
// the splits from being drawn into the crown of a tree.
constexpr float kLeastBleedingVariance = 0.01f;
// The negative warp only has to smooth where the positive one fails, and is less exact for it.
constexpr float kNegativeExponent = 10.0f;

support::Shader compileStep(const Technique& technique, const std::string& step)
{
    const std::string text =
        "#version 450\n#include \"" + technique.shader + ".glsl\"\n#include \"" + step + ".glsl\"\n";
    const std::string preamble = "#define STORAGE_FORMAT " + technique.qualifier + "\n";
    return compileText(text, support::ShaderStage::Compute, preamble);
}

support::Shader compileBlur(const Technique& technique)
{
    const std::string preamble = "#define STORAGE_FORMAT " + technique.qualifier + "\n";
    return compile("blur.comp", support::ShaderStage::Compute, preamble);
}

float depthError(const Technique& technique)
{
    const bool is16Bit = technique.format == vk::Format::eR16G16B16A16Unorm;
    return is16Bit ? kDepthErrorUnorm16<float> : kDepthErrorFp32<float>;
}

} // namespace

const std::vector<Technique>& techniques()
{
    constexpr auto rgba16 = vk::Format::eR16G16B16A16Unorm;
    static const std::vector<Technique> all{
        {"basic", "Shadow map", "One comparison with the nearest texel: hard and jagged edges.", "one 32-bit float", 32,
         vk::Format::eR32Sfloat, "r32f", 1, "basic", false, 1},
        {"vsm", "VSM", "Chebyshev's bound from two moments: soft, but too light where shadows overlap.",
         "two 32-bit floats", 64, vk::Format::eR32G32Sfloat, "rg32f", 1, "vsm", true, 1},
        {"lvsm2", "LVSM-2", "Two layers of two moments; a surface reads the layer that it lies in.",
         "four 16-bit fixed point", 64, rgba16, "rgba16", 1, "lvsm_layers", true, 2},
        {"lvsm4", "LVSM-4", "Four layers in twice the storage; a surface still reads one, near a split two.",
         "eight 16-bit fixed point", 128, rgba16, "rgba16", 2, "lvsm_layers", true, 4},
        {"evsm4", "EVSM4", "The lesser of the bounds from a positive and a negative exponential warp.",
         "four 32-bit floats", 128, vk::Format::eR32G32B32A32Sfloat, "rgba32f", 1, "evsm4", true, 1},
    };
    return all;
}

std::vector<float> placeSplits(const std::vector<float>& depths, const support::Shape& size, int layerCount)
{
    std::vector<float> splits(static_cast<std::size_t>(layerCount) + 1);
    RelaxOptions<float> options;
    options.minVariance = kLeastBleedingVariance;
    const auto result = lloydRelax(depths.data(), size.width, size.height, splits.data(), layerCount, options);
    if (!result)
        throw std::runtime_error(std::string("placing the layers: ") + describe(result.status));
    return splits;
}

TechniqueBlock parameters(const Technique& technique, const Light& light, const std::vector<float>& splits)
{
    const float metre = 1.0f / light.metresPerDepth();
    TechniqueBlock block;
    block.exponents = {maxExponent(kLargestFp32<float>, 1.0f), kNegativeExponent};
    block.minVariance = recommendedMinVariance(kRoundings * depthError(technique), kWorstDarkening);
    block.bias = metre * (technique.filtered ? kBiasMetres : kUnfilteredBiasMetres);
    block.overlap = kOverlap;
    block.transition = kTransition;
    block.layerCount = technique.layerCount;
    for (std::size_t i = 0; i < splits.size(); ++i)
        block.splits[i].x = splits[i];
    return block;
}

TechniqueRunner::TechniqueRunner(const VulkanContext& gpu, const Technique& technique)
    : m_gpu(gpu), m_technique(technique),
      m_encode(
          gpu, compileStep(technique, "encode"),
          bindingsOf({Type::eUniformBuffer, Type::eUniformBuffer, Type::eCombinedImageSampler, Type::eStorageImage})),
      m_receive(gpu, compileStep(technique, "receive"),
                bindingsOf({Type::eUniformBuffer, Type::eUniformBuffer, Type::eCombinedImageSampler,
                            Type::eCombinedImageSampler, Type::eStorageImage})),
      m_sampler(support::makeSampler(gpu))
{
    if (technique.filtered)
    {
        m_blur.emplace(gpu, compileBlur(technique),
                       bindingsOf({Type::eCombinedImageSampler, Type::eStorageImage, Type::eUniformBuffer}));
    }
}

std::vector<glm::vec2> TechniqueRunner::run(const Buffer& light, const TechniqueBlock& block, const Texture& depthMap,
                                            const Texture& positions) const
{
    using namespace support;
    const Buffer uniforms = makeBufferOf(m_gpu, std::vector{block});
    const int texels = m_technique.texels;
    const Shape size{depthMap.size.width, depthMap.size.height, texels};
    const Texture stored = makeTexture(m_gpu, size, m_technique.format);
    runOver(m_encode,
            {uniformAt(0, light), uniformAt(1, uniforms), sampledAt(2, depthMap.array, m_sampler),
             storageAt(3, stored.array)},
            size, texels);
    if (m_blur)
    {
        const Texture halfway = makeTexture(m_gpu, size, m_technique.format);
        const Buffer rows = makeBufferOf(m_gpu, std::vector{glm::ivec4(1, 0, 0, 0)});
        const Buffer columns = makeBufferOf(m_gpu, std::vector{glm::ivec4(0, 1, 0, 0)});
        runOver(*m_blur, {sampledAt(0, stored.array, m_sampler), storageAt(1, halfway.array), uniformAt(2, rows)}, size,
                texels);
        runOver(*m_blur, {sampledAt(0, halfway.array, m_sampler), storageAt(1, stored.array), uniformAt(2, columns)},
                size, texels);
    }
    const Texture result = makeTexture(m_gpu, positions.size, vk::Format::eR32G32Sfloat);
    runOver(m_receive,
            {uniformAt(0, light), uniformAt(1, uniforms), sampledAt(2, stored.array, m_sampler),
             sampledAt(3, positions.array, m_sampler), storageAt(4, result.array)},
            result.size);
    return readTexels<glm::vec2>(m_gpu, result);
}

} // namespace lvsm::gallery
