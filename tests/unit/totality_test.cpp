// Every function stays in its documented range for whatever bits it is given, in C++ NaN and infinity included.
#include <lvsm/bracket.hpp>
#include <lvsm/exponential.hpp>
#include <lvsm/moments4.hpp>
#include <lvsm/placement.hpp>
#include <lvsm/plane.hpp>
#include <lvsm/quantised.hpp>
#include <lvsm/receiver.hpp>
#include <lvsm/trigonometric.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "numbers.hpp"

namespace lvsm::unit
{
namespace
{

constexpr int kWords = 18;

template <typename T>
struct Words
{
    std::array<T, kWords> values;

    T operator()(int i) const { return values[static_cast<std::size_t>(i)]; }
    Vec2<T> two(int i) const { return {(*this)(i), (*this)(i + 1)}; }
    Vec3<T> three(int i) const { return {(*this)(i), (*this)(i + 1), (*this)(i + 2)}; }
    Vec4<T> four(int i) const { return {(*this)(i), (*this)(i + 1), (*this)(i + 2), (*this)(i + 3)}; }
};

template <typename T>
using Results = std::vector<T>;

template <typename T>
Results<T> components(const Vec2<T>& v)
{
    return {v.x, v.y};
}

template <typename T>
Results<T> components(const Vec4<T>& v)
{
    return {v.x, v.y, v.z, v.w};
}

// A function, how many words it reads, and the range that its documentation promises.
template <typename T>
struct Row
{
    const char* name;
    int words;
    T low;
    T high;
    Results<T> (*call)(const Words<T>&);
};

template <typename T>
std::vector<Row<T>> rows()
{
    using W = const Words<T>&;
    const T most = std::numeric_limits<T>::infinity();
    return {
        {"linstep", 3, 0, 1,
         [](W w)
         {
             return Results<T>{linstep(w(0), w(1), w(2))};
         }},
        {"pointLightDepth", 8, 0, 1,
         [](W w)
         {
             return Results<T>{pointLightDepth(w.three(0), w.three(3), w(6), w(7))};
         }},
        {"planeLightDepth", 11, 0, 1,
         [](W w)
         {
             return Results<T>{planeLightDepth(w.three(0), w.three(3), w.three(6), w(9), w(10))};
         }},
        {"linearDepth", 3, 0, 1,
         [](W w)
         {
             return Results<T>{linearDepth(w(0), w(1), w(2))};
         }},
        {"linearDepthReversed", 3, 0, 1,
         [](W w)
         {
             return Results<T>{linearDepthReversed(w(0), w(1), w(2))};
         }},
        {"signedDepth", 1, -1, 1,
         [](W w)
         {
             return Results<T>{signedDepth(w(0))};
         }},
        {"depthMoments", 1, 0, 1,
         [](W w)
         {
             return components(depthMoments(w(0)));
         }},
        {"depthMomentsSloped", 3, 0, 1,
         [](W w)
         {
             return components(depthMomentsSloped(w(0), w(1), w(2)));
         }},
        {"variance", 3, 0, most,
         [](W w)
         {
             return Results<T>{variance(w.two(0), w(2))};
         }},
        {"chebyshevUpperBound", 4, 0, 1,
         [](W w)
         {
             return Results<T>{chebyshevUpperBound(w.two(0), w(2), w(3))};
         }},
        {"chebyshevLowerBound", 4, 0, 1,
         [](W w)
         {
             return Results<T>{chebyshevLowerBound(w.two(0), w(2), w(3))};
         }},
        {"reduceLightBleeding", 2, 0, 1,
         [](W w)
         {
             return Results<T>{reduceLightBleeding(w(0), w(1))};
         }},
        {"recommendedMinVariance", 2, 0, T(0x1p24),
         [](W w)
         {
             return Results<T>{recommendedMinVariance(w(0), w(1))};
         }},
        {"stepWarp", 2, 0, 1,
         [](W w)
         {
             return Results<T>{stepWarp(w(0), w(1))};
         }},
        {"layerWarp", 3, 0, 1,
         [](W w)
         {
             return Results<T>{layerWarp(w(0), w.two(1))};
         }},
        {"layerInterval", 3, 0, 1,
         [](W w)
         {
             return components(layerInterval(w(0), w(1), w(2)));
         }},
        {"layerMinVariance", 3, 0, T(0.25),
         [](W w)
         {
             return Results<T>{layerMinVariance(w(0), w.two(1))};
         }},
        {"uniformLayerIndex", 1, 0, 6,
         [](W w)
         {
             return Results<T>{T(uniformLayerIndex(w(0), 7))};
         }},
        {"layerIndex", 6, 0, 3,
         [](W w)
         {
             return Results<T>{T(layerIndex(w(0), &w.values[1], 4))};
         }},
        {"layerMoments", 3, 0, 1,
         [](W w)
         {
             return components(layerMoments(w(0), w.two(1)));
         }},
        {"layeredVisibility", 6, 0, 1,
         [](W w)
         {
             return Results<T>{layeredVisibility(w.two(0), w(2), w.two(3), w(5))};
         }},
        {"transitionWeight", 4, T(-0.5), T(0.5),
         [](W w)
         {
             return Results<T>{transitionWeight(w(0), w(1), w(2), w(3))};
         }},
        {"blendTransition", 3, 0, 1,
         [](W w)
         {
             return Results<T>{blendTransition(w(0), w(1), w(2))};
         }},
        {"exponentialWarp", 3, T(-6.6e18), T(6.6e18),
         [](W w)
         {
             return components(exponentialWarp(w(0), w.two(1)));
         }},
        {"exponentialMoments", 3, T(-6.6e18), T(4.3e37),
         [](W w)
         {
             return components(exponentialMoments(w(0), w.two(1)));
         }},
        {"exponentialMinVariance", 4, 0, kLargestFp32<T>,
         [](W w)
         {
             return components(exponentialMinVariance(w(0), w(1), w.two(2)));
         }},
        {"exponentialVisibility2", 5, 0, 1,
         [](W w)
         {
             return Results<T>{exponentialVisibility2(w.two(0), w(2), w(3), w(4))};
         }},
        {"exponentialVisibility4", 8, 0, 1,
         [](W w)
         {
             return Results<T>{exponentialVisibility4(w.four(0), w(4), w.two(5), w(7))};
         }},
        {"maxExponent", 2, 0, kMaxExponent<T>,
         [](W w)
         {
             return Results<T>{maxExponent(w(0), w(1))};
         }},
        {"secondOccluder", 2, 0, 1,
         [](W w)
         {
             return Results<T>{secondOccluder(w.two(0))};
         }},
        {"occluderWeight", 4, 0, most,
         [](W w)
         {
             return Results<T>{occluderWeight(w.two(0), w(2), w(3))};
         }},
        {"nearestSplit", 6, 1, 3,
         [](W w)
         {
             return Results<T>{T(nearestSplit(w(0), &w.values[1], 4))};
         }},
        {"updateSplit", 3, 0, 1,
         [](W w)
         {
             return Results<T>{updateSplit(w(0), w(1), w(2))};
         }},
        {"boundedUpperBound", 4, 0, 1,
         [](W w)
         {
             return Results<T>{boundedUpperBound(w.two(0), w(2), w(3))};
         }},
        {"mergeLayers", 6, 0, 1,
         [](W w)
         {
             return components(mergeLayers(w.two(0), w.two(2), w(4), w(5)));
         }},
        {"compactMoments", 2, 0, 1,
         [](W w)
         {
             return components(compactMoments(w.two(0)));
         }},
        {"expandMoments", 2, 0, 1,
         [](W w)
         {
             return components(expandMoments(w.two(0)));
         }},
        {"bracketMoments", 7, 0, 1,
         [](W w)
         {
             return components(bracketMoments(w.two(0), w.two(2), w.two(4), w(6)));
         }},
        {"bracketedVisibility", 10, 0, 1,
         [](W w)
         {
             return Results<T>{bracketedVisibility(w.two(0), w.two(2), w.two(4), w(6), w.two(7), w(9))};
         }},
        {"bracketedBoundedVisibility", 10, 0, 1,
         [](W w)
         {
             return Results<T>{bracketedBoundedVisibility(w.two(0), w.two(2), w.two(4), w(6), w.two(7), w(9))};
         }},
        {"bracketedVisibility2", 7, 0, 1,
         [](W w)
         {
             return Results<T>{bracketedVisibility2(w.four(0), w(4), w(5), w(6))};
         }},
        {"mergedVisibility", 9, 0, 1,
         [](W w)
         {
             return Results<T>{mergedVisibility(w.two(0), w.two(2), w(4), w(5), w(6), w(7), w(8))};
         }},
        {"recommendedMoment4Bias", 1, 0, 1,
         [](W w)
         {
             return Results<T>{recommendedMoment4Bias(w(0))};
         }},
        {"depthMoments4", 1, -1, 1,
         [](W w)
         {
             return components(depthMoments4(w(0)));
         }},
        {"encodeMoments4", 4, 0, 1,
         [](W w)
         {
             return components(encodeMoments4(w.four(0)));
         }},
        {"decodeMoments4", 4, -1, 1,
         [](W w)
         {
             return components(decodeMoments4(w.four(0)));
         }},
        {"hamburgerUpperBound", 6, 0, 1,
         [](W w)
         {
             return Results<T>{hamburgerUpperBound(w.four(0), w(4), w(5))};
         }},
        {"quantiseMoments4", 5, 0, 1,
         [](W w)
         {
             return components(quantiseMoments4(w.four(0), w(4)));
         }},
        {"quantisedVisibility4", 6, 0, 1,
         [](W w)
         {
             return Results<T>{quantisedVisibility4(w.four(0), w(4), w(5))};
         }},
        {"packQuantised4", 4, 0, 65535,
         [](W w)
         {
             return components(Vec2<T>(packQuantised4(w.four(0))));
         }},
        {"recommendedTrigonometricBias", 1, 0, 1,
         [](W w)
         {
             return Results<T>{recommendedTrigonometricBias(w(0))};
         }},
        {"trigonometricMoments", 1, 0, 1,
         [](W w)
         {
             return components(trigonometricMoments(w(0)));
         }},
        {"trigonometricVisibility", 6, 0, 1,
         [](W w)
         {
             return Results<T>{trigonometricVisibility(w.four(0), w(4), w(5))};
         }},
        {"momentVisibility4", 6, 0, 1,
         [](W w)
         {
             return Results<T>{momentVisibility4(w.four(0), w(4), w(5))};
         }},
        {"layerMoments4", 3, -1, 1,
         [](W w)
         {
             return components(layerMoments4(w(0), w.two(1)));
         }},
        {"layeredVisibility4", 8, 0, 1,
         [](W w)
         {
             return Results<T>{layeredVisibility4(w.four(0), w(4), w.two(5), w(7))};
         }},
        {"bracketedVisibility4", 16, 0, 1,
         [](W w)
         {
             return Results<T>{bracketedVisibility4(w.four(0), w.four(4), w.four(8), w(12), w.two(13), w(15))};
         }},
        {"planeCovariance", 7, T(-4294967296), T(4294967296),
         [](W w)
         {
             return Results<T>{planeCovariance(w.four(0), w.two(4), w(6))};
         }},
        {"planeVariance", 3, 0, T(8589934592),
         [](W w)
         {
             return Results<T>{planeVariance(w.two(0), w(2))};
         }},
        {"planeBracketedVisibility", 15, 0, 1,
         [](W w)
         {
             return Results<T>{planeBracketedVisibility(w.two(0), w.two(2), w.two(4), w.three(6), w(9), w.two(10),
                                                        w(12), w(13), w(14))};
         }},
        {"receiverGradient", 6, -1, 1,
         [](W w)
         {
             return components(receiverGradient(w.three(0), w.three(3)));
         }},
        {"planeDepth", 5, 0, 1,
         [](W w)
         {
             return Results<T>{planeDepth(w(0), w.two(1), w.two(3))};
         }},
        {"shiftReceiver", 4, 0, 1,
         [](W w)
         {
             return Results<T>{shiftReceiver(w(0), w.two(1), w(3))};
         }},
        {"receiverMinVariance", 4, 0, most,
         [](W w)
         {
             return Results<T>{receiverMinVariance(w(0), w.two(1), w(3))};
         }},
    };
}

template <typename T>
void claimInRange(const Row<T>& row, const Words<T>& words, Tally& tally)
{
    for (const T result : row.call(words))
    {
        tally.claim(result >= row.low && result <= row.high, row.name, result, words(0), words(1), words(2), words(3),
                    words(4), words(5), words(6), words(7));
    }
}

TEST_CASE_TEMPLATE("any bit pattern gives a result in the documented range", T, float, double)
{
    for (const Row<T>& row : rows<T>())
    {
        Random random(70);
        Tally tally;
        for (int i = 0; i < drawsOf(30000); ++i)
        {
            Words<T> words;
            for (T& word : words.values)
                word = i % 2 == 0 ? random.pattern<T>() : 4 * random.unit<T>() - 1;
            if (i % 2 != 0)
                words.values[static_cast<std::size_t>(random.between(0, row.words - 1))] = random.pattern<T>();
            claimInRange(row, words, tally);
        }
        LVSM_CHECK_TALLY(tally);
    }
}

TEST_CASE_TEMPLATE("NaN infinity and limits in any argument give a result in the documented range", T, float, double)
{
    // Every pair of special values in every pair of arguments, the others ordinary.
    const std::vector<T> special = specialValues<T>();
    for (const Row<T>& row : rows<T>())
    {
        Random random(71);
        Tally tally;
        for (int first = 0; first < row.words; ++first)
        {
            for (int second = first; second < row.words; ++second)
            {
                for (const T a : special)
                {
                    for (const T b : special)
                    {
                        Words<T> words;
                        for (T& word : words.values)
                            word = random.unit<T>();
                        words.values[static_cast<std::size_t>(first)] = a;
                        words.values[static_cast<std::size_t>(second)] = b;
                        claimInRange(row, words, tally);
                    }
                }
            }
        }
        LVSM_CHECK_TALLY(tally);
    }
}

TEST_CASE_TEMPLATE("finite moments keep a finite variance and weight", T, float, double)
{
    Random random(72);
    Tally tally;
    for (int i = 0; i < drawsOf(200000); ++i)
    {
        const Vec2<T> moments(random.finitePattern<T>(), random.finitePattern<T>());
        const T floor = random.finitePattern<T>();
        const T most = random.finitePattern<T>();
        const T v = variance(moments, floor);
        tally.claim(isFinite(v) && v >= floor && v >= T(0), moments.x, moments.y, floor);
        const T weight = occluderWeight(moments, floor, most);
        tally.claim(weight >= T(0) && weight <= std::max(most, T(0)), moments.x, moments.y, floor, most);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("layer intervals of any splits give finite warps and never widen the outer ends", T, float, double)
{
    Random random(73);
    Tally tally;
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const T begin = i % 2 == 0 ? random.unit<T>() : random.pattern<T>();
        const T end = i % 3 == 0 ? begin : i % 3 == 1 ? random.unit<T>() : random.pattern<T>();
        const T overlap = random.pattern<T>();
        const Vec2<T> interval = layerInterval(begin, end, overlap);
        tally.claim(interval.x >= T(0) && interval.y <= T(1), begin, end, overlap);
        tally.claim(layerInterval(T(0), end, overlap).x == T(0), end, overlap);
        tally.claim(layerInterval(begin, T(1), overlap).y == T(1), begin, overlap);
        const T warped = layerWarp(random.unit<T>(), interval);
        tally.claim(warped >= T(0) && warped <= T(1), begin, end, overlap, warped);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("sums and averages of finite values stay finite", T, float, double)
{
    Random random(74);
    Tally tally;
    const auto any = [&random]
    {
        return Vec2<T>(random.finitePattern<T>(), random.finitePattern<T>());
    };
    const Vec2<T> largest(std::numeric_limits<T>::max());
    CHECK(neighbourhoodMoments(largest, largest, largest, largest) == largest);
    for (int i = 0; i < drawsOf(100000); ++i)
    {
        const Vec2<T> average = neighbourhoodMoments(any(), any(), any(), any());
        tally.claim(isFinite(average.x) && isFinite(average.y), i);
        const Vec4<T> sums = accumulateSplits(random.finitePattern<T>(), random.finitePattern<T>(), 1, 1, 1);
        for (int k = 0; k < 4; ++k)
            tally.claim(isFinite(sums[k]), i);
    }
    LVSM_CHECK_TALLY(tally);
}

TEST_CASE_TEMPLATE("teleportSplits takes any weights and keeps the splits in order", T, float, double)
{
    Random random(75);
    Tally tally;
    for (int i = 0; i < drawsOf(50000); ++i)
    {
        const int count = random.between(1, 8);
        std::vector<T> splits{T(0), T(1)};
        for (int k = 1; k < count; ++k)
            splits.push_back(random.unit<T>());
        std::sort(splits.begin(), splits.end());
        std::vector<T> weights;
        for (int k = 0; k <= count; ++k)
            weights.push_back(random.between(0, 2) == 0 ? T(0) : random.pattern<T>());
        teleportSplits(splits.data(), weights.data(), count);
        tally.claim(std::is_sorted(splits.begin(), splits.end()) && splits.front() == T(0) && splits.back() == T(1), i);
    }
    LVSM_CHECK_TALLY(tally);
}

} // namespace
} // namespace lvsm::unit
