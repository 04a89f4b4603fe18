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

std::vector<std::uint32_t> compileStep(const Technique& technique, const std::string& step)
{
    const std::string text =
        "#version 450\n#include \"" + technique.shader + ".glsl\"\n#include \"" + step + ".glsl\"\n";
    const std::string preamble = "#define STORAGE_FORMAT " + technique.qualifier + "\n";
    return compileText(text, support::ShaderStage::Compute, preamble);
}

std::vector<std::uint32_t> compileBlur(const Technique& technique)
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

std::vector<float> placeSplits(const std::vector<float>& depths, vk::Extent2D extent, int layerCount)
{
    std::vector<float> splits(static_cast<std::size_t>(layerCount) + 1);
    RelaxOptions<float> options;
    options.minVariance = kLeastBleedingVariance;
    const auto result = lloydRelax(depths.data(), static_cast<int>(extent.width), static_cast<int>(extent.height),
                                   splits.data(), layerCount, options);
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
      m_encode(gpu, compileStep(technique, "encode"),
               {Type::eUniformBuffer, Type::eUniformBuffer, Type::eCombinedImageSampler, Type::eStorageImage}),
      m_receive(gpu, compileStep(technique, "receive"),
                {Type::eUniformBuffer, Type::eUniformBuffer, Type::eCombinedImageSampler, Type::eCombinedImageSampler,
                 Type::eStorageImage})
{
    if (technique.filtered)
    {
        m_blur.emplace(gpu, compileBlur(technique), std::vector{Type::eCombinedImageSampler, Type::eStorageImage},
                       static_cast<std::uint32_t>(sizeof(glm::ivec2)));
    }
}

std::vector<glm::vec2> TechniqueRunner::run(const Buffer& light, const TechniqueBlock& block, const Image& depthMap,
                                            const Image& positions) const
{
    using Usage = vk::ImageUsageFlagBits;
    const Buffer uniforms = makeUniform(m_gpu, block);
    const std::uint32_t texels = m_technique.texels;
    const vk::Extent2D extent = depthMap.extent;
    const Image stored = makeImage(m_gpu, m_technique.format, extent, texels, Usage::eSampled | Usage::eStorage);
    m_encode.run({Uniform{light}, Uniform{uniforms}, Sampled{depthMap}, Storage{stored}}, extent, texels);
    if (m_blur)
    {
        const Image halfway = makeImage(m_gpu, m_technique.format, extent, texels, Usage::eSampled | Usage::eStorage);
        const glm::ivec2 rows(1, 0);
        const glm::ivec2 columns(0, 1);
        m_blur->run({Sampled{stored}, Storage{halfway}}, extent, texels, &rows);
        m_blur->run({Sampled{halfway}, Storage{stored}}, extent, texels, &columns);
    }
    const Image result =
        makeImage(m_gpu, vk::Format::eR32G32Sfloat, positions.extent, 1, Usage::eStorage | Usage::eTransferSrc);
    m_receive.run({Uniform{light}, Uniform{uniforms}, Sampled{stored}, Sampled{positions}, Storage{result}},
                  positions.extent);
    return readImage<glm::vec2>(m_gpu, result);
}

} // namespace lvsm::gallery
