// The ready passes, run as they are, against the library's C++ functions.
#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <functional>

namespace sampling
{
namespace
{

constexpr int kWidth = 13;
constexpr int kHeight = 9;
constexpr int kSlices = 2;

const lvsm::Rectangle kWhole{0, 0, kWidth, kHeight};
const glm::vec4 kBorder(1, 2, 3, 4);

using Vec4 = glm::dvec4;

enum class Stage
{
    Compute,
    Fragment
};

// A ready pass as one of the shader stages. macros: its settings. base: the first of the bindings that are defined for
// it, 0 for the pass's own.
struct Shading
{
    const Form& form;
    Stage stage;
    std::string name;
    std::string macros;
    std::uint32_t base = 0;

    // The names of the bindings, in the order of the pass's own numbers.
    std::string bindings() const
    {
        const std::string prefix = name == "blur" ? "LVSM_BLUR_" : "LVSM_STORE_";
        std::string lines;
        std::uint32_t binding = base;
        for (const auto& [macro, letter] :
             {std::pair(name == "blur" ? "SOURCE" : "DEPTHS", 't'), {"TARGET", 'u'}, {"BLOCK", 'b'}, {"SAMPLER", 's'}})
        {
            const std::string number = std::to_string(binding++);
            const std::string layout = letter == 'b' ? "layout(std140, binding = " : "layout(binding = ";
            lines +=
                "#define " + prefix + macro + ' ' + (form.isHlsl() ? letter + number : layout + number + ')') + '\n';
        }
        return lines;
    }

    Shader shader() const
    {
        const bool compute = stage == Stage::Compute;
        const std::string file = form.isHlsl()
                                     ? form.hlslFolder + "/lvsm/passes/" + name + ".hlsl"
                                     : form.glslFolder + "/lvsm/passes/" + name + (compute ? ".comp" : ".frag");
        return compile(form, file, compute ? vk::ShaderStageFlagBits::eCompute : vk::ShaderStageFlagBits::eFragment,
                       form.isHlsl() ? "lvsm_" + name + (compute ? "Compute" : "Pixel") : "main",
                       macros + (base > 0 ? bindings() : ""));
    }
};

// Runs a pass: over its groups by compute, or over all of the target by drawing, one slice after the other.
template <typename Block>
void run(VulkanContext& context, const Shading& shading, const Texture& source, bool sourceIsArray, vk::Sampler sampler,
         const Texture& target, lvsm::Pass<Block> pass)
{
    const auto view = sourceIsArray ? *source.array : *source.flat;
    const bool compute = shading.stage == Stage::Compute;
    const Shader shader = shading.shader();
    const Form glsl{"combined", shading.form.glslFolder, shading.form.hlslFolder, shading.form.kernelFolder, {}};
    const Shader vertex = compute ? Shader{}
                                  : compile(glsl, shading.form.kernelFolder + "/triangle.vert",
                                            vk::ShaderStageFlagBits::eVertex, "main", "");
    for (int slice = 0; slice < (compute ? 1 : target.size.slices); ++slice)
    {
        if (!compute)
            pass.block.slice = slice;
        const Buffer uniform = makeBufferOf(context, std::vector<Block>{pass.block});
        std::vector<Binding> bindings{{shading.base + 2, vk::DescriptorType::eUniformBuffer, *uniform.buffer}};
        if (shading.form.isHlsl())
            bindings.insert(bindings.end(), {{shading.base, vk::DescriptorType::eSampledImage, {}, view},
                                             {shading.base + 3, vk::DescriptorType::eSampler, {}, {}, sampler}});
        else
            bindings.push_back({shading.base, vk::DescriptorType::eCombinedImageSampler, {}, view, sampler});
        if (compute)
        {
            bindings.push_back({shading.base + 1, vk::DescriptorType::eStorageImage, {}, *target.array});
            dispatch(context, shader, bindings, static_cast<std::uint32_t>(pass.groups.x),
                     static_cast<std::uint32_t>(pass.groups.y), static_cast<std::uint32_t>(pass.groups.z));
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

// A blurred texel by its definition: every tap of a window on the map, and border for those off it.
Vec4 blurred(const Pixels& pixels, const lvsm::Rectangle& map, int x, int y, int slice, int size,
             const std::function<double(int)>& weight)
{
    Vec4 sum(0);
    for (int k = 0; k < size * size; ++k)
    {
        const int tapX = x + k % size - size / 2;
        const int tapY = y + k / size - size / 2;
        const bool on = tapX >= map.x && tapX < map.x + map.width && tapY >= map.y && tapY < map.y + map.height;
        sum += weight(k % size) * weight(k / size) * (on ? Vec4(pixels.at(tapX, tapY, slice)) : Vec4(kBorder));
    }
    return sum;
}

struct Blur
{
    lvsm::BlurKernel kernel;
    std::function<double(int)> weight;
    lvsm::Rectangle map = kWhole;
    lvsm::Rectangle region = kWhole;
};

bool checkBlurOf(VulkanContext& context, const Shading& shading, const Blur& blur)
{
    const Pixels pixels = randomPixels(kSlices);
    const Texture source = makeTexture(context, pixels);
    const Texture between = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const Texture target = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const auto sampler = makeSampler(context);
    const auto passes = lvsm::blurPasses(blur.kernel, blur.map, blur.region, kBorder, 0, kSlices);
    run(context, shading, source, true, *sampler, between, passes.across);
    run(context, shading, between, true, *sampler, target, passes.down);
    const Pixels result = readBack(context, target);

    // A sampler places a fetch between two texels in steps of 2^-bits: of values in [0,4], each direction is off by at
    // most half a step. Both directions, and their rounding.
    const auto bits = context.physical.getProperties().limits.subTexelPrecisionBits;
    const double tolerance = 4 * (std::ldexp(1.0, -static_cast<int>(bits)) + 1.0 / (1 << 20));
    Comparison comparison(shading.name + (shading.stage == Stage::Compute ? " compute" : " fragment"));
    for (int slice = 0; slice < kSlices; ++slice)
    {
        for (int i = 0; i < kWidth * kHeight; ++i)
        {
            const int x = i % kWidth;
            const int y = i / kWidth;
            const auto& region = passes.down.region;
            const bool written =
                x >= region.x && x < region.x + region.width && y >= region.y && y < region.y + region.height;
            const Vec4 expected =
                written ? blurred(pixels, blur.map, x, y, slice, blur.kernel.size, blur.weight) : Vec4(0);
            for (int c = 0; c < 4; ++c)
                comparison.expect(static_cast<double>(result.at(x, y, slice)[c]), expected[c], tolerance,
                                  describe(x, y, slice));
        }
    }
    return comparison.passed();
}

template <typename Store>
bool checkStoreOf(VulkanContext& context, const Shading& shading, const Store& store)
{
    Pixels pixels = randomPixels(1);
    pixels.at(0, 0).x = 0;
    pixels.at(1, 0).x = 1;
    const Texture source = makeTexture(context, pixels);
    const Texture target = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const auto sampler = makeSampler(context);
    const float splits[] = {0, 0.25f, 0.625f, 1};
    run(context, shading, source, false, *sampler, target, lvsm::storePass(splits, 3, 0.0625f, kWhole));
    const Pixels stored = readBack(context, target);

    Comparison comparison(shading.name + (shading.stage == Stage::Compute ? " compute" : " fragment"));
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
    const std::string unrolled = format + "#define LVSM_BLUR_FETCHES 5\n";
    const auto binomial = [](int i)
    {
        return lvsm::binomialWeight<double>(i, 9);
    };
    const auto gaussian = [](int i)
    {
        return lvsm::gaussianWeight(i, 7, 1.5);
    };
    const auto box = [](int i)
    {
        return lvsm::boxWeight(i - 2.0, 3.5);
    };
    bool passed = true;
    for (const Stage stage : {Stage::Compute, Stage::Fragment})
    {
        const Shading shading{form, stage, "blur", format};
        passed = checkBlurOf(context, shading, {lvsm::binomialKernel(9), binomial}) && passed;
        passed = checkBlurOf(context, shading, {lvsm::gaussianKernel(7, 1.5f), gaussian}) && passed;
        passed = checkBlurOf(context, shading, {lvsm::boxKernel(3.5f, false), box}) && passed;
        passed =
            checkBlurOf(context, {form, stage, "blur", unrolled, 4}, {lvsm::binomialKernel(9), binomial}) && passed;
    }
    // A rectangle of an atlas, and of that a part which has changed.
    const Shading compute{form, Stage::Compute, "blur", format};
    return checkBlurOf(context, compute, {lvsm::binomialKernel(9), binomial, {2, 1, 9, 7}, {4, 2, 5, 6}}) && passed;
}

bool checkStore(VulkanContext& context, const Form& form)
{
    const std::string format = form.isHlsl() ? "" : "#define LVSM_STORE_FORMAT rgba32f\n";
    const std::string vec2 = form.isHlsl() ? "float2" : "vec2";
    const std::string exponential = "#define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, " + vec2 +
                                    "(5.0, 2.0))\n#define LVSM_STORE_LARGEST LVSM_LARGEST_FP16\n";
    bool passed = true;
    for (const Stage stage : {Stage::Compute, Stage::Fragment})
    {
        passed = checkStoreOf(context, {form, stage, "store", format}, twoLayers) && passed;
        passed = checkStoreOf(context, {form, stage, "store", format + exponential, 4},
                              [](double depth, int) { return lvsm::exponentialMoments(depth, glm::dvec2(5, 2)); }) &&
                 passed;
    }
    return passed;
}

} // namespace sampling
