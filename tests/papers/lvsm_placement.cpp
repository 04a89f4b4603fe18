// LVSM section 4.1 and the placement of section 5, frame by frame with the library's steps.
#include <algorithm>
#include <cmath>

#include <lvsm/placement.hpp>

#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

constexpr int kSize = 256;
constexpr float kNear = 1.0f / 256.0f;
constexpr int kManyFrames = 200;

using Splits = std::vector<float>;

struct Sample
{
    float value, weight;
};

std::vector<Sample> secondOccluders(const quality::Scene& scene)
{
    const std::vector<float> depths = mapDepths(scene);
    const auto moments = [&](int x, int y)
    {
        return depthMoments(depths[quality::texelIndex(x, y, kSize)]);
    };
    std::vector<Sample> samples;
    for (int y = 0; y + 1 < kSize; ++y)
    {
        for (int x = 0; x + 1 < kSize; ++x)
        {
            const glm::vec2 four =
                neighbourhoodMoments(moments(x, y), moments(x + 1, y), moments(x, y + 1), moments(x + 1, y + 1));
            const float weight = occluderWeight(four, 1e-6f, 0.25f);
            if (weight > 0.0f)
                samples.push_back({secondOccluder(four), weight});
        }
    }
    return samples;
}

/// Moves two splits to the means of their clusters, both judged before either moves; the weights of all clusters.
std::vector<float> moveTwo(const std::vector<Sample>& samples, Splits& splits, glm::ivec2 two)
{
    const int count = static_cast<int>(splits.size()) - 1;
    glm::dvec4 sums(0.0);
    std::vector<double> weights(splits.size());
    for (const Sample& s : samples)
    {
        const int nearest = nearestSplit(s.value, splits.data(), count);
        sums += accumulateSplits<double>(s.value, s.weight, nearest, two.x, two.y);
        weights[static_cast<std::size_t>(nearest)] += static_cast<double>(s.weight);
    }
    const auto move = [&](int split, double weighted, double weight)
    {
        float& at = splits[static_cast<std::size_t>(split)];
        at = static_cast<float>(updateSplit(static_cast<double>(at), weighted, weight));
    };
    move(two.x, sums.x, sums.y);
    if (two.y != two.x)
        move(two.y, sums.z, sums.w);
    return {weights.begin(), weights.end()};
}

/// One frame: two splits move, and one whose cluster is empty goes elsewhere.
void step(const std::vector<Sample>& samples, Splits& splits, int frame, bool teleports)
{
    const int count = static_cast<int>(splits.size()) - 1;
    const std::vector<float> weights = moveTwo(samples, splits, scheduledSplits(frame, count));
    monotoneSplits(splits.data(), count);
    if (teleports)
        teleportSplits(splits.data(), weights.data(), count);
}

float furthest(const Splits& a, const Splits& b)
{
    float most = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

Splits relaxed(const std::vector<Sample>& samples, Splits splits, bool teleports)
{
    for (int frame = 0; frame < kManyFrames; ++frame)
        step(samples, splits, frame, teleports);
    return splits;
}

/// Weighted mean of the squared distance to the nearest split: what the relaxation lessens.
double objective(const std::vector<Sample>& samples, const Splits& splits)
{
    double sum = 0.0, weight = 0.0;
    for (const Sample& s : samples)
    {
        const int nearest = nearestSplit(s.value, splits.data(), static_cast<int>(splits.size()) - 1);
        const auto away = static_cast<double>(s.value - splits[static_cast<std::size_t>(nearest)]);
        sum += static_cast<double>(s.weight) * away * away;
        weight += static_cast<double>(s.weight);
    }
    return sum / weight;
}

/// Frames until the splits stay within 1/256 of where they end, and until the objective is within 5% of its end.
void convergence(Report& report, const std::string& of, const std::vector<Sample>& samples, int count)
{
    constexpr double kCloseEnough = 1.05;
    const Splits end = relaxed(samples, uniformSplits(count), true);
    const double least = objective(samples, end);
    Splits splits = uniformSplits(count);
    int places = 0, values = 0;
    for (int frame = 0; frame < kManyFrames; ++frame)
    {
        places = furthest(splits, end) > kNear ? frame + 1 : places;
        values = objective(samples, splits) > kCloseEnough * least ? frame + 1 : values;
        step(samples, splits, frame, true);
    }
    report.add("convergence", of, values);
    report.add("convergence", of + "_places", places);
}

/// What is left of the objective and of bleeding with teleportation, in shares of that without.
void teleportation(Report& report, const std::string& of, const Lit& scene, int count)
{
    const auto samples = secondOccluders(scene.scene);
    double values[2], bleeding[2];
    for (const int teleports : {0, 1})
    {
        const Splits splits = relaxed(samples, uniformSplits(count), teleports == 1);
        const Layering layering{splits, quality::Format::Unorm16, 0.0f, 0.0f};
        values[teleports] = objective(samples, splits);
        bleeding[teleports] = errorsOf(scene.view, visibilities(scene, layered(layering))).bleed;
    }
    report.add("teleportation", of + std::to_string(count), values[1] / values[0]);
    report.add("teleportation", of + std::to_string(count) + "_bleed", bleeding[1] / bleeding[0]);
}

void secondOccluderRow(Report& report)
{
    for (const double share : {0.5, 0.25})
    {
        double worst = 0.0;
        for (double a = 0.0; a <= 1.0; a += 0.125)
        {
            for (double b = 0.0; b <= 1.0; b += 0.125)
            {
                const glm::dvec2 moments = share * depthMoments(a) + (1.0 - share) * depthMoments(b);
                worst = std::max(worst, std::abs(secondOccluder(moments) - std::max(a, b)));
            }
        }
        report.add("secondOccluder", share == 0.5 ? "half" : "quarter", worst);
    }
}

quality::Scene mapOf(const std::string& name, Setup setup, float turn)
{
    setup.light.azimuth += turn;
    return {name, depthPeel(setup.mesh, lightOf(setup, kSize), kSize), true};
}

/// A light that turns by half a degree a frame: how far the splits are from where they would come to rest.
void movingLight(Report& report, const std::string& name, const Setup& setup)
{
    constexpr int kFrames = 24;
    constexpr int kLayers = 4;
    Splits splits = relaxed(secondOccluders(mapOf(name, setup, 0.0f)), uniformSplits(kLayers), true);
    float most = 0.0f;
    for (int frame = 0; frame < kFrames; ++frame)
    {
        const auto samples = secondOccluders(mapOf(name, setup, 0.5f * static_cast<float>(frame)));
        step(samples, splits, frame, true);
        most = std::max(most, furthest(splits, relaxed(samples, splits, true)));
    }
    report.add("moving", name, static_cast<double>(most));
}

} // namespace

void lvsmPlacement(Report& report)
{
    secondOccluderRow(report);
    for (const auto& [name, setup] : {std::pair<std::string, Setup>("bench", bench()), {"blocks", blocks()}})
    {
        const Lit scene = lit(name, setup, kSize, 7, 300);
        const auto samples = secondOccluders(scene.scene);
        for (const int count : {2, 4, 8})
            convergence(report, name + std::to_string(count), samples, count);
        // The scene takes the last third of the light's range, so that uniform splits begin far from it.
        for (const int count : {4, 8})
        {
            teleportation(report, name, scene, count);
            teleportation(report, name + "_far", farther(scene, 0.3f), count);
        }
        movingLight(report, name, setup);
    }
}

} // namespace lvsm::papers
