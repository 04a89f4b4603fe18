// LVSM figure 4 and the transitions of section 5: what shows where a split cuts through a receiver.
#include <cmath>

#include <lvsm/filter.hpp>
#include <lvsm/layers.hpp>

#include "report.hpp"

namespace lvsm::papers
{
namespace
{

constexpr double kSplit = 0.5;
constexpr double kSlope = 0.002; ///< of the ground, over a texel
constexpr int kTaps = 15;
constexpr int kTexels = 120;
constexpr int kSteps = 4; ///< places to look at, a texel
constexpr double kMinVariance = 1e-5;

using Line = std::vector<double>;

double groundAt(double texel)
{
    return kSplit + kSlope * (texel - 0.5 * kTexels);
}

/// Visibilities along a slanted ground with one split half-way: lit, or in the full shadow of something at 0.2.
Line walk(double overlap, bool shadowed)
{
    const glm::dvec2 intervals[] = {layerInterval(0.0, kSplit, overlap), layerInterval(kSplit, 1.0, overlap)};
    const auto filtered = [&](int texel, const glm::dvec2& interval)
    {
        glm::dvec2 sum(0.0);
        for (int tap = 0; tap < kTaps; ++tap)
        {
            const double depth = shadowed ? 0.2 : groundAt(texel + tap - kTaps / 2);
            sum += binomialWeight<double>(tap, kTaps) * layerMoments(depth, interval);
        }
        return sum;
    };
    Line line;
    for (int i = kSteps * kTaps; i < kSteps * (kTexels - kTaps); ++i)
    {
        const int texel = i / kSteps;
        const double fraction = static_cast<double>(i % kSteps) / kSteps;
        const double depth = groundAt(texel + fraction);
        const glm::dvec2 interval = intervals[depth >= kSplit ? 1 : 0];
        const glm::dvec2 moments = glm::mix(filtered(texel, interval), filtered(texel + 1, interval), fraction);
        line.push_back(layeredVisibility(moments, depth, interval, kMinVariance));
    }
    return line;
}

double largestJump(const Line& line)
{
    double jump = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        jump = std::max(jump, std::abs(line[i] - line[i - 1]));
    return jump;
}

void draw(Panels& panels, int panel, const Line& line, int top, int bottom)
{
    for (int x = 0; x < panels.width(); ++x)
    {
        const auto shade = static_cast<float>(0.1 + 0.85 * line[static_cast<std::size_t>(x)]);
        for (int y = top; y < bottom; ++y)
            panels.at(panel, x, y) = glm::vec3(shade);
    }
}

/// Bleeding changes from one layer to the next: what is seen half-way behind two occluders, across the split.
double jumpOfBleeding(double width)
{
    Line line;
    for (double depth = 0.46; depth < 0.54; depth += 1e-5)
    {
        const int layer = depth >= kSplit ? 1 : 0;
        const auto inLayer = [&](int which)
        {
            const glm::dvec2 interval(which == 0 ? 0.0 : kSplit, which == 0 ? kSplit : 1.0);
            const glm::dvec2 moments = 0.5 * (layerMoments(0.1, interval) + layerMoments(0.44, interval));
            return layeredVisibility(moments, depth, interval, kMinVariance);
        };
        const double weight = transitionWeight(depth, layer == 0 ? 0.0 : kSplit, layer == 0 ? kSplit : 1.0, width);
        line.push_back(blendTransition(inLayer(layer), inLayer(1 - layer), weight));
    }
    return largestJump(line);
}

} // namespace

void lvsmSeams(Report& report)
{
    constexpr double kOverlap = 0.05;
    const Line lit = walk(0.0, false), litOverlap = walk(kOverlap, false);
    const Line dark = walk(0.0, true), darkOverlap = walk(kOverlap, true);
    report.add("figure4", "lit", largestJump(lit));
    report.add("figure4", "lit_overlap", largestJump(litOverlap));
    report.add("figure4", "shadow", largestJump(dark));
    report.add("figure4", "shadow_overlap", largestJump(darkOverlap));
    report.add("figure4", "overlap", kOverlap);
    report.add("transition", "without", jumpOfBleeding(0.0));
    report.add("transition", "with_", jumpOfBleeding(0.02));

    Panels panels(static_cast<int>(lit.size()), 96, 2);
    draw(panels, 0, lit, 0, 46);
    draw(panels, 0, dark, 50, 96);
    draw(panels, 1, litOverlap, 0, 46);
    draw(panels, 1, darkOverlap, 50, 96);
    report.picture("lvsm-figure4", panels);
}

} // namespace lvsm::papers
