#include "placement.hpp"

#include <algorithm>
#include <cmath>

#include <lvsm/bracket.hpp>
#include <lvsm/optimal.hpp>
#include <lvsm/placement.hpp>

namespace lvsm::place_layers
{
namespace
{

constexpr int kBins = 1024;
constexpr int kIterations = 64;
constexpr double kTolerance = 1.0e-4;
constexpr double kMinVariance = 1.0e-6;
constexpr double kMaxVariance = 0.25;
constexpr double kFloor = 1.0e-5; // of the shaders' estimates, as the quick start takes it
constexpr int kMostWindows = 4096;
constexpr double kBias = 0.01; // towards the light, or else slanted surfaces would be judged to shade themselves

int binOf(double depth)
{
    return std::min(static_cast<int>(depth * kBins), kBins - 1);
}

// Calls for each pixel with its depth, weight and the moments of it and the next in x, y and both, all of them finite.
template <typename Visit>
void forEachNeighbourhood(const Task& task, const Visit& visit)
{
    const Image& depths = task.depths;
    const auto momentsAt = [&](int x, int y)
    {
        const int column = std::min(x, depths.width - 1), row = std::min(y, depths.height - 1);
        return depthMoments(static_cast<double>(depths.at(column, row)));
    };
    const auto isKnown = [&](int x, int y)
    {
        return !std::isnan(depths.at(std::min(x, depths.width - 1), std::min(y, depths.height - 1)));
    };
    for (int y = 0; y < depths.height; ++y)
    {
        for (int x = 0; x < depths.width; ++x)
        {
            if (isKnown(x, y) && isKnown(x + 1, y) && isKnown(x, y + 1) && isKnown(x + 1, y + 1))
                visit(static_cast<double>(depths.at(x, y)), task.weightAt(x, y),
                      neighbourhoodMoments(momentsAt(x, y), momentsAt(x + 1, y), momentsAt(x, y + 1),
                                           momentsAt(x + 1, y + 1)));
        }
    }
}

std::vector<float> uniformSplits(int layerCount)
{
    std::vector<float> splits;
    for (int i = 0; i <= layerCount; ++i)
        splits.push_back(uniformSplit<float>(i, layerCount));
    return splits;
}

// lloydRelax with weights, which it takes none of: the steps that a renderer runs, over a histogram.
std::vector<float> relaxedSplits(const Task& task)
{
    std::vector<double> weights(kBins), sums(kBins);
    forEachNeighbourhood(task,
                         [&](double, double weight, const glm::dvec2& moments)
                         {
                             const double occluder = secondOccluder(moments);
                             const auto bin = static_cast<std::size_t>(binOf(occluder));
                             const double amount = weight * occluderWeight(moments, kMinVariance, kMaxVariance);
                             weights[bin] += amount;
                             sums[bin] += amount * occluder;
                         });
    std::vector<double> splits;
    for (const float split : uniformSplits(task.layerCount))
        splits.push_back(static_cast<double>(split));
    int teleports = 2 * (task.layerCount - 1);
    double movement = 1;
    for (int iteration = 0; iteration < kIterations && movement > kTolerance; ++iteration)
    {
        std::vector<double> clusterWeights(splits.size()), clusterSums(splits.size());
        for (std::size_t bin = 0; bin < kBins; ++bin)
        {
            if (weights[bin] <= 0)
                continue;
            const auto nearest =
                static_cast<std::size_t>(nearestSplit(sums[bin] / weights[bin], splits.data(), task.layerCount));
            clusterWeights[nearest] += weights[bin];
            clusterSums[nearest] += sums[bin];
        }
        const std::vector<double> before = splits;
        for (std::size_t i = 1; i + 1 < splits.size(); ++i)
            splits[i] = updateSplit(splits[i], clusterSums[i], clusterWeights[i]);
        monotoneSplits(splits.data(), task.layerCount);
        const std::vector<double> relaxed = splits;
        if (teleports > 0)
            teleportSplits(splits.data(), clusterWeights.data(), task.layerCount);
        teleports -= splits != relaxed ? 1 : 0;
        movement = 0;
        for (std::size_t i = 0; i < splits.size(); ++i)
            movement = std::max(movement, std::abs(splits[i] - before[i]));
    }
    return {splits.begin(), splits.end()};
}

// optimalSplits with weights.
std::vector<float> optimalSplits(const Task& task)
{
    std::vector<float> splits(static_cast<std::size_t>(task.layerCount) + 1);
    std::vector<float> weights(kBins);
    forEachNeighbourhood(task,
                         [&](double depth, double weight, const glm::dvec2& moments) {
                             weights[static_cast<std::size_t>(binOf(depth))] +=
                                 static_cast<float>(weight * std::sqrt(variance(moments, 0.0)));
                         });
    const bool isPlaced = task.layerCount <= kMaxOptimalLayers &&
                          optimalSplitsHistogram(weights.data(), kBins, splits.data(), task.layerCount);
    return isPlaced ? splits : std::vector<float>{};
}

// Judges receivers at the depths of a window, by the window's layers.
class WindowErrors
{
public:
    WindowErrors(const Task& task, const std::vector<float>& splits) : m_task(task), m_splits(splits) {}

    void add(const std::vector<double>& taps, double weight)
    {
        const double share = 1.0 / static_cast<double>(taps.size());
        for (const double surface : taps)
        {
            const double depth = std::max(surface - kBias, 0.0);
            double lit = 0;
            for (const double tap : taps)
                lit += tap >= depth ? share : 0.0;
            const int layer = layerIndex(static_cast<float>(depth), m_splits.data(), m_task.layerCount);
            const glm::dvec2 own = momentsOf(taps, layer);
            const double layered = layeredVisibility(own, depth, intervalOf(layer), kFloor);
            const glm::dvec2 front = layer > 0 ? momentsOf(taps, layer - 1) : glm::dvec2(1);
            const glm::dvec2 behind = layer + 1 < m_task.layerCount ? momentsOf(taps, layer + 1) : glm::dvec2(0);
            const double bracketed = bracketedVisibility(front, own, behind, depth, intervalOf(layer), kFloor);
            m_layered += weight * (layered - lit) * (layered - lit);
            m_bracketed += weight * (bracketed - lit) * (bracketed - lit);
            m_weight += weight;
        }
    }

    Errors errors() const
    {
        const double inverse = m_weight > 0 ? 1 / m_weight : 0;
        Errors errors{std::sqrt(m_layered * inverse), std::nullopt};
        if (m_task.overlap <= 0)
            errors.bracketed = std::sqrt(m_bracketed * inverse);
        return errors;
    }

private:
    glm::dvec2 intervalOf(int layer) const
    {
        const auto i = static_cast<std::size_t>(layer);
        return layerInterval(static_cast<double>(m_splits[i]), static_cast<double>(m_splits[i + 1]),
                             static_cast<double>(m_task.overlap));
    }

    glm::dvec2 momentsOf(const std::vector<double>& taps, int layer) const
    {
        glm::dvec2 sum(0);
        for (const double tap : taps)
            sum += layerMoments(tap, intervalOf(layer));
        return sum / static_cast<double>(taps.size());
    }

    const Task& m_task;
    const std::vector<float>& m_splits;
    double m_layered = 0;
    double m_bracketed = 0;
    double m_weight = 0;
};

// Over windows spread evenly, each of the pixels that are known in it.
Errors predictedErrors(const Task& task, const std::vector<float>& splits)
{
    const Image& depths = task.depths;
    const double pixels = static_cast<double>(depths.width) * depths.height;
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostWindows))));
    WindowErrors errors(task, splits);
    for (int y = 0; y < depths.height; y += step)
    {
        for (int x = 0; x < depths.width; x += step)
        {
            std::vector<double> taps;
            for (int v = y; v < std::min(y + kWindow, depths.height); ++v)
                for (int u = x; u < std::min(x + kWindow, depths.width); ++u)
                    if (!std::isnan(depths.at(u, v)))
                        taps.push_back(static_cast<double>(depths.at(u, v)));
            if (!taps.empty())
                errors.add(taps, task.weightAt(x, y));
        }
    }
    return errors.errors();
}

} // namespace

std::vector<Placement> placeLayers(const Task& task)
{
    std::vector<Placement> placements{{"uniform", uniformSplits(task.layerCount), {}},
                                      {"lloyd", relaxedSplits(task), {}},
                                      {"optimal", optimalSplits(task), {}}};
    for (Placement& placement : placements)
    {
        if (!placement.splits.empty())
            placement.errors = predictedErrors(task, placement.splits);
    }
    return placements;
}

} // namespace lvsm::place_layers
