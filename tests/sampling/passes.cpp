// The ready passes, run as they are, by Vulkan.
#include "passes_truth.hpp"

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
    }
    return runBlur(context, {form, Stage::Compute, "blur", format}, blurOfPart()) && passed;
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

} // namespace sampling
