// The ready passes, run as they are, by Vulkan.
#include "passes_truth.hpp"

#include <glm/gtc/packing.hpp>

#include <cmath>
#include <fstream>
#include <regex>

namespace sampling
{
namespace
{

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

    std::string describe() const { return name + (stage == Stage::Compute ? " compute" : " fragment"); }

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

bool runBlur(VulkanContext& context, const Shading& shading, const Blur& blur)
{
    const Pixels pixels = randomPixels(kSlices);
    const Texture source = makeTexture(context, pixels);
    const Texture between = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const Texture target = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const auto sampler = makeSampler(context);
    run(context, shading, source, true, *sampler, between, blur.passes().across);
    run(context, shading, between, true, *sampler, target, blur.passes().down);
    const auto bits = context.physical.getProperties().limits.subTexelPrecisionBits;
    return compareBlur(shading.describe(), blur, pixels, readBack(context, target), static_cast<int>(bits));
}

bool runStore(VulkanContext& context, const Shading& shading, const Store& store)
{
    const Pixels depths = storeDepths();
    const Texture source = makeTexture(context, depths);
    const Texture target = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
    const auto sampler = makeSampler(context);
    run(context, shading, source, false, *sampler, target, storePassOfTest());
    return compareStore(shading.describe(), store, depths, readBack(context, target));
}

} // namespace

bool checkBlur(VulkanContext& context, const Form& form)
{
    const std::string format = form.isHlsl() ? "" : "#define LVSM_BLUR_FORMAT rgba32f\n";
    bool passed = true;
    for (const Stage stage : {Stage::Compute, Stage::Fragment})
    {
        const Shading shading{form, stage, "blur", format};
        const Shading unrolled{form, stage, "blur", format + "#define LVSM_BLUR_FETCHES 5\n", 4};
        passed = runBlur(context, shading, binomialBlur()) && passed;
        passed = runBlur(context, shading, gaussianBlur()) && passed;
        passed = runBlur(context, shading, boxBlur()) && passed;
        passed = runBlur(context, unrolled, binomialBlur()) && passed;
        const Shading largest{form, stage, "blur", format + "#define LVSM_BLUR_MAXIMUM\n"};
        Blur part = largestOfPart();
        if (stage == Stage::Fragment)
            part.map = part.region = kWhole;
        passed = runBlur(context, largest, part) && passed;
    }
    return runBlur(context, {form, Stage::Compute, "blur", format}, blurOfPart()) && passed;
}

bool checkLitGround(VulkanContext& context, const Form& form)
{
    const std::string format = form.isHlsl() ? "" : "#define LVSM_BLUR_FORMAT rgba32f\n";
    const Shading shading{form, Stage::Compute, "blur", format};
    const auto sampler = makeSampler(context);
    bool passed = true;
    for (const Ground ground : {Ground::Exponential, Ground::Layered})
    {
        for (const double slope : {0.002, 0.01, -0.01})
        {
            const Texture source = makeTexture(context, groundMap(ground, slope));
            const Texture between = makeTexture(context, Pixels(kWidth, kHeight, kSlices));
            const auto passes =
                lvsm::blurPasses(lvsm::binomialKernel(9, false), kWhole, kWhole, groundBorder(ground), 0, kSlices);
            run(context, shading, source, true, *sampler, between, passes.across);
            run(context, shading, between, true, *sampler, source, passes.down);
            const std::string what = ground == Ground::Exponential ? "EVSM4 at the edge" : "LVSM at the edge";
            passed = compareGround(what, ground, slope, readBack(context, source)) && passed;
        }
    }
    return passed;
}

bool checkStore(VulkanContext& context, const Form& form)
{
    const std::string format = form.isHlsl() ? "" : "#define LVSM_STORE_FORMAT rgba32f\n";
    const Store layers = layersStore();
    const Store exponential = exponentialStore(form.isHlsl());
    bool passed = true;
    for (const Stage stage : {Stage::Compute, Stage::Fragment})
    {
        passed = runStore(context, {form, stage, "store", format}, layers) && passed;
        passed = runStore(context, {form, stage, "store", format + exponential.macros, 4}, exponential) && passed;
    }
    return passed;
}

namespace
{

// A technique that a comment of the store pass shows: its lines, and what they say.
struct Example
{
    std::string macros;
    glm::dvec2 exponents;
    bool wide;
};

std::vector<Example> storeExamples(const Form& form)
{
    std::ifstream file(form.isHlsl() ? form.hlslFolder + "/lvsm/passes/store.hlsl"
                                     : form.glslFolder + "/lvsm/passes/store.glsl");
    const std::string mark = "//   ";
    const std::regex technique(
        R"(#define LVSM_STORE\(.*vec2\(([\d.]+), ([\d.]+)\)\)|.*float2\(([\d.]+), ([\d.]+)\)\))");
    const std::regex ofTechnique("^" + mark + "#define LVSM_STORE(\\(|_LARGEST|_FORMAT)");
    std::vector<Example> examples;
    std::smatch match;
    for (std::string line; std::getline(file, line);)
    {
        if (!std::regex_search(line, ofTechnique))
            continue;
        const std::string macro = line.substr(mark.size());
        if (std::regex_match(macro, match, technique))
        {
            const std::size_t first = match[1].matched ? 1 : 3;
            examples.push_back({"", {std::stod(match[first]), std::stod(match[first + 1])}, false});
        }
        else if (examples.empty())
        {
            continue;
        }
        examples.back().macros += macro + '\n';
        examples.back().wide |= macro.find("FP32") != std::string::npos || macro.find("32f") != std::string::npos;
    }
    return examples;
}

// The texels of a target, as they were stored in its format.
std::vector<glm::vec4> storedTexels(VulkanContext& context, const Texture& target, bool wide)
{
    if (wide)
        return readTexels<glm::vec4>(context, target);
    std::vector<glm::vec4> texels;
    for (const std::uint64_t halves : readTexels<std::uint64_t>(context, target))
        texels.push_back(glm::unpackHalf4x16(halves));
    return texels;
}

} // namespace

bool checkStoreExamples(VulkanContext& context, const Form& form)
{
    Comparison comparison("examples of the store pass in their format");
    const Pixels depths = storeDepths();
    const Texture source = makeTexture(context, depths);
    const auto sampler = makeSampler(context);
    for (const Example& example : storeExamples(form))
    {
        const char* format = example.wide ? "rgba32f" : "rgba16f";
        const Texture target =
            makeTexture(context, Shape{kWidth, kHeight, kSlices},
                        example.wide ? vk::Format::eR32G32B32A32Sfloat : vk::Format::eR16G16B16A16Sfloat);
        // HLSL has formats in Vulkan alone.
        const std::string macros =
            form.isHlsl() ? example.macros + "#define LVSM_STORE_FORMAT \"" + format + "\"\n" : example.macros;
        run(context, {form, Stage::Compute, "store", macros}, source, false, *sampler, target, storePassOfTest());
        const std::vector<glm::vec4> texels = storedTexels(context, target, example.wide);
        for (std::size_t i = 0; i < texels.size(); ++i)
        {
            const auto depth = static_cast<double>(depths.texels[i % depths.texels.size()].x);
            const glm::dvec4 expected = lvsm::exponentialMoments(depth, example.exponents);
            for (int c = 0; c < 4; ++c)
            {
                // A square of an exponential, each 3 + 2 c units off, and a unit of the format: Vulkan lets a conversion cut off.
                const double share = (example.wide ? 0.0 : 1.0 / 1024) + 4 * (3 + 2 * 42.0) / (1 << 23);
                comparison.expect(static_cast<double>(texels[i][c]), expected[c], share * std::abs(expected[c]) + 1e-7,
                                  std::string(format) + " depth " + std::to_string(depth));
            }
        }
    }
    return comparison.passed();
}

} // namespace sampling
