// LVSM figures 2, 3, 5 and 6 with equations 4 and 5: light bleeding before layers and after.
#include <cmath>

#include <lvsm/layers.hpp>

#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

glm::dvec2 halfAndHalf(double a, double b)
{
    return 0.5 * (depthMoments(a) + depthMoments(b));
}

/// The paper's equation 4.
double equation4(double dx, double dy)
{
    return 0.25 * dx * dx / (0.5 * dx * dx + dx * dy + dy * dy);
}

void threeDepths(Report& report)
{
    double difference = 0.0;
    for (double dx = 0.02; dx < 0.6; dx += 0.02)
    {
        for (double dy = 0.01; dy < 0.3; dy += 0.01)
        {
            const double a = 0.05;
            const double ours = chebyshevUpperBound(halfAndHalf(a, a + dx), a + dx + dy, 0.0);
            difference = std::max(difference, std::abs(ours - equation4(dx, dy)));
        }
    }
    report.add("equation4", "difference", difference);
    const auto bleeding = [](double dy)
    {
        return chebyshevUpperBound(halfAndHalf(0.1, 0.101), 0.101 + dy, 0.0);
    };
    report.add("equation4", "power", std::log(bleeding(0.4) / bleeding(0.2)) / std::log(2.0));

    const double a = 0.1, b = 0.6, c = 0.7;
    const glm::dvec2 warped = 0.5 * (depthMoments(stepWarp(a, c)) + depthMoments(stepWarp(b, c)));
    report.add("equation5", "plain", chebyshevUpperBound(halfAndHalf(a, b), c, 0.0));
    report.add("equation5", "b", chebyshevUpperBound(warped, stepWarp(b, c), 0.0));
    report.add("equation5", "c", chebyshevUpperBound(warped, stepWarp(c, c), 0.0));

    // A split between the first two occluders, in hundredths of the way from one to the other.
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    {
        const glm::dvec2 interval(a + share * (b - a), 1.0);
        const glm::dvec2 moments = 0.5 * (layerMoments(a, interval) + layerMoments(b, interval));
        report.add("between", "at" + std::to_string(static_cast<int>(100 * share)),
                   layeredVisibility(moments, c, interval, 0.0));
    }
}

void add(Report& report, const std::string& item, const std::string& name, const ViewErrors& errors)
{
    report.add(item, name + "_rmse", errors.rmse);
    report.add(item, name + "_bleed", errors.bleed);
    report.add(item, name + "_shielded", errors.shielded);
}

/// Exact, VSM, and LVSM with one split by hand, where there is a second occluder to put it behind, or relaxed; then the
/// layers in colours.
void beforeAndAfter(Report& report, const std::string& item, const Setup& setup, int layers, bool showsManual)
{
    const auto format = quality::Format::Unorm16;
    const Lit scene = lit(item, setup, 384, 7, 400);
    Panels panels = panelsOf(scene.view, 4);
    shade(panels, 0, scene.view, truths(scene.view));
    const auto show = [&](int panel, const std::string& name, const Layering& layering)
    {
        const auto visibility = visibilities(scene, layered(layering));
        add(report, item, name, errorsOf(scene.view, visibility));
        if (panel == 0)
            return;
        shade(panels, panel, scene.view, visibility);
        shade(panels, 3, scene.view, visibility, layering.splits);
    };
    show(1, "vsm", {});
    const std::vector<float> splits = relaxedSplits(scene.scene, layers);
    show(showsManual ? 0 : 2, "relaxed", {splits, format, 0.01f, 0.01f});
    report.add(item, "last_begin", static_cast<double>(splits[splits.size() - 2]));
    report.add(item, "before_begin", static_cast<double>(splits[splits.size() - 3]));
    if (setup.shield.high.x > setup.shield.low.x)
    {
        const float split = splitBehindShield(setup);
        show(showsManual ? 2 : 0, "manual", {{0.0f, split, 1.0f}, format});
        report.add(item, "manual_split", static_cast<double>(split));
    }
    report.picture("lvsm-" + item, panels);
}

} // namespace

void lvsmBleeding(Report& report)
{
    threeDepths(report);
    beforeAndAfter(report, "figure2", planes(), 2, true);
    beforeAndAfter(report, "figure3", bench(), 4, false);
    beforeAndAfter(report, "figure6", blocks(), 4, false);
}

} // namespace lvsm::papers
