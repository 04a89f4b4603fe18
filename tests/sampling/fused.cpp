// The store pass and the first direction of the blur in one, against the definition of both.
#include "passes_truth.hpp"

namespace sampling
{
namespace
{

constexpr float kSplits[] = {0, 0.25f, 0.625f, 1};
constexpr int kLayers = 3;
constexpr float kOverlap = 0.0625f;
// More than a group is wide, and more than it is high.
constexpr Shape kSize{150, 11, kSlices};

glm::dvec4 storedTexel(double depth, int slice)
{
    const auto moments = [&](int layer)
    {
        if (layer >= kLayers)
            return glm::dvec2(1, 1);
        const double begin = static_cast<double>(kSplits[layer]);
        const double end = static_cast<double>(kSplits[layer + 1]);
        return lvsm::layerMoments(depth, lvsm::layerInterval(begin, end, static_cast<double>(kOverlap)));
    };
    return lvsm::packLayers(moments(2 * slice), moments(2 * slice + 1));
}

Shader shaderOf(const Form& form)
{
    const std::string path =
        form.isHlsl() ? form.hlslFolder + "/lvsm/passes/fused.hlsl" : form.glslFolder + "/lvsm/passes/fused.comp";
    return compile(form, path, vk::ShaderStageFlagBits::eCompute, form.isHlsl() ? "lvsm_fusedCompute" : "main",
                   form.isHlsl() ? "" : "#define LVSM_STORE_FORMAT rgba32f\n");
}

Pixels runFused(VulkanContext& context, const Form& form, const Pixels& depths, const lvsm::FusedPasses& passes)
{
    const Texture source = makeTexture(context, depths);
    const Texture target = makeTexture(context, Pixels(kSize.width, kSize.height, kSlices));
    const auto sampler = makeSampler(context, vk::Filter::eNearest);
    const Buffer store = makeBufferOf(context, std::vector{passes.store.block});
    const Buffer fused = makeBufferOf(context, std::vector{passes.fused});
    using Type = vk::DescriptorType;
    const Binding read{0,
                       form.isHlsl() ? Type::eSampledImage : Type::eCombinedImageSampler,
                       {},
                       *source.flat,
                       form.isHlsl() ? vk::Sampler() : *sampler};
    dispatch(context, shaderOf(form), {read, storageAt(1, target.array), uniformAt(2, store), uniformAt(3, fused)},
             static_cast<std::uint32_t>(passes.store.groups.x), static_cast<std::uint32_t>(passes.store.groups.y), 1);
    return readBack(context, target);
}

bool checkKernel(VulkanContext& context, const Form& form, const std::string& name, const Blur& blur)
{
    const lvsm::Rectangle map = blur.map;
    Pixels depths(kSize.width, kSize.height);
    Random random;
    for (glm::vec4& texel : depths.texels)
        texel.x = random.next();
    const auto passes = lvsm::fusedPasses(blur.kernel, kSplits, kLayers, kOverlap, map, blur.region, kBorder);
    const Pixels result = runFused(context, form, depths, passes);
    const lvsm::Rectangle region = passes.store.region;
    Comparison comparison(name);
    for (int i = 0; i < kSize.width * kSize.height * kSlices; ++i)
    {
        const int x = i % kSize.width;
        const int y = i / kSize.width % kSize.height;
        const int slice = i / kSize.width / kSize.height;
        const bool written =
            x >= region.x && x < region.x + region.width && y >= region.y && y < region.y + region.height;
        glm::dvec4 expected(0);
        for (int tap = 0; tap < blur.kernel.size && written; ++tap)
        {
            const int at = x + tap - blur.kernel.size / 2;
            const bool inside = at >= map.x && at < map.x + map.width;
            expected += blur.weight(tap) *
                        (inside ? storedTexel(static_cast<double>(depths.at(at, y).x), slice) : glm::dvec4(kBorder));
        }
        for (int c = 0; c < 4; ++c)
            // Ten units of one division and a square of each texel, and of values up to 4 the rounding of a weight, a
            // product and the sum.
            comparison.expect(static_cast<double>(result.at(x, y, slice)[c]), expected[c], (40.0 + 4 * 12) / (1 << 23),
                              std::to_string(x) + ' ' + std::to_string(y) + " slice " + std::to_string(slice));
    }
    return comparison.passed();
}

} // namespace

bool checkFused(VulkanContext& context, const Form& form)
{
    const lvsm::Rectangle whole{0, 0, kSize.width, kSize.height};
    Blur binomial = binomialBlur();
    binomial.map = whole;
    binomial.region = whole;
    Blur box = boxBlur();
    box.map = {3, 1, 140, 9};
    box.region = {20, 3, 77, 4};
    Blur widest{lvsm::gaussianKernel(65, 12, false), [](int i) { return lvsm::gaussianWeight(i, 65, 12.0); }, whole,
                whole};
    bool passed = checkKernel(context, form, "fused, 9 taps in pairs", binomial);
    passed = checkKernel(context, form, "fused, a part of a map", box) && passed;
    return checkKernel(context, form, "fused, 65 taps", widest) && passed;
}

} // namespace sampling
