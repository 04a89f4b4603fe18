// ESM figures 4, 5, 6, 8 and 10 and table 3: self-shadowing, classification of failures, and the other techniques.
#include <algorithm>
#include <cmath>

#include <lvsm/esm.hpp>
#include <lvsm/pcf.hpp>

#include "esm_map.hpp"
#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

constexpr float kThreshold = 0.02f; ///< the paper's
constexpr float kPaperOffset = 0.001f;
constexpr float kVisible = 0.1f;

double shareOf(std::size_t count, const View& view)
{
    return static_cast<double>(count) / static_cast<double>(view.receivers.size());
}

bool flags(const EsmMap& map, const Receiver& r, float threshold)
{
    return violatesThreshold(map.occluder(r), r.depth(), EsmMap::kExponent, threshold);
}

bool flagsZMax(const EsmMap& map, const Receiver& r, float offset)
{
    return violatesZMax(r.depth(), map.greatest(r), offset);
}

template <typename Test>
double flagged(const View& view, const Test& test)
{
    const std::vector<Receiver>& all = view.receivers;
    return shareOf(static_cast<std::size_t>(std::count_if(all.begin(), all.end(), test)), view);
}

/// Pixels in red where a test flags them, over the shaded ones.
template <typename Test>
void show(Panels& panels, int panel, const View& view, const std::vector<float>& visibility, const Test& test)
{
    shade(panels, panel, view, visibility);
    for (int y = 0; y < view.height; ++y)
    {
        for (int x = 0; x < view.width; ++x)
        {
            const int i = view.at[static_cast<std::size_t>(y * view.width + x)];
            if (i >= 0 && test(view.receivers[static_cast<std::size_t>(i)]))
                panels.at(panel, x, y) = {0.85f, 0.1f, 0.1f};
        }
    }
}

/// Figure 4: what a lit surface loses to its own texels, without offset and with one of twice its slope and a unit.
void selfShadowing(Report& report)
{
    const Lit scene = lit("yard", yard(), 256, 1, 400);
    const EsmMap map(scene.scene, 1);
    const Image depths = depthImage(scene.scene);
    const auto pcf = [&](const Receiver& r, float factor)
    {
        const glm::vec2 slope = glm::abs(r.surface.gradient);
        const float bias = factor * std::max(slope.x, slope.y) + (factor > 0.0f ? 1.0f / 16777216.0f : 0.0f);
        const glm::ivec2 low(glm::floor(placeOf(r)));
        const auto at = [&](int x, int y)
        {
            return bilinear(depths, glm::vec2(low + glm::ivec2(x, y)));
        };
        return pcfBilinear(glm::vec4(at(0, 0), at(1, 0), at(0, 1), at(1, 1)), placeOf(r) - glm::vec2(low),
                           glm::vec4(r.depth()), bias);
    };
    std::vector<float> plain, offset, esm;
    for (const Receiver& r : scene.view.receivers)
    {
        plain.push_back(pcf(r, 0.0f));
        offset.push_back(pcf(r, 2.0f));
        esm.push_back(map.visibility(r));
    }
    report.add("esm_figure4", "pcf", errorsOf(scene.view, plain).dark);
    report.add("esm_figure4", "pcf_offset", errorsOf(scene.view, offset).dark);
    report.add("esm_figure4", "esm", errorsOf(scene.view, esm).dark);
    Panels panels = panelsOf(scene.view, 3);
    shade(panels, 0, scene.view, plain);
    shade(panels, 1, scene.view, offset);
    shade(panels, 2, scene.view, esm);
    report.picture("esm-figure4", panels);
}

/// Figure 10 and table 3: the share of pixels flagged under wider and wider filters.
void failingPixels(Report& report, float offset)
{
    for (const int width : {1, 3, 5, 7})
    {
        const Lit scene = lit("yard", yard(), 1024, width, 400);
        const EsmMap map(scene.scene, width);
        const auto threshold = [&](const Receiver& r)
        {
            return flags(map, r, kThreshold);
        };
        const auto zMax = [&](const Receiver& r)
        {
            return flagsZMax(map, r, offset);
        };
        const std::string of = std::to_string(width);
        report.add("esm_table3", "threshold" + of, flagged(scene.view, threshold));
        report.add("esm_table3", "z_max" + of, flagged(scene.view, zMax));
        if (width != 5)
            continue;
        Panels panels = panelsOf(scene.view, 2);
        std::vector<float> visibility;
        for (const Receiver& r : scene.view.receivers)
            visibility.push_back(map.visibility(r));
        show(panels, 0, scene.view, visibility, zMax);
        show(panels, 1, scene.view, visibility, threshold);
        report.picture("esm-figure10", panels);
    }
}

/// Figure 5: pixels that the filter makes too light because of a depth beyond, and how many of them each test misses.
void missed(Report& report, float offset)
{
    for (const int size : {128, 256, 512})
    {
        const Lit scene = lit("yard", yard(), size, 3, 300);
        const EsmMap map(scene.scene, 3);
        const auto fails = [&](const Receiver& r)
        {
            return map.visibility(r) - r.visibility > kVisible && map.greatest(r) > r.depth() + offset;
        };
        const std::string of = std::to_string(size);
        report.add("esm_figure5", "fails" + of, flagged(scene.view, fails));
        report.add("esm_figure5", "threshold_missed" + of,
                   flagged(scene.view, [&](const Receiver& r) { return fails(r) && !flags(map, r, kThreshold); }));
        report.add("esm_figure5", "z_max_missed" + of,
                   flagged(scene.view, [&](const Receiver& r) { return fails(r) && !flagsZMax(map, r, offset); }));
        report.add("esm_figure5", "left" + of,
                   flagged(scene.view,
                           [&](const Receiver& r) { return fails(r) && map.fallback(r) - r.visibility > kVisible; }));
    }
}

/// Figure 6: lit pixels that a small offset or threshold flags.
void falseAlarms(Report& report)
{
    constexpr float kLit = 1.0f - 1e-6f;
    const Lit scene = lit("yard", yard(), 512, 3, 400);
    const EsmMap map(scene.scene, 3);
    const auto lits = flagged(scene.view, [&](const Receiver& r) { return r.visibility >= kLit; });
    const auto add = [&](const std::string& name, auto test)
    {
        report.add("esm_figure6", name,
                   flagged(scene.view, [&](const Receiver& r) { return r.visibility >= kLit && test(r); }) / lits);
    };
    for (const auto& [name, offset] :
         {std::pair("offset1", 0.001f), {"offset4", 0.004f}, {"offset10", 0.01f}, {"offset20", 0.02f}})
        add(name, [&, at = offset](const Receiver& r) { return flagsZMax(map, r, at); });
    for (const auto& [name, threshold] :
         {std::pair("threshold20", 0.02f), {"threshold100", 0.1f}, {"threshold500", 0.5f}})
        add(name, [&, at = threshold](const Receiver& r) { return flags(map, r, at); });
    Panels panels = panelsOf(scene.view, 2);
    show(panels, 0, scene.view, truths(scene.view), [&](const Receiver& r) { return flagsZMax(map, r, kPaperOffset); });
    show(panels, 1, scene.view, truths(scene.view), [&](const Receiver& r) { return flags(map, r, kThreshold); });
    report.picture("esm-figure6", panels);
}

} // namespace

void esmClassification(Report& report)
{
    constexpr float kOffset = 0.004f;
    selfShadowing(report);
    missed(report, kOffset);
    falseAlarms(report);
    failingPixels(report, kOffset);
    report.add("esm_table3", "offset", static_cast<double>(kOffset));
}

} // namespace lvsm::papers
