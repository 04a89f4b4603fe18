// lvsm_bench: what the host functions cost in time, beside one pass that does nothing but read the same depths.
#include <lvsm/lloyd.hpp>
#include <lvsm/optimal.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <random>
#include <vector>

namespace
{

constexpr int kSize = 2048;
constexpr std::size_t kTexels = std::size_t(kSize) * kSize;
constexpr int kMaxLayers = 16;

using Depths = std::vector<float>;
using Splits = std::array<float, kMaxLayers + 1>;

// Boxes of all sizes over a slope.
Depths makeDepths()
{
    std::mt19937 random(1);
    const auto between = [&random](int low, int high)
    {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    };
    Depths depths(kTexels);
    for (std::size_t i = 0; i < kTexels; ++i)
        depths[i] = 0.9f - 0.1f * static_cast<float>(i / kSize) / kSize;
    for (int box = 0; box < 300; ++box)
    {
        const int left = between(0, kSize);
        const int top = between(0, kSize);
        const int right = std::min(left + between(20, 220), kSize);
        const int bottom = std::min(top + between(20, 220), kSize);
        const float nearest = 0.8f * static_cast<float>(between(0, 1000)) / 1000.0f;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x)
            {
                float& depth = depths[std::size_t(y) * kSize + std::size_t(x)];
                depth = std::min(depth, nearest + 1.0e-5f * static_cast<float>(x));
            }
    }
    return depths;
}

// Copies of one image, 201 MB together: taken in turn, each comes from memory and not from a cache.
class Images
{
public:
    const float* next()
    {
        m_turn = (m_turn + 1) % m_copies.size();
        return m_copies[m_turn].data();
    }

private:
    std::vector<Depths> m_copies = std::vector<Depths>(12, makeDepths());
    std::size_t m_turn = 0;
};

Images& images()
{
    static Images all;
    return all;
}

// As many sums as keep the vector units busy: then memory is what limits this pass.
float readOnce(const float* depths)
{
    constexpr std::size_t kLanes = 64;
    float sums[kLanes] = {};
    for (std::size_t i = 0; i < kTexels; i += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            sums[lane] += depths[i + lane];
    float total = 0.0f;
    for (const float sum : sums)
        total += sum;
    return total;
}

template <typename Work>
double secondsOf(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void readPass(benchmark::State& state)
{
    for (auto turn : state)
        benchmark::DoNotOptimize(readOnce(images().next()));
    state.SetBytesProcessed(state.iterations() * std::int64_t(kTexels * sizeof(float)));
}

// Times place(depths, splits) on one image after a read of another, so that both see the same load of the machine and
// nothing of the image is left in a cache. of_bandwidth: time of the reads over time of the placements.
template <typename Place>
void timeBesideRead(benchmark::State& state, const Place& place)
{
    double reading = 0.0;
    double placing = 0.0;
    for (auto turn : state)
    {
        reading += secondsOf([] { benchmark::DoNotOptimize(readOnce(images().next())); });
        Splits splits{};
        const float* depths = images().next();
        bool isPlaced = false;
        const double seconds = secondsOf([&] { isPlaced = place(depths, splits.data()); });
        if (!isPlaced)
            state.SkipWithError("no splits");
        benchmark::DoNotOptimize(splits);
        state.SetIterationTime(seconds);
        placing += seconds;
    }
    state.counters["of_bandwidth"] = reading / placing;
}

double shareSampled(int maxSamples)
{
    return maxSamples > 0 ? std::min(1.0, double(maxSamples) / double(kTexels)) : 1.0;
}

// Layers, and maxSamples; 0 takes all texels.
void optimalSplits(benchmark::State& state)
{
    const int layerCount = static_cast<int>(state.range(0));
    lvsm::OptimalOptions<float> options;
    options.maxSamples = static_cast<int>(state.range(1));
    timeBesideRead(state, [&](const float* depths, float* splits)
                   { return bool(lvsm::optimalSplits(depths, kSize, kSize, splits, layerCount, options)); });
    state.counters["share_sampled"] = shareSampled(options.maxSamples);
}

void lloydRelax(benchmark::State& state)
{
    const int layerCount = static_cast<int>(state.range(0));
    lvsm::RelaxOptions<float> options;
    options.maxSamples = static_cast<int>(state.range(1));
    timeBesideRead(state, [&](const float* depths, float* splits)
                   { return bool(lvsm::lloydRelax(depths, kSize, kSize, splits, layerCount, options)); });
    state.counters["share_sampled"] = shareSampled(options.maxSamples);
}

void optimalSplitsHistogram(benchmark::State& state)
{
    const int layerCount = static_cast<int>(state.range(0));
    std::mt19937 random(2);
    std::vector<float> weights(lvsm::kMaxOptimalBins);
    for (float& weight : weights)
        weight = static_cast<float>(random() % 1000);
    Splits splits{};
    for (auto turn : state)
    {
        benchmark::DoNotOptimize(
            lvsm::optimalSplitsHistogram(weights.data(), lvsm::kMaxOptimalBins, splits.data(), layerCount));
        benchmark::ClobberMemory();
    }
}

// Into every report, so that a table can say what it was measured with.
const bool kContext = []
{
    benchmark::AddCustomContext("compiler", LVSM_COMPILER);
    return true;
}();

const int kDefaultSamples = lvsm::OptimalOptions<float>().maxSamples;

BENCHMARK(readPass)->Unit(benchmark::kMillisecond);
BENCHMARK(optimalSplits)
    ->ArgNames({"layers", "samples"})
    ->Args({4, kDefaultSamples})
    ->Args({8, kDefaultSamples})
    ->Args({4, 0})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(lloydRelax)
    ->ArgNames({"layers", "samples"})
    ->Args({4, kDefaultSamples})
    ->Args({4, 0})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(optimalSplitsHistogram)->ArgName("layers")->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
