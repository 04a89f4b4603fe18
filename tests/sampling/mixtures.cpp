// The mixture passes, run by Vulkan: whole maps, component by component against C++, and the shares of their windows
// against brute force.
#include "mixtures_truth.hpp"

#include <cmath>
#include <map>

namespace sampling
{
namespace
{

constexpr vk::Format kMixtures = vk::Format::eR32G32B32A32Uint;

// The kernels of a device, by their settings: some take long to compile.
using Kernels = std::map<std::string, Kernel>;

// Where the depths lie on the device, and what runs over them.
class MixtureMaker
{
public:
    MixtureMaker(VulkanContext& context, const Form& form, Kernels& kernels, const MixtureCase& test,
                 const DepthOf& depth)
        : m_context(context), m_form(form), m_kernels(kernels), m_test(test),
          m_passes(lvsm::mixturePassesOf(test.window(), test.map, test.region, test.slice)),
          m_sampler(makeSampler(context, vk::Filter::eNearest))
    {
        Pixels pixels(test.depths.width, test.depths.height);
        for (int y = 0; y < test.depths.height; ++y)
        {
            for (int x = 0; x < test.depths.width; ++x)
                pixels.at(x, y).x = depth(x, y);
        }
        m_depths = makeTexture(context, pixels);
    }

    const lvsm::MixturePasses& passes() const { return m_passes; }

    // What each pass writes. The last one's are codes, or mixtures as the others' are.
    std::vector<Texture> run(bool toMixtures) const
    {
        std::vector<Texture> targets;
        for (int i = 0; i < m_passes.count; ++i)
        {
            const bool isLast = i + 1 == m_passes.count;
            const bool isCoded = isLast && !toMixtures;
            Shape shape = isLast ? m_test.coded() : Shape{m_passes.between.width, m_passes.between.height};
            shape.slices = isCoded ? m_test.slice + 1 : 4;
            Texture target = cleared(shape, isCoded && m_test.count == 2 ? vk::Format::eR32G32Uint : kMixtures);
            pass(m_passes.passes[i], i > 0 ? *targets.back().array : *m_depths.flat, i > 0, target, isCoded);
            targets.push_back(std::move(target));
        }
        return targets;
    }

private:
    Texture cleared(const Shape& shape, vk::Format format) const
    {
        const std::vector<std::uint32_t> zeros(shape.count() * (format == kMixtures ? 4 : 2));
        return makeTexture(m_context, shape, format, zeros.data(), zeros.size() * sizeof(std::uint32_t));
    }

    void pass(const lvsm::Pass<lvsm::MixingBlock>& pass, vk::ImageView source, bool fromMixtures, const Texture& target,
              bool toCodes) const
    {
        const bool hlsl = m_form.isHlsl();
        std::string macros = "#define LVSM_MIXTURE_COUNT " + std::to_string(m_test.count) + "\n";
        macros += fromMixtures ? "#define LVSM_MIXTURE_FROM_MIXTURES\n" : "";
        macros += toCodes ? "" : "#define LVSM_MIXTURE_TO_MIXTURES\n";
        const std::string path =
            hlsl ? m_form.hlslFolder + "/lvsm/passes/mixture.hlsl" : m_form.glslFolder + "/lvsm/passes/mixture.comp";
        const Shader shader =
            compile(m_form, path, vk::ShaderStageFlagBits::eCompute, hlsl ? "lvsm_mixtureCompute" : "main", macros);
        const Buffer block = makeBufferOf(m_context, std::vector{pass.block});
        using Type = vk::DescriptorType;
        const Binding read{
            0, hlsl ? Type::eSampledImage : Type::eCombinedImageSampler, {}, source, hlsl ? vk::Sampler() : *m_sampler};
        const std::vector<Binding> bindings{read, storageAt(1, target.array), uniformAt(2, block)};
        const Kernel& kernel = m_kernels.try_emplace(macros, m_context, shader, bindings).first->second;
        kernel.run(bindings, static_cast<std::uint32_t>(pass.groups.x), static_cast<std::uint32_t>(pass.groups.y), 1);
    }

    VulkanContext& m_context;
    const Form& m_form;
    Kernels& m_kernels;
    const MixtureCase& m_test;
    lvsm::MixturePasses m_passes;
    vk::raii::Sampler m_sampler;
    Texture m_depths;
};

std::vector<std::uint32_t> readWords(VulkanContext& context, const Texture& texture, std::size_t words)
{
    const Buffer bytes = readBytes(context, texture, words * sizeof(std::uint32_t));
    const auto* first = reinterpret_cast<const std::uint32_t*>(bytes.data);
    return {first, first + words * texture.size.count()};
}

// What a pass wrote over its region.
Mixtures writtenBy(VulkanContext& context, const lvsm::Pass<lvsm::MixingBlock>& pass, const Texture& target)
{
    const auto texels = readTexels<Packed>(context, target);
    const auto& block = pass.block;
    Mixtures written({block.region[0], block.region[1], pass.region.width, pass.region.height});
    for (std::size_t i = 0; i < written.texels.size(); ++i)
    {
        const int x = static_cast<int>(i) % pass.region.width + pass.region.x;
        const int y = static_cast<int>(i) / pass.region.width + pass.region.y;
        for (int k = 0; k < 4; ++k)
            written.texels[i].packed[static_cast<std::size_t>(k)] = texels[target.size.indexOf(x, y, k, 0)];
    }
    return written;
}

// Each pass against C++, which begins with what the pass before wrote on the device.
bool checkComponents(VulkanContext& context, const Form& form, Kernels& kernels, const MixtureCase& test,
                     const DepthOf& depth)
{
    const MixtureMaker maker(context, form, kernels, test, depth);
    const auto targets = maker.run(true);
    Comparison comparison(test.name);
    std::size_t same = 0, all = 0, compared = 0;
    for (int i = 0; i < maker.passes().count; ++i)
    {
        const auto& pass = maker.passes().passes[i];
        const int halo = (pass.block.steps[0] + pass.block.steps[1]) * pass.block.spacing;
        const Mixtures made = writtenBy(context, pass, targets[static_cast<std::size_t>(i)]);
        const Mixtures source =
            i > 0 ? writtenBy(context, maker.passes().passes[i - 1], targets[static_cast<std::size_t>(i - 1)])
                  : depthMixtures(test, lvsm::detail::grown(made.area, halo, halo), depth);
        const Mixtures expected = mixedTwice(test, source, pass.block);
        all += made.texels.size();
        const auto [told, equal] = compareComponents(comparison, made, expected, test.count);
        compared += told;
        same += equal;
    }
    const bool isEnough = 10 * compared > all;
    std::printf("%s %zu of %zu texels without a near tie, %zu of them to the bit\n", isEnough ? "    " : "FAIL",
                compared, all, same);
    return comparison.passed() && isEnough;
}

// Of a surface over ground, both level, that ends in a corner: the share of it at every texel, which no merging touches.
bool checkWindow(VulkanContext& context, const Form& form, Kernels& kernels, MixtureCase test)
{
    constexpr int kRight = 23, kBottom = 17;
    const auto corner = [](int x, int y)
    {
        return x < kRight && y < kBottom ? 0.25f : 0.75f;
    };
    test.depths = {44, 38};
    test.map = test.region = {0, 0, 44, 38};
    const MixtureMaker maker(context, form, kernels, test, corner);
    const auto targets = maker.run(true);
    Mixtures made = writtenBy(context, maker.passes().passes[maker.passes().count - 1], targets.back());
    const std::vector<double> weights = windowWeights(test.window());
    const int texels = test.half ? 2 : 1;
    const int reach = (static_cast<int>(weights.size()) / texels - 1) / 2;
    const auto shareBelow = [&](int texel, int end)
    {
        const int first = texels * (texel - reach);
        double share = 0;
        for (std::size_t i = 0; i < weights.size(); ++i)
        {
            const int at = first + static_cast<int>(i);
            share += at >= 0 && at < end ? weights[i] : 0;
        }
        return share;
    };
    const int packings = 1 + 2 * test.window().rounds;
    Comparison comparison(test.name);
    for (int y = 0; y < made.area.height; ++y)
    {
        for (int x = 0; x < made.area.width; ++x)
        {
            double share = 0;
            for (const Packed& packed : made.at(x, y).packed)
                share += unpacked(packed).depth < 0.5 ? unpacked(packed).weight : 0;
            // Each packing rounds the root of a weight of at most 1 by half of one of 3072 levels.
            comparison.expect(share, shareBelow(x, kRight) * shareBelow(y, kBottom), packings / 3072.0,
                              std::to_string(x) + ' ' + std::to_string(y));
        }
    }
    return comparison.passed();
}

// Codes are what encodeMixture makes of the mixtures, in the rectangle alone, and so is what is read from them.
bool checkCodes(VulkanContext& context, const Form& form, Kernels& kernels, const MixtureCase& test)
{
    const MixtureMaker maker(context, form, kernels, test, barDepth);
    const auto& last = maker.passes().passes[maker.passes().count - 1];
    const Mixtures mixtures = writtenBy(context, last, maker.run(true).back());
    const auto targets = maker.run(false);
    const Texture& target = targets.back();
    const std::size_t words = test.count == 2 ? 2 : 4;
    const auto codes = readWords(context, target, words);
    Comparison comparison(test.name);
    std::size_t same = 0;
    for (int i = 0; i < target.size.width * target.size.height * target.size.slices; ++i)
    {
        const int x = i % target.size.width;
        const int y = i / target.size.width % target.size.height;
        const int slice = i / target.size.width / target.size.height;
        const lvsm::Rectangle& r = last.region;
        const bool isWritten = slice == test.slice && x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height;
        glm::uvec4 expected(0u);
        if (isWritten)
            expected = trueCode(test, mixtures.texels[static_cast<std::size_t>((y - r.y) * r.width + x - r.x)]);
        Packed made{};
        for (std::size_t w = 0; w < words; ++w)
            made[w] = codes[static_cast<std::size_t>(i) * words + w];
        same += compareCode(comparison, test.count, made, expected, isWritten ? 1 : 0,
                            std::to_string(x) + ' ' + std::to_string(y))
                    ? 1
                    : 0;
    }
    std::printf("     %zu codes of %zu to the bit\n", same, codes.size() / words);
    return comparison.passed();
}

} // namespace

bool checkMixtures(VulkanContext& context, const Form& form)
{
    Kernels kernels;
    bool passed = true;
    for (const int count : {4, 2})
    {
        const std::string planes = std::to_string(count) + " components, width ";
        for (const bool half : {false, true})
        {
            for (const int width : {1, 3, 7, 15})
            {
                const MixtureCase test{planes + std::to_string(width) + (half ? ", half" : ""), count, width, half};
                passed = checkComponents(context, form, kernels, test, noiseDepth) && passed;
                passed = checkComponents(context, form, kernels, test, barDepth) && passed;
            }
            MixtureCase codes{"codes of " + planes + "7" + (half ? ", half" : ""), count, 7, half};
            passed = checkCodes(context, form, kernels, codes) && passed;
            codes = {"codes of " + planes + "by deviation, a part" + (half ? ", half" : ""), count, 0, half};
            codes.deviation = half ? 5.0f : 2.6f;
            codes.map = {4, 2, 21, 17};
            codes.region = {7, 2, 11, 30};
            codes.slice = 1;
            passed = checkCodes(context, form, kernels, codes) && passed;
            codes.deviation = half ? 0.0f : 2.6f;
            codes.width = 11;
            passed = checkComponents(context, form, kernels, codes, noiseDepth) && passed;
            MixtureCase narrow{planes + "by deviation" + (half ? ", half" : ""), count, 0, half};
            narrow.deviation = half ? 1.6f : 0.6f;
            passed = checkComponents(context, form, kernels, narrow, barDepth) && passed;
        }
    }
    return passed;
}

bool checkMixtureWindows(VulkanContext& context, const Form& form)
{
    Kernels kernels;
    bool passed = true;
    for (int width = 1; width <= lvsm::kMaxMixtureWidth; width += 2)
    {
        for (const bool half : {false, true})
        {
            const std::string name = "window of width " + std::to_string(width) + (half ? ", half" : "");
            passed = checkWindow(context, form, kernels, {name, 4, width, half}) && passed;
        }
    }
    for (const float deviation : {0.6f, 1.2f, 3.0f})
    {
        for (const bool half : {false, true})
        {
            MixtureCase test{"window of deviation " + std::to_string(deviation) + (half ? ", half" : ""), 4, 0, half};
            test.deviation = deviation;
            passed = checkWindow(context, form, kernels, test) && passed;
        }
    }
    return passed;
}

} // namespace sampling
