// The wrappers that read maps of mixtures, over maps of any bits.
#include "mixtures_truth.hpp"

namespace sampling
{

bool checkMixtureWrappers(VulkanContext& context, const Form& form)
{
    const MixtureMaps maps = randomCodes();
    const auto receivers = mixtureReceivers();
    std::vector<glm::vec4> inputs;
    for (const MixtureReceiver& r : receivers)
    {
        inputs.push_back(r.place());
        inputs.push_back(r.plane());
    }
    const auto textureOf = [&](vk::Format format, const auto& texels)
    {
        return makeTexture(context, maps.shape, format, texels.data(), texels.size() * sizeof(texels[0]));
    };
    const Texture textures[] = {textureOf(vk::Format::eR32G32Uint, maps.two),
                                textureOf(vk::Format::eR32G32B32A32Uint, maps.four)};
    const auto sampler = makeSampler(context, vk::Filter::eNearest);
    const Buffer input = makeBufferOf(context, inputs);
    const Buffer output = makeBufferOf(context, std::vector<glm::vec4>(receivers.size()));
    using Type = vk::DescriptorType;
    const bool combined = form.name == "combined";
    std::vector<Binding> bindings{bufferAt(0, input), bufferAt(1, output)};
    for (std::uint32_t i = 0; i < 2; ++i)
        bindings.push_back({2 + i,
                            combined ? Type::eCombinedImageSampler : Type::eSampledImage,
                            {},
                            *textures[i].array,
                            combined ? *sampler : vk::Sampler()});
    if (form.name == "separate")
        bindings.push_back({4, Type::eSampler, {}, {}, *sampler});
    const Shader shader =
        compile(form, form.kernelFolder + (form.isHlsl() ? "/mixtures.hlsl" : "/mixtures.comp"),
                vk::ShaderStageFlagBits::eCompute, "main", form.name == "separate" ? "#define SEPARATE\n" : "");
    dispatch(context, shader, bindings, static_cast<std::uint32_t>(receivers.size()), 1, 1);
    const auto* results = reinterpret_cast<const glm::vec4*>(output.data);
    return compareMixtureWrappers(maps, receivers, {results, results + receivers.size()});
}

} // namespace sampling
