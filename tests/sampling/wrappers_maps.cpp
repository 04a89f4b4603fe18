// The maps that the wrappers read, and the receivers.
#include "wrappers_truth.hpp"

#include <glm/geometric.hpp>

namespace sampling
{
namespace
{

using Vec2 = glm::dvec2;

// Moments of one depth or, in the basis of few bits, of the same.
glm::vec4 pairOf(float depth, int layer, float overlap, bool compact)
{
    const auto moments = [=](int index)
    {
        const auto kept = lvsm::layerMoments(depth, lvsm::layerInterval(kSplits[index], kSplits[index + 1], overlap));
        return compact ? lvsm::compactMoments(kept) : kept;
    };
    return lvsm::packLayers(moments(layer), moments(layer + 1));
}

glm::vec4 fourierTexel(float depth, int slice)
{
    const int first = 4 * (slice / 2) + 1;
    return lvsm::encodeFourier(slice % 2 == 0 ? lvsm::fourierSines(depth, first, kFourierOrder)
                                              : lvsm::fourierCosines(depth, first, kFourierOrder));
}

// Every technique's texel of one depth; quantised moments are of a window of two.
void storeTexel(Pixels& slices, int x, int y, int level, float depth, float other, Random& random)
{
    const auto at = [&](int slice) -> glm::vec4&
    {
        return slices.at(x, y, slice, level);
    };
    at(kDepths) = {depth, random.next(), random.next(), random.next()};
    at(kTerms) = glm::vec4(lvsm::occluderTerm(depth, static_cast<float>(kExponent)));
    at(kVariance) = glm::vec4(lvsm::depthMoments(depth), 0, 0);
    at(kExponential) = lvsm::exponentialMoments(depth, glm::vec2(5, 4));
    at(kMoments4) = lvsm::depthMoments4(depth);
    at(kEncoded4) = lvsm::encodeMoments4(at(kMoments4));
    at(kTrigonometric) = lvsm::trigonometricMoments(depth);
    for (int layer = 0; layer < kLayers; ++layer)
    {
        const auto interval = glm::vec2(kSplits[layer], kSplits[layer + 1]);
        at(kLayered4 + layer) = lvsm::encodeMoments4(lvsm::layerMoments4(depth, interval));
        at(kOverlapping + layer / 2) = pairOf(depth, layer / 2 * 2, 0.0625f, false);
        at(kContiguous + layer / 2) = pairOf(depth, layer / 2 * 2, 0.0f, false);
        at(kCompact + layer / 2) = pairOf(depth, layer / 2 * 2, 0.0f, true);
        at(kFourier + layer) = fourierTexel(depth, layer);
    }
    at(kTwoLayers) =
        lvsm::packLayers(lvsm::layerMoments(depth, glm::vec2(0, 0.5)), lvsm::layerMoments(depth, glm::vec2(0.5, 1)));
    const glm::vec4 window = 0.75f * at(kMoments4) + 0.25f * lvsm::depthMoments4(other);
    at(kQuantised) = lvsm::quantiseMoments4(window, lvsm::kMoment4BiasFp32<float>);
    at(kPacked) = glm::vec4(glm::vec2(lvsm::packQuantised4(at(kQuantised))) / 65535.0f, 0, 0);
}

void blurTerms(Maps& maps, int level)
{
    const int size = kSize >> level;
    for (int i = 0; i < size * size; ++i)
    {
        glm::vec4 sum(0);
        for (int k = 0; k < 9; ++k)
            sum += maps.unfiltered.at(i % size + k % 3 - 1, i / size + k / 3 - 1, kTerms, level);
        maps.slices.at(i % size, i / size, kTerms, level) = sum / 9.0f;
    }
}

// In every direction, the edges between faces included.
glm::vec3 directionOf(Random& random, int number)
{
    glm::vec3 direction(random.next() - 0.5f, random.next() - 0.5f, random.next() - 0.5f);
    if (number % 5 == 0)
        direction[number / 5 % 3] = direction[(number / 5 + 1) % 3];
    if (number % 7 == 0)
        direction[number / 7 % 3] = 0;
    return direction * 10.0f;
}

} // namespace

glm::vec4 Place::rectangle() const
{
    return glm::vec4(x, y, kSize, kSize) / glm::vec4(width, height, width, height);
}

std::vector<glm::vec4> inputsOf(const Receiver& receiver, const Place& place)
{
    return {glm::vec4(receiver.uv, receiver.depth, std::ldexp(1.0, receiver.level) / kSize),
            glm::vec4(receiver.exponent, receiver.threshold, receiver.offset, 0), place.rectangle(),
            glm::vec4(receiver.direction, receiver.tangent)};
}

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
            storeTexel(maps.slices, x, y, level, depth, random.next(), random);
            maps.map.at(x, y, 0, level) = maps.slices.at(x, y, kDepths, level);
            maps.greatest.at(x, y, kTerms, level) = glm::vec4(0.8f * random.next());
        }
    }
    maps.unfiltered = maps.slices;
    for (int level = 0; level < 2; ++level)
        blurTerms(maps, level);
    return maps;
}

Pixels placed(const Pixels& slices, const Place& place)
{
    Pixels atlas(place.width, place.height, slices.slices, slices.levels);
    std::fill(atlas.texels.begin(), atlas.texels.end(), glm::vec4(-7, 11, -5, 13));
    for (int level = 0; level < slices.levels; ++level)
    {
        const int size = kSize >> level;
        for (int i = 0; i < slices.slices * size * size; ++i)
        {
            const int x = i % size;
            const int y = i / size % size;
            const int slice = i / (size * size);
            atlas.at((place.x >> level) + x, (place.y >> level) + y, slice, level) = slices.at(x, y, slice, level);
        }
    }
    return atlas;
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
            receivers.back().direction = directionOf(random, static_cast<int>(receivers.size()));
            receivers.back().tangent = 1.0f + 0.25f * random.next();
        }
    }
    return receivers;
}

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

} // namespace sampling
