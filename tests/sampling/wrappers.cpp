// The sampling wrappers in every form, by Vulkan.
#include "wrappers_truth.hpp"

namespace sampling
{
namespace
{

std::vector<Binding> bind(const Form& form, const Texture (&textures)[4], vk::Sampler sampler)
{
    const bool combined = form.name == "combined";
    const auto type = combined ? vk::DescriptorType::eCombinedImageSampler : vk::DescriptorType::eSampledImage;
    const vk::Sampler own = combined ? sampler : vk::Sampler();
    std::vector<Binding> bindings;
    for (std::uint32_t i = 0; i < 4; ++i)
        bindings.push_back({2 + i, type, {}, i == 0 ? *textures[i].flat : *textures[i].array, own});
    if (!combined)
        bindings.push_back({6, vk::DescriptorType::eSampler, {}, {}, sampler});
    return bindings;
}

std::vector<float> run(VulkanContext& context, const Form& form, const Maps& maps, const Place& place,
                       const std::vector<Receiver>& receivers, int components = 4)
{
    std::vector<glm::vec4> inputs;
    for (const Receiver& receiver : receivers)
    {
        const auto own = inputsOf(receiver, place);
        inputs.insert(inputs.end(), own.begin(), own.end());
    }
    const bool alone = place.width == kSize;
    const Texture textures[] = {makeTexture(context, maps.map),
                                makeTexture(context, alone ? maps.slices : placed(maps.slices, place)),
                                makeTexture(context, alone ? maps.unfiltered : placed(maps.unfiltered, place)),
                                makeTexture(context, alone ? maps.greatest : placed(maps.greatest, place))};
    const auto sampler = makeSampler(context);
    const Buffer input = makeBufferOf(context, inputs);
    const Buffer output = makeBufferOf(context, std::vector<float>(receivers.size() * kResults));
    std::vector<Binding> bindings = bind(form, textures, *sampler);
    bindings.push_back({0, vk::DescriptorType::eStorageBuffer, *input.buffer});
    bindings.push_back({1, vk::DescriptorType::eStorageBuffer, *output.buffer});
    const std::string macros = form.isHlsl()             ? "#define COMPONENTS " + std::to_string(components) + "\n"
                               : form.name == "separate" ? "#define SEPARATE\n"
                                                         : "";
    const Shader shader = compile(form, form.kernelFolder + (form.isHlsl() ? "/wrappers.hlsl" : "/wrappers.comp"),
                                  vk::ShaderStageFlagBits::eCompute, "main", macros);
    dispatch(context, shader, bindings, static_cast<std::uint32_t>(receivers.size()), 1, 1);
    const auto* results = reinterpret_cast<const float*>(output.data);
    return {results, results + receivers.size() * kResults};
}

// With every type of map that the form has.
bool check(VulkanContext& context, const Form& form, const Place& place, const std::vector<Receiver>& receivers)
{
    const Maps maps = makeMaps();
    bool passed = true;
    for (const int components : {4, 2, 1})
    {
        if (components == 4 || form.isHlsl())
            passed =
                compareWrappers(maps, receivers, run(context, form, maps, place, receivers, components), components) &&
                passed;
    }
    return passed;
}

} // namespace

bool checkWrappers(VulkanContext& context, const Form& form)
{
    return check(context, form, kAlone, makeReceivers());
}

bool checkBorders(VulkanContext& context, const Form& form)
{
    return check(context, form, kAlone, makeWalk());
}

bool checkAtlas(VulkanContext& context, const Form& form)
{
    std::vector<Receiver> receivers = makeReceivers();
    const std::vector<Receiver> walk = makeWalk();
    receivers.insert(receivers.end(), walk.begin(), walk.end());
    return check(context, form, kInAtlas, receivers);
}

// Directions all around, many on the edges between faces: no seam, and no border.
bool checkCube(VulkanContext& context, const Form& form)
{
    Maps maps = makeMaps();
    maps.slices = makeCube();
    std::vector<Receiver> receivers = makeReceivers();
    for (Receiver& receiver : receivers)
    {
        receiver.tangent = tangentOfCube();
        // Far away, so that pixels are closer than texels.
        receiver.direction *= 100.0f;
    }
    return compareCube(receivers, run(context, form, maps, kAlone, receivers));
}

// A window that is lit in one eighth, at depth 0.9 beside 0.3: the blurred terms alone would have it lit all over.
bool checkBlurredEsm(VulkanContext& context, const Form& form)
{
    Receiver receiver{glm::dvec2(4.0, 3.75) / double(kSize), 0.6};
    receiver.exponent = 80;
    const float dark = lvsm::occluderTerm(0.3f, 80.0f);
    const float lit = lvsm::occluderTerm(0.9f, 80.0f);
    Maps maps = makeMaps();
    for (int i = 0; i < kSize * kSize; ++i)
    {
        maps.unfiltered.at(i % kSize, i / kSize, kTerms) = glm::vec4(dark);
        maps.slices.at(i % kSize, i / kSize, kTerms) = glm::vec4(0.875f * dark + 0.125f * lit);
    }
    // Between texels 3 and 4 in x, a quarter of the way from 3 to 4 in y.
    maps.unfiltered.at(3, 4, kTerms) = glm::vec4(lit);

    Comparison shadow("sampleEsm of a blurred map");
    const float result = run(context, form, maps, kAlone, {receiver})[24];
    // Bilinear weights in eighths are exact; the dark texels' e^-24 is next to nothing.
    shadow.expect(static_cast<double>(result), 0.125, 1.0 / (1 << 21), "7/8 at depth 0.3, 1/8 at 0.9");
    return shadow.passed();
}

} // namespace sampling
