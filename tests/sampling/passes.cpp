// The ready passes, run as they are, against the library's C++ functions.
#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <cstring>

namespace sampling
{
namespace
{

constexpr int kWidth = 13;
constexpr int kHeight = 9;
constexpr int kSlices = 2;

using Vec4 = glm::dvec4;

enum class Stage
{
    Compute,
    Fragment
};

// Two directions of a blur, or the making of a map, by one of the shader stages.
struct Pass
{
    const Form& form;
    Stage stage;
    std::string name;
    std::string macros;

    Shader shader() const
    {
        const bool compute = stage == Stage::Compute;
        const std::string file = form.isHlsl()
                                     ? form.hlslFolder + "/lvsm/passes/" + name + ".hlsl"
                                     : form.glslFolder + "/lvsm/passes/" + name + (compute ? ".comp" : ".frag");
        return compile(form, file, compute ? vk::ShaderStageFlagBits::eCompute : vk::ShaderStageFlagBits::eFragment,
                       form.isHlsl() ? "lvsm_" + name + (compute ? "Compute" : "Pixel") : "main", macros);
    }
};

// Uniform blocks as the passes declare them, in std140.
struct BlurBlock
{
    float direction[2];
    std::int32_t slice;
    std::int32_t unused;
};

struct StoreBlock
{
    float splits[12];
    std::int32_t layerCount;
    float overlap;
    std::int32_t slice;
    std::int32_t unused;
};

// Runs a pass over a whole target: all slices at once by compute, one after the other by drawing.
template <typename Block>
void run(VulkanContext& context, const Pass& pass, const Texture& source, bool sourceIsArray, vk::Sampler sampler,
         const Texture& target, Block block)
{
    const auto view = sourceIsArray ? *source.array : *source.flat;
    const bool hlsl = pass.form.isHlsl();
    const bool compute = pass.stage == Stage::Compute;
    const Shader shader = pass.shader();
    const Form glsl{"combined", pass.form.glslFolder, pass.form.hlslFolder, pass.form.kernelFolder, {}};
    const Shader vertex = compute ? Shader{}
                                  : compile(glsl, pass.form.kernelFolder + "/triangle.vert",
                                            vk::ShaderStageFlagBits::eVertex, "main", "");
    for (int slice = 0; slice < (compute ? 1 : target.size.slices); ++slice)
    {
        block.slice = slice;
        const Buffer uniform = makeBufferOf(context, std::vector<Block>{block});
        std::vector<Binding> bindings{{2, vk::DescriptorType::eUniformBuffer, *uniform.buffer}};
        if (hlsl)
            bindings.insert(bindings.end(), {{0, vk::DescriptorType::eSampledImage, {}, view},
                                             {3, vk::DescriptorType::eSampler, {}, {}, sampler}});
        else
            bindings.push_back({0, vk::DescriptorType::eCombinedImageSampler, {}, view, sampler});
        if (compute)
        {
            bindings.push_back({1, vk::DescriptorType::eStorageImage, {}, *target.array});
            dispatch(context, shader, bindings, (kWidth + 7) / 8, (kHeight + 7) / 8,
                     static_cast<std::uint32_t>(target.size.slices));
        }
        else
        {
            draw(context, vertex, shader, bindings, target, static_cast<std::uint32_t>(slice));
        }
    }
}

Pixels randomPixels(int slices)
{
    Pixels pixels(kWidth, kHeight, slices);
    Random random;
    for (glm::vec4& texel : pixels.texels)
        texel = {random.next(), random.next(), random.next(), random.next()};
    return pixels;
}

std::string describe(int x, int y, int slice)
{
    return std::to_string(x) + ' ' + std::to_string(y) + " slice " + std::to_string(slice);
}

template <typename Weight>
bool checkBlurOf(VulkanContext& context, const Pass& pass, int size, const Weight& weight)
{
    const Pixels pixels = randomPixels(kSlices);
    const Texture source = makeTexture(context, pixels);
    const Texture between = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const Texture target = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const auto sampler = makeSampler(context);
    run(context, pass, source, true, *sampler, between, BlurBlock{{1, 0}, 0, 0});
    run(context, pass, between, true, *sampler, target, BlurBlock{{0, 1}, 0, 0});
    const Pixels blurred = readBack(context, target);

    // A sampler places a fetch between two texels in steps of 2^-bits: of values in [0,1], each direction is off by at
    // most half a step. Both directions, and their rounding.
    const auto bits = context.physical.getProperties().limits.subTexelPrecisionBits;
    const double tolerance = std::ldexp(1.0, -static_cast<int>(bits)) + 1.0 / (1 << 20);
    Comparison comparison(pass.name + (pass.stage == Stage::Compute ? " compute" : " fragment"));
    for (int slice = 0; slice < kSlices; ++slice)
    {
        for (int i = 0; i < kWidth * kHeight; ++i)
        {
            const int x = i % kWidth;
            const int y = i / kWidth;
            Vec4 expected(0);
            for (int k = 0; k < size * size; ++k)
            {
                const int tapX = k % size;
                const int tapY = k / size;
                // The first pass clamps its rows, the second its columns: together a clamped window.
                expected +=
                    weight(tapX) * weight(tapY) * Vec4(pixels.at(x + tapX - size / 2, y + tapY - size / 2, slice));
            }
            for (int c = 0; c < 4; ++c)
                comparison.expect(static_cast<double>(blurred.at(x, y, slice)[c]), expected[c], tolerance,
                                  describe(x, y, slice));
        }
    }
    return comparison.passed();
}

template <typename Store>
bool checkStoreOf(VulkanContext& context, const Pass& pass, const Store& store)
{
    Pixels pixels = randomPixels(1);
    pixels.at(0, 0).x = 0;
    pixels.at(1, 0).x = 1;
    const Texture source = makeTexture(context, pixels);
    const Texture target = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const auto sampler = makeSampler(context);
    run(context, pass, source, false, *sampler, target, StoreBlock{{0, 0.25f, 0.625f, 1}, 3, 0.0625f, 0, 0});
    const Pixels stored = readBack(context, target);

    Comparison comparison(pass.name + (pass.stage == Stage::Compute ? " compute" : " fragment"));
    for (int slice = 0; slice < kSlices; ++slice)
    {
        for (int i = 0; i < kWidth * kHeight; ++i)
        {
            const Vec4 expected = store(static_cast<double>(pixels.at(i % kWidth, i / kWidth).x), slice);
            for (int c = 0; c < 4; ++c)
            {
                // Ten units of one division and a square, or 3 + 2 * 5 of an exponential of 5 and its square.
                const double tolerance = 40.0 / (1 << 23) * std::max(1.0, std::abs(expected[c]));
                comparison.expect(static_cast<double>(stored.at(i % kWidth, i / kWidth, slice)[c]), expected[c],
                                  tolerance, describe(i % kWidth, i / kWidth, slice));
            }
        }
    }
    return comparison.passed();
}

Vec4 twoLayers(double depth, int slice)
{
    const double splits[] = {0, 0.25, 0.625, 1};
    const auto moments = [&](int layer)
    {
        if (layer >= 3)
            return glm::dvec2(1, 1);
        return lvsm::layerMoments(depth, lvsm::layerInterval(splits[layer], splits[layer + 1], 0.0625));
    };
    return lvsm::packLayers(moments(2 * slice), moments(2 * slice + 1));
}

} // namespace

bool checkBlur(VulkanContext& context, const Form& form)
{
    const std::string format = form.isHlsl() ? "" : "#define LVSM_BLUR_FORMAT rgba32f\n";
    bool passed = true;
    for (const Stage stage : {Stage::Compute, Stage::Fragment})
    {
        passed = checkBlurOf(context, {form, stage, "blur", format}, 9,
                             [](int i) { return lvsm::binomialWeight<double>(i, 9); }) &&
                 passed;
        const std::string gaussian = format + "#define LVSM_BLUR_SIZE 7\n#define LVSM_BLUR_SIGMA 1.5\n";
        passed = checkBlurOf(context, {form, stage, "blur", gaussian}, 7,
                             [](int i) { return lvsm::gaussianWeight(i, 7, 1.5); }) &&
                 passed;
    }
    return passed;
}

bool checkStore(VulkanContext& context, const Form& form)
{
    const std::string format = form.isHlsl() ? "" : "#define LVSM_STORE_FORMAT rgba32f\n";
    const std::string vec2 = form.isHlsl() ? "float2" : "vec2";
    bool passed = true;
    for (const Stage stage : {Stage::Compute, Stage::Fragment})
    {
        passed = checkStoreOf(context, {form, stage, "store", format}, twoLayers) && passed;
        passed = checkStoreOf(context,
                              {form, stage, "store",
                               format + "#define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, " + vec2 +
                                   "(5.0, 2.0))\n"},
                              [](double depth, int) { return lvsm::exponentialMoments(depth, glm::dvec2(5, 2)); }) &&
                 passed;
    }
    return passed;
}

} // namespace sampling
