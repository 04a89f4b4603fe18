#include "wrappers_truth.hpp"

#include <cmath>

namespace sampling
{
namespace
{

using Vec2 = glm::dvec2;
using Vec4 = glm::dvec4;

constexpr float kSplits[] = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f};

void blurTerms(Maps& maps, int level)
{
    const int size = kSize >> level;
    for (int i = 0; i < size * size; ++i)
    {
        glm::vec4 sum(0);
        for (int k = 0; k < 9; ++k)
            sum += maps.terms.at(i % size + k % 3 - 1, i / size + k / 3 - 1, 0, level);
        maps.blurred.at(i % size, i / size, 0, level) = sum / 9.0f;
    }
}

} // namespace

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
        blurTerms(maps, level);
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

namespace
{

Vec2 cornerOf(Vec2 uv, double size)
{
    return glm::floor(uv * size - 0.5);
}

// A texel, or border off the map, of the first slices' first level or any other.
Vec4 texelOrBorder(const Pixels& map, int x, int y, int slice, int level, Vec4 border)
{
    const int size = kSize >> level;
    return x >= 0 && y >= 0 && x < size && y < size ? Vec4(map.at(x, y, slice, level)) : border;
}

// Bilinear among texels, as if border lay around the map.
Vec4 filtered(const Pixels& map, Vec2 uv, int slice, int level, Vec4 border)
{
    const double size = kSize >> level;
    const Vec2 corner = cornerOf(uv, size);
    const Vec2 f = uv * size - 0.5 - corner;
    const int x = static_cast<int>(corner.x);
    const int y = static_cast<int>(corner.y);
    const auto texel = [&](int dx, int dy)
    {
        return texelOrBorder(map, x + dx, y + dy, slice, level, border);
    };
    const Vec4 top = texel(0, 0) * (1 - f.x) + texel(1, 0) * f.x;
    const Vec4 bottom = texel(0, 1) * (1 - f.x) + texel(1, 1) * f.x;
    return top * (1 - f.y) + bottom * f.y;
}

Vec4 gathered(const Pixels& map, Vec2 uv, int slice, double border)
{
    const int x = static_cast<int>(cornerOf(uv, kSize).x);
    const int y = static_cast<int>(cornerOf(uv, kSize).y);
    const auto texel = [&](int dx, int dy)
    {
        return texelOrBorder(map, x + dx, y + dy, slice, 0, Vec4(border)).x;
    };
    return {texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)};
}

double layerVisibility(const Maps& maps, const Receiver& receiver, int layer)
{
    const Vec2 interval = lvsm::layerInterval<double>(kSplits[layer], kSplits[layer + 1], 0.0625);
    const Vec4 texel = filtered(maps.layers, receiver.uv, layer / 2, receiver.level, Vec4(1));
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
    const Vec2 position = receiver.uv * double(kSize) - 0.5;
    double lit = 0;
    for (int y = -8; y < kSize + 8; ++y)
    {
        for (int x = -8; x < kSize + 8; ++x)
        {
            const Vec2 offset = Vec2(x, y) - position;
            const double weight = lvsm::boxWeight(offset.x, 3.5) * lvsm::boxWeight(offset.y, 3.5);
            const double plane = lvsm::planeDepth(receiver.depth, Vec2(0.01, -0.02), offset);
            lit += weight * lvsm::depthTest(texelOrBorder(maps.depths, x, y, 0, 0, Vec4(1)).x, plane, 0.001);
        }
    }
    return lit;
}

double esmVisibility(const Maps& maps, const Receiver& receiver)
{
    const double exponent = receiver.exponent;
    const double empty = lvsm::occluderTerm(1.0, exponent);
    const double occluder = filtered(maps.blurred, receiver.uv, 0, receiver.level, Vec4(empty)).x;
    if (!lvsm::violatesThreshold(occluder, receiver.depth, exponent, receiver.threshold))
        return lvsm::exponentialShadow(occluder, receiver.depth, exponent);
    const Vec2 fraction = receiver.uv * double(kSize) - 0.5 - cornerOf(receiver.uv, kSize);
    return lvsm::exponentialShadow2x2(gathered(maps.terms, receiver.uv, 0, empty), fraction, receiver.depth, exponent);
}

} // namespace

std::vector<Receiver> makeWalk()
{
    std::vector<Receiver> receivers;
    Random random;
    for (int step = -48; step <= 48; ++step)
    {
        const double low = step / 16.0 / kSize;
        const double high = 1 - low;
        for (const Vec2 uv : {Vec2(low, 0.453125), Vec2(high, 0.453125), Vec2(0.703125, low), Vec2(0.703125, high),
                              Vec2(low, low), Vec2(high, low)})
            receivers.push_back({uv, static_cast<double>(random.next())});
    }
    return receivers;
}

bool compareWrappers(const Maps& maps, const std::vector<Receiver>& receivers, const std::vector<float>& results)
{
    Comparison samples("sampleMap and sampleMapArray");
    Comparison gathers("gatherMap and gatherMapArray");
    Comparison fractions("mapFraction");
    Comparison layers("sampleLayers");
    Comparison pcf("samplePcf");
    Comparison esm("sampleEsm");
    for (std::size_t i = 0; i < receivers.size(); ++i)
    {
        const Receiver& receiver = receivers[i];
        const float* result = &results[i * kResults];
        const std::string where = "texel " + std::to_string(receiver.uv.x * kSize) + ' ' +
                                  std::to_string(receiver.uv.y * kSize) + " depth " + std::to_string(receiver.depth) +
                                  " level " + std::to_string(receiver.level);
        const Vec4 border(1, 2, 3, 4);
        const Vec4 texel = filtered(maps.depths, receiver.uv, 0, receiver.level, border);
        const Vec4 slice = filtered(maps.layers, receiver.uv, 1, receiver.level, border);
        const Vec4 corners = gathered(maps.depths, receiver.uv, 0, 5);
        const Vec4 sliceCorners = gathered(maps.layers, receiver.uv, 1, 5);
        const double rounding = 1.0 / (1 << 21);
        for (int c = 0; c < 4; ++c)
        {
            // Weights in 16ths are exact; three products and sums of numbers up to 4 in each direction are not.
            samples.expect(static_cast<double>(result[c]), texel[c], 4 * rounding, where);
            samples.expect(static_cast<double>(result[4 + c]), slice[c], 4 * rounding, where);
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
        // Two exponentials of up to the exponent: each is 3 + 2 * exponent units in the last place off.
        esm.expect(static_cast<double>(result[20]), esmVisibility(maps, receiver),
                   2 * (3 + 2 * receiver.exponent) / (1 << 23) + rounding, where);
    }
    bool passed = samples.passed();
    for (const Comparison* comparison : {&gathers, &fractions, &layers, &pcf, &esm})
        passed = comparison->passed() && passed;
    return passed;
}

} // namespace sampling
