// The wrappers that sample and judge: their tolerances are what the sampler's rounding and the functions' own leave open,
// followed through the formula by the intervals of tests/parity.
#include "wrappers_truth.hpp"

#include <interval.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace sampling
{
namespace
{

using parity::Interval;

constexpr int kOutcomes = 4096;

// One receiver and the maps, on numbers of type T: double, or intervals of what a device may have.
template <typename T>
class Techniques
{
public:
    using Vec2 = glm::vec<2, T>;
    using Vec4 = glm::vec<4, T>;

    Techniques(const Maps& maps, const Receiver& receiver) : m_maps(maps), m_receiver(receiver) {}

    T variance() const { return lvsm::chebyshevUpperBound(two(sample(kVariance, glm::dvec4(1))), depth(), T(5.4e-5)); }

    T exponential2() const
    {
        return lvsm::exponentialVisibility2(two(sample(kExponential, emptyExponential())), depth(), T(5.0), T(1e-4));
    }

    T exponential4() const
    {
        return lvsm::exponentialVisibility4(sample(kExponential, emptyExponential()), depth(), Vec2(T(5.0), T(4.0)),
                                            T(1e-4));
    }

    T moments4() const { return lvsm::momentVisibility4(sample(kMoments4, glm::dvec4(1)), depth(), bias()); }

    T encodedMoments4() const { return lvsm::momentVisibility4(encoded(kEncoded4), depth(), bias()); }

    T layeredMoments4() const
    {
        const int layer = layerOf(depth());
        const Vec4 front = layer > 0 ? encoded(kLayered4 + layer - 1) : Vec4(T(1.0));
        const Vec4 behind =
            layer < kLayers - 1 ? encoded(kLayered4 + layer + 1) : Vec4(T(-1.0), T(1.0), T(-1.0), T(1.0));
        return lvsm::bracketedVisibility4(front, encoded(kLayered4 + layer), behind, depth(), interval(layer, layer),
                                          bias());
    }

    T trigonometric() const
    {
        return lvsm::trigonometricVisibility(sample(kTrigonometric, lvsm::trigonometricMoments(1.0)), depth(), bias());
    }

    T bracketed2() const
    {
        return lvsm::bracketedVisibility2(sample(kTwoLayers, glm::dvec4(1)), depth(), T(0.5), T(1e-4));
    }

    T bracketed(bool compact) const
    {
        const int layer = layerOf(depth());
        return lvsm::bracketedBoundedVisibility(layerMoments(compact, layer - 1), layerMoments(compact, layer),
                                                layerMoments(compact, layer + 1), depth(), interval(layer, layer),
                                                T(1e-4));
    }

    // As plane.hpp has it: all layers that the plane reaches, merged, and the neighbours of these.
    T plane(bool compact, double steepness) const
    {
        const Vec2 gradient(T(0.01 * steepness), T(-0.02 * steepness));
        const T variance = lvsm::planeVariance(gradient, T(1.5));
        using std::sqrt;
        const T reach = sqrt(variance);
        const int first = layerOf(depth() - reach);
        const int last = layerOf(depth() + reach);
        const Vec2 whole = interval(first, last);
        Vec2 merged(T(0.0));
        T covariance(0.0);
        for (int i = first; i <= last; ++i)
        {
            const T extent(kSplits[i + 1] - kSplits[i]);
            merged = lvsm::mergeLayers(merged, layerMoments(compact, i), T(kSplits[i]) - whole.x, extent);
            covariance += planeCovariance(compact, i, gradient) * extent / (whole.y - whole.x);
        }
        const glm::vec<3, T> covariances(planeCovariance(compact, first - 1, gradient), covariance,
                                         planeCovariance(compact, last + 1, gradient));
        return lvsm::planeBracketedVisibility(layerMoments(compact, first - 1), merged, layerMoments(compact, last + 1),
                                              covariances, depth(), whole, variance, T(1e-4), T(0.15));
    }

    T convolution() const
    {
        T sum(0.0);
        for (int i = 0; 4 * i < kFourierOrder; ++i)
        {
            const int first = 4 * i + 1;
            const auto sines = lvsm::encodeFourier(lvsm::fourierSines(1.0, first, kFourierOrder));
            const auto cosines = lvsm::encodeFourier(lvsm::fourierCosines(1.0, first, kFourierOrder));
            sum += lvsm::fourierSum(lvsm::decodeFourier(sample(kFourier + 2 * i, sines)),
                                    lvsm::decodeFourier(sample(kFourier + 2 * i + 1, cosines)), depth(), T(0.08), first,
                                    kFourierOrder, T(1.0));
        }
        return lvsm::fourierVisibility(sum, T(1.0));
    }

    // Four codes judged apart; what is off the map is lit.
    T quantised(bool packed) const
    {
        const glm::dvec2 corner = cornerOf(m_receiver.uv);
        const glm::dvec2 fraction = m_receiver.uv * double(kSize) - 0.5 - corner;
        Vec4 lit(T(1.0));
        for (int i = 0; i < 4; ++i)
        {
            const int x = static_cast<int>(corner.x) + i % 2;
            const int y = static_cast<int>(corner.y) + i / 2;
            if (x < 0 || y < 0 || x >= kSize || y >= kSize)
                continue;
            if (packed)
            {
                const glm::vec4 words = m_maps.slices.at(x, y, kPacked);
                const auto code = lvsm::unpackQuantised4<double>(glm::ivec2(65535.0 * glm::dvec2(words) + 0.5));
                lit[i] = lvsm::quantisedVisibility4(rounded(code), depth(), T(lvsm::kDepthErrorQuantised32<double>));
            }
            else
            {
                lit[i] = lvsm::quantisedVisibility4(exact(m_maps.slices.at(x, y, kQuantised)), depth(),
                                                    T(lvsm::kDepthErrorQuantised64<double>));
            }
        }
        return lvsm::bilinearVisibility(lit, Vec2(T(fraction.x), T(fraction.y)));
    }

private:
    T depth() const { return T(m_receiver.depth); }
    T bias() const { return T(kMomentBias); }

    static glm::dvec4 emptyExponential() { return lvsm::exponentialMoments(1.0, glm::dvec2(5, 4)); }

    static Vec2 two(const Vec4& v) { return {v.x, v.y}; }

    static Vec4 exact(const glm::vec4& v)
    {
        return {T(static_cast<double>(v.x)), T(static_cast<double>(v.y)), T(static_cast<double>(v.z)),
                T(static_cast<double>(v.w))};
    }

    // A double, or all that lies within an error of it.
    static T around(double value, double error)
    {
        if constexpr (std::is_same_v<T, Interval>)
            return Interval(value - error, value + error);
        else
            return value;
    }

    // What the unpacking rounds once more.
    static Vec4 rounded(const glm::dvec4& v)
    {
        const double error = 2.0 / (1 << 24);
        return {around(v.x, error), around(v.y, error), around(v.z, error), around(v.w, error)};
    }

    // A filtered texel with the rounding of its sums, which goes by the largest of the texels.
    Vec4 sample(int slice, const glm::dvec4& border, glm::dvec2 offset = glm::dvec2(0)) const
    {
        Receiver moved = m_receiver;
        moved.uv += offset / double(kSize);
        const glm::dvec4 texel = filteredTexel(m_maps.slices, moved, slice, border);
        Vec4 result;
        for (int c = 0; c < 4; ++c)
        {
            const double error = 8.0 / (1 << 24) * std::max(largest(slice, c), std::abs(border[c]));
            result[c] = around(texel[c], error);
        }
        return result;
    }

    double largest(int slice, int component) const
    {
        double found = 0;
        for (int i = 0; i < kSize * kSize; ++i)
            found = std::max(found,
                             std::abs(static_cast<double>(m_maps.slices.at(i % kSize, i / kSize, slice)[component])));
        return found;
    }

    Vec4 encoded(int slice) const { return lvsm::decodeMoments4(sample(slice, lvsm::encodeMoments4(glm::dvec4(1)))); }

    static int layerOf(const T& depth)
    {
        T splits[kLayers + 1];
        for (int i = 0; i <= kLayers; ++i)
            splits[i] = T(static_cast<double>(kSplits[i]));
        return lvsm::layerIndex(depth, splits, kLayers);
    }

    static Vec2 interval(int first, int last)
    {
        return {T(static_cast<double>(kSplits[first])), T(static_cast<double>(kSplits[last + 1]))};
    }

    Vec2 layerMoments(bool compact, int layer, glm::dvec2 offset = glm::dvec2(0)) const
    {
        if (layer < 0 || layer >= kLayers)
            return Vec2(T(layer < 0 ? 1.0 : 0.0));
        const double second = compact ? 0 : 1;
        const Vec4 texel =
            sample((compact ? kCompact : kContiguous) + layer / 2, glm::dvec4(1, second, 1, second), offset);
        const Vec2 kept = lvsm::unpackLayer(texel, layer);
        return compact ? lvsm::expandMoments(kept) : kept;
    }

    T planeCovariance(bool compact, int layer, const Vec2& gradient) const
    {
        if (layer < 0 || layer >= kLayers)
            return T(0.0);
        const auto mean = [&](double x, double y)
        {
            return layerMoments(compact, layer, {x, y}).x;
        };
        return lvsm::planeCovariance(Vec4(mean(1, 0), mean(-1, 0), mean(0, 1), mean(0, -1)), gradient, T(1.5));
    }

    const Maps& m_maps;
    const Receiver& m_receiver;
};

struct Technique
{
    std::string name;
    int result;
    int components;
    std::function<double(const Techniques<double>&)> expected;
    std::function<Interval(const Techniques<Interval>&)> allowed;
};

template <typename F>
Technique technique(const std::string& name, int result, int components, const F& call)
{
    return {name, result, components, [=](const Techniques<double>& t) { return call(t); },
            [=](const Techniques<Interval>& t)
            {
                return call(t);
            }};
}

std::vector<Technique> allTechniques()
{
    return {technique("sampleVariance", 25, 2, [](const auto& t) { return t.variance(); }),
            technique("sampleExponential2", 26, 2, [](const auto& t) { return t.exponential2(); }),
            technique("samplePackedQuantised4", 27, 2, [](const auto& t) { return t.quantised(true); }),
            technique("sampleExponential4", 28, 4, [](const auto& t) { return t.exponential4(); }),
            technique("sampleMoments4", 29, 4, [](const auto& t) { return t.moments4(); }),
            technique("sampleMoments4, encoded", 30, 4, [](const auto& t) { return t.encodedMoments4(); }),
            technique("sampleLayeredMoments4", 31, 4, [](const auto& t) { return t.layeredMoments4(); }),
            technique("sampleTrigonometric", 32, 4, [](const auto& t) { return t.trigonometric(); }),
            technique("sampleBracketed2", 33, 4, [](const auto& t) { return t.bracketed2(); }),
            technique("sampleBracketed", 34, 4, [](const auto& t) { return t.bracketed(false); }),
            technique("sampleBracketed, compact", 35, 4, [](const auto& t) { return t.bracketed(true); }),
            technique("samplePlane", 36, 4, [](const auto& t) { return t.plane(false, 1); }),
            technique("samplePlane, compact and steep", 37, 4, [](const auto& t) { return t.plane(true, 8); }),
            technique("sampleConvolution", 38, 4, [](const auto& t) { return t.convolution(); }),
            technique("sampleQuantised4", 39, 4, [](const auto& t) { return t.quantised(false); })};
}

// Half the width of what is allowed, and its middle.
struct Allowed
{
    double lo = HUGE_VAL;
    double hi = -HUGE_VAL;
};

Allowed allowedFor(const Technique& technique, const Maps& maps, const Receiver& receiver)
{
    const Techniques<Interval> numbers(maps, receiver);
    Allowed allowed;
    const bool followed = parity::enumerateOutcomes(kOutcomes,
                                                    [&]
                                                    {
                                                        const Interval result = technique.allowed(numbers);
                                                        allowed.lo = std::min(allowed.lo, result.lo());
                                                        allowed.hi = std::max(allowed.hi, result.hi());
                                                    });
    return followed ? allowed : Allowed{0, 1};
}

} // namespace

bool compareTechniques(const Maps& maps, const std::vector<Receiver>& receivers, const std::vector<float>& results,
                       int components)
{
    bool passed = true;
    for (const Technique& technique : allTechniques())
    {
        if (technique.components > components)
            continue;
        Comparison comparison(technique.name);
        std::size_t tight = 0;
        for (std::size_t i = 0; i < receivers.size(); ++i)
        {
            const double expected = technique.expected(Techniques<double>(maps, receivers[i]));
            const Allowed allowed = allowedFor(technique, maps, receivers[i]);
            const double tolerance = std::max(allowed.hi - expected, expected - allowed.lo);
            tight += tolerance < 0.02 ? 1 : 0;
            comparison.expect(static_cast<double>(results[i * kResults + static_cast<std::size_t>(technique.result)]),
                              expected, tolerance,
                              "texel " + std::to_string(receivers[i].uv.x * kSize) + ' ' +
                                  std::to_string(receivers[i].uv.y * kSize) + " depth " +
                                  std::to_string(receivers[i].depth));
        }
        // What hardly any answer could miss is no test.
        const bool judges = 3 * tight > receivers.size();
        std::printf("%s tolerance below 0.02 for %zu of %zu\n", judges ? "    " : "FAIL", tight, receivers.size());
        passed = comparison.passed() && judges && passed;
    }
    return passed;
}

} // namespace sampling
