// The sampling wrappers in every form, by Vulkan.
#include "wrappers_truth.hpp"

#include <algorithm>

namespace sampling
{
namespace
{

// The maps at bindings 2 to 5, and in HLSL at 12 to 15 and 22 to 25, where they are of other types.
std::vector<Binding> bind(const Form& form, const Texture (&textures)[4], vk::Sampler sampler)
{
    const bool combined = form.name == "combined";
    const auto type = combined ? vk::DescriptorType::eCombinedImageSampler : vk::DescriptorType::eSampledImage;
    const vk::Sampler own = combined ? sampler : vk::Sampler();
    std::vector<Binding> bindings;
    for (std::uint32_t first = 2; first <= (form.isHlsl() ? 22 : 2); first += 10)
    {
        for (std::uint32_t i = 0; i < 4; ++i)
            bindings.push_back({first + i, type, {}, i == 1 ? *textures[i].array : *textures[i].flat, own});
    }
    if (!combined)
        bindings.push_back({6, vk::DescriptorType::eSampler, {}, {}, sampler});
    return bindings;
}

std::vector<float> run(VulkanContext& context, const Form& form, const Maps& maps,
                       const std::vector<Receiver>& receivers)
{
    std::vector<glm::vec4> inputs;
    for (const Receiver& receiver : receivers)
    {
        inputs.push_back(receiver.place());
        inputs.push_back(receiver.settings());
    }
    const Texture textures[] = {makeTexture(context, maps.depths), makeTexture(context, maps.layers),
                                makeTexture(context, maps.terms), makeTexture(context, maps.blurred)};
    const auto sampler = makeSampler(context);
    const Buffer input = makeBufferOf(context, inputs);
    const Buffer output = makeBufferOf(context, std::vector<float>(receivers.size() * kResults));
    std::vector<Binding> bindings = bind(form, textures, *sampler);
    bindings.push_back({0, vk::DescriptorType::eStorageBuffer, *input.buffer});
    bindings.push_back({1, vk::DescriptorType::eStorageBuffer, *output.buffer});
    const Shader shader =
        compile(form, form.kernelFolder + (form.isHlsl() ? "/wrappers.hlsl" : "/wrappers.comp"),
                vk::ShaderStageFlagBits::eCompute, "main", form.name == "separate" ? "#define SEPARATE\n" : "");
    dispatch(context, shader, bindings, static_cast<std::uint32_t>(receivers.size()), 1, 1);
    const auto* results = reinterpret_cast<const float*>(output.data);
    return {results, results + receivers.size() * kResults};
}

} // namespace

bool checkWrappers(VulkanContext& context, const Form& form)
{
    const Maps maps = makeMaps();
    const auto receivers = makeReceivers();
    return compareWrappers(maps, receivers, run(context, form, maps, receivers));
}

bool checkBorders(VulkanContext& context, const Form& form)
{
    const Maps maps = makeMaps();
    const auto receivers = makeWalk();
    return compareWrappers(maps, receivers, run(context, form, maps, receivers));
}

// A window that is lit in one eighth, at depth 0.9 beside 0.3: the blurred terms alone would have it lit all over.
bool checkBlurredEsm(VulkanContext& context, const Form& form)
{
    Receiver receiver{glm::dvec2(4.0, 3.75) / double(kSize), 0.6};
    receiver.exponent = 80;
    const float dark = lvsm::occluderTerm(0.3f, 80.0f);
    const float lit = lvsm::occluderTerm(0.9f, 80.0f);
    Maps maps = makeMaps();
    std::fill(maps.terms.texels.begin(), maps.terms.texels.end(), glm::vec4(dark));
    std::fill(maps.blurred.texels.begin(), maps.blurred.texels.end(), glm::vec4(0.875f * dark + 0.125f * lit));
    // Between texels 3 and 4 in x, a quarter of the way from 3 to 4 in y.
    maps.terms.at(3, 4) = glm::vec4(lit);

    Comparison shadow("sampleEsm of a blurred map");
    const float result = run(context, form, maps, {receiver})[20];
    // Bilinear weights in eighths are exact; the dark texels' e^-24 is next to nothing.
    shadow.expect(static_cast<double>(result), 0.125, 1.0 / (1 << 21), "7/8 at depth 0.3, 1/8 at 0.9");
    return shadow.passed();
}

} // namespace sampling
