// Every sampling wrapper against the library's C++ functions on the same texels.
#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <cmath>

namespace sampling
{
namespace
{

constexpr int kSize = 8;
constexpr int kResults = 21;
constexpr int kLayers = 4;
constexpr double kExponent = 20.0;
constexpr float kSplits[] = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f};

using Vec2 = glm::dvec2;
using Vec4 = glm::dvec4;

struct Receiver
{
    Vec2 uv;
    double depth;
    int level;
};

struct Maps
{
    Pixels depths{kSize, kSize, 1, 2};
    Pixels layers{kSize, kSize, kLayers / 2, 2};
    Pixels terms{kSize, kSize, 1, 2};
};

Maps makeMaps()
{
    Maps maps;
    Random random;
    for (int level = 0; level < 2; ++level)
    {
        for (int i = 0; i < (kSize >> level) * (kSize >> level); ++i)
        {
            const int x = i % (kSize >> level);
            const int y = i / (kSize >> level);
            const float depth = random.next();
            maps.depths.at(x, y, 0, level) = {depth, random.next(), random.next(), random.next()};
            maps.terms.at(x, y, 0, level) = glm::vec4(lvsm::occluderTerm(depth, static_cast<float>(kExponent)));
            for (int layer = 0; layer < kLayers; layer += 2)
            {
                const auto moments = [depth](int index)
                {
                    return lvsm::layerMoments(depth, lvsm::layerInterval(kSplits[index], kSplits[index + 1], 0.0625f));
                };
                maps.layers.at(x, y, layer / 2, level) = lvsm::packLayers(moments(layer), moments(layer + 1));
            }
        }
    }
    return maps;
}

// Coordinates in 64ths, on and off the map: between texels of both levels these are fractions that 4 bits hold, the
// least that Vulkan asks of a sampler, so that filtering is exact but for its sums.
std::vector<Receiver> makeReceivers()
{
    std::vector<Receiver> receivers;
    Random random;
    for (int y = -7; y <= 71; y += 3)
    {
        for (int x = -7; x <= 71; x += 3)
        {
            const int level = static_cast<int>(random.next() * 2.0f);
            receivers.push_back({Vec2(x, y) / 64.0, static_cast<double>(random.next()), level});
        }
    }
    return receivers;
}

Vec2 cornerOf(Vec2 uv, double size)
{
    return glm::floor(uv * size - 0.5);
}

Vec4 filtered(const Pixels& map, Vec2 uv, int slice, int level)
{
    const double size = map.width >> level;
    const Vec2 corner = cornerOf(uv, size);
    const Vec2 f = uv * size - 0.5 - corner;
    const int x = static_cast<int>(corner.x);
    const int y = static_cast<int>(corner.y);
    const auto texel = [&](int dx, int dy)
    {
        return Vec4(map.at(x + dx, y + dy, slice, level));
    };
    const Vec4 top = texel(0, 0) * (1 - f.x) + texel(1, 0) * f.x;
    const Vec4 bottom = texel(0, 1) * (1 - f.x) + texel(1, 1) * f.x;
    return top * (1 - f.y) + bottom * f.y;
}

bool isOnMap(Vec2 uv)
{
    return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1;
}

double texelOrBorder(const Pixels& map, int x, int y, int slice, double border)
{
    const bool on = x >= 0 && y >= 0 && x < kSize && y < kSize;
    return on ? static_cast<double>(map.at(x, y, slice).x) : border;
}

Vec4 gathered(const Pixels& map, Vec2 uv, int slice, double border)
{
    const int x = static_cast<int>(cornerOf(uv, kSize).x);
    const int y = static_cast<int>(cornerOf(uv, kSize).y);
    return {texelOrBorder(map, x, y, slice, border), texelOrBorder(map, x + 1, y, slice, border),
            texelOrBorder(map, x, y + 1, slice, border), texelOrBorder(map, x + 1, y + 1, slice, border)};
}

double layerVisibility(const Maps& maps, const Receiver& receiver, int layer)
{
    const Vec2 interval = lvsm::layerInterval<double>(kSplits[layer], kSplits[layer + 1], 0.0625);
    const Vec4 texel = isOnMap(receiver.uv) ? filtered(maps.layers, receiver.uv, layer / 2, receiver.level) : Vec4(1);
    return lvsm::layeredVisibility(lvsm::unpackLayer(texel, layer), receiver.depth, interval, 0.01);
}

double layersVisibility(const Maps& maps, const Receiver& receiver)
{
    const int layer = lvsm::layerIndex(static_cast<float>(receiver.depth), kSplits, kLayers);
    const double weight = lvsm::transitionWeight<double>(receiver.depth, kSplits[layer], kSplits[layer + 1], 0.0625);
    const double visibility = layerVisibility(maps, receiver, layer);
    if (weight == 0)
        return visibility;
    const double neighbour = layerVisibility(maps, receiver, weight < 0 ? layer - 1 : layer + 1);
    return lvsm::blendTransition(visibility, neighbour, weight);
}

// By its definition: every texel of the map and around it, compared with the plane and weighted by the box.
double pcfVisibility(const Maps& maps, const Receiver& receiver)
{
    if (!isOnMap(receiver.uv))
        return 1;
    const Vec2 position = receiver.uv * double(kSize) - 0.5;
    double lit = 0;
    for (int y = -4; y < kSize + 4; ++y)
    {
        for (int x = -4; x < kSize + 4; ++x)
        {
            const Vec2 offset = Vec2(x, y) - position;
            const double weight = lvsm::boxWeight(offset.x, 3.5) * lvsm::boxWeight(offset.y, 3.5);
            const double plane = lvsm::planeDepth(receiver.depth, Vec2(0.01, -0.02), offset);
            lit += weight * lvsm::depthTest(texelOrBorder(maps.depths, x, y, 0, 1), plane, 0.001);
        }
    }
    return lit;
}

double esmVisibility(const Maps& maps, const Receiver& receiver)
{
    const double empty = lvsm::occluderTerm(1.0, kExponent);
    const double occluder = isOnMap(receiver.uv) ? filtered(maps.terms, receiver.uv, 0, receiver.level).x : empty;
    if (!lvsm::violatesThreshold(occluder, receiver.depth, kExponent, 0.02))
        return lvsm::exponentialShadow(occluder, receiver.depth, kExponent);
    const Vec2 fraction = receiver.uv * double(kSize) - 0.5 - cornerOf(receiver.uv, kSize);
    return lvsm::exponentialShadow2x2(gathered(maps.terms, receiver.uv, 0, empty), fraction, receiver.depth, kExponent);
}

std::vector<Binding> bind(const Form& form, const Texture (&textures)[3], vk::Sampler sampler)
{
    const bool combined = form.name == "combined";
    const auto type = combined ? vk::DescriptorType::eCombinedImageSampler : vk::DescriptorType::eSampledImage;
    const vk::Sampler own = combined ? sampler : vk::Sampler();
    std::vector<Binding> bindings{{2, type, {}, *textures[0].flat, own},
                                  {3, type, {}, *textures[1].array, own},
                                  {4, type, {}, *textures[2].flat, own}};
    if (!combined)
        bindings.push_back({5, vk::DescriptorType::eSampler, {}, {}, sampler});
    return bindings;
}

std::vector<float> run(VulkanContext& context, const Form& form, const Maps& maps,
                       const std::vector<Receiver>& receivers)
{
    std::vector<glm::vec4> inputs;
    for (const Receiver& receiver : receivers)
        inputs.emplace_back(receiver.uv, receiver.depth, std::ldexp(1.0, receiver.level) / kSize);
    const Texture textures[] = {makeTexture(context, maps.depths), makeTexture(context, maps.layers),
                                makeTexture(context, maps.terms)};
    const auto sampler = makeSampler(context);
    const Buffer input = makeBufferOf(context, inputs);
    const Buffer output = makeBufferOf(context, std::vector<float>(inputs.size() * kResults));
    std::vector<Binding> bindings = bind(form, textures, *sampler);
    bindings.push_back({0, vk::DescriptorType::eStorageBuffer, *input.buffer});
    bindings.push_back({1, vk::DescriptorType::eStorageBuffer, *output.buffer});
    const Shader shader =
        compile(form, form.kernelFolder + (form.isHlsl() ? "/wrappers.hlsl" : "/wrappers.comp"),
                vk::ShaderStageFlagBits::eCompute, "main", form.name == "separate" ? "#define SEPARATE\n" : "");
    dispatch(context, shader, bindings, static_cast<std::uint32_t>(inputs.size()), 1, 1);
    const auto* results = reinterpret_cast<const float*>(output.data);
    return {results, results + inputs.size() * kResults};
}

} // namespace

bool checkWrappers(VulkanContext& context, const Form& form)
{
    const Maps maps = makeMaps();
    const std::vector<Receiver> receivers = makeReceivers();
    const std::vector<float> results = run(context, form, maps, receivers);

    Comparison samples("samples");
    Comparison gathers("gathers");
    Comparison fractions("mapFraction");
    Comparison layers("sampleLayers");
    Comparison pcf("samplePcf");
    Comparison esm("sampleEsm");
    for (std::size_t i = 0; i < receivers.size(); ++i)
    {
        const Receiver& receiver = receivers[i];
        const float* result = &results[i * kResults];
        const std::string where = "uv 64ths " + std::to_string(receiver.uv.x * 64) + ' ' +
                                  std::to_string(receiver.uv.y * 64) + " depth " + std::to_string(receiver.depth) +
                                  " level " + std::to_string(receiver.level);
        const bool on = isOnMap(receiver.uv);
        const Vec4 texel = on ? filtered(maps.depths, receiver.uv, 0, receiver.level) : Vec4(1, 2, 3, 4);
        const Vec4 slice = on ? filtered(maps.layers, receiver.uv, 1, receiver.level) : Vec4(1, 2, 3, 4);
        const Vec4 corners = gathered(maps.depths, receiver.uv, 0, 5);
        const Vec4 sliceCorners = gathered(maps.layers, receiver.uv, 1, 5);
        const double rounding = 1.0 / (1 << 21);
        for (int c = 0; c < 4; ++c)
        {
            // Weights in 16ths are exact; three products and sums of numbers up to 1 in each direction are not.
            samples.expect(static_cast<double>(result[c]), texel[c], rounding, where);
            samples.expect(static_cast<double>(result[4 + c]), slice[c], rounding, where);
            gathers.expect(static_cast<double>(result[8 + c]), corners[c], 0, where);
            gathers.expect(static_cast<double>(result[12 + c]), sliceCorners[c], 0, where);
        }
        const Vec2 fraction = receiver.uv * double(kSize) - 0.5 - cornerOf(receiver.uv, kSize);
        fractions.expect(static_cast<double>(result[16]), fraction.x, 0, where);
        fractions.expect(static_cast<double>(result[17]), fraction.y, 0, where);
        // The variance floor in a layer is at least 0.01 / 0.375^2 = 0.07, over which the bound divides the errors of
        // about five moments' roundings, twice for two layers.
        layers.expect(static_cast<double>(result[18]), layersVisibility(maps, receiver), 10 * rounding / 0.07, where);
        // Weights of 25 texels, each with a few roundings of numbers up to 8, over the width.
        pcf.expect(static_cast<double>(result[19]), pcfVisibility(maps, receiver), 25 * 8 * rounding, where);
        // Two exponentials of up to 20: each is 3 + 2 * 20 units in the last place off.
        esm.expect(static_cast<double>(result[20]), esmVisibility(maps, receiver), 2 * 43.0 / (1 << 23) + rounding,
                   where);
    }
    bool passed = samples.passed();
    for (const Comparison* comparison : {&gathers, &fractions, &layers, &pcf, &esm})
        passed = comparison->passed() && passed;
    return passed;
}

} // namespace sampling
