// What LVSM sections 3.3, 5 and 6 say of layers: exactness, the least bound, 16 bits, memory, transitions.
#include <algorithm>
#include <cmath>

#include <lvsm/layers.hpp>

#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

using quality::Format;

void leastBound(Report& report)
{
    // Half of the window at 0 and half at 1, two layers; the receiver is at 0.6 of the second.
    const auto bound = [](glm::dvec2 interval, double depth)
    {
        const glm::dvec2 moments = 0.5 * (layerMoments(0.0, interval) + layerMoments(1.0, interval));
        return layeredVisibility(moments, depth, interval, 0.0);
    };
    const double split = 0.5, depth = 0.8;
    report.add("section33", "own", bound({split, 1.0}, depth));
    report.add("section33", "front", bound({0.0, split}, depth));

    for (const auto& [name, setup] : {std::pair<std::string, Setup>("bench", bench()), {"blocks", blocks()}})
    {
        const Lit scene = lit(name, setup, 256, 7, 300);
        Layering layering{uniformSplits(8)};
        const auto own = visibilities(scene, layered(layering));
        layering.least = true;
        const auto least = visibilities(scene, layered(layering));
        double fewer = 0.0;
        for (std::size_t i = 0; i < own.size(); ++i)
            fewer += own[i] - least[i] > 0.01f ? 1.0 : 0.0;
        report.add("section33", name + "_share", fewer / static_cast<double>(own.size()));
        report.add("section33", name + "_own", errorsOf(scene.view, own).rmse);
        report.add("section33", name + "_least", errorsOf(scene.view, least).rmse);
    }
}

void exactness(Report& report)
{
    // All occluders in front of the layer, the receiver in it: a share of the window is lit and the rest not.
    double worst = 0.0, asVsm = 0.0;
    for (double share = 0.0; share <= 1.0; share += 0.0625)
    {
        for (double occluder = 0.0; occluder <= 0.5; occluder += 0.125)
        {
            for (double receiver = 0.5625; receiver < 1.0; receiver += 0.0625)
            {
                const glm::dvec2 interval(0.5, 1.0);
                const auto mixed = [&](auto moments)
                {
                    return glm::mix(moments(occluder), moments(receiver), share);
                };
                const glm::dvec2 layer = mixed([&](double z) { return layerMoments(z, interval); });
                const glm::dvec2 plain = mixed([](double z) { return depthMoments(z); });
                const glm::dvec2 whole = mixed([](double z) { return layerMoments(z, glm::dvec2(0.0, 1.0)); });
                worst = std::max(worst, std::abs(layeredVisibility(layer, receiver, interval, 0.0) - share));
                asVsm = std::max(asVsm, std::abs(layeredVisibility(whole, receiver, glm::dvec2(0.0, 1.0), 0.0) -
                                                 chebyshevUpperBound(plain, receiver, 0.0)));
            }
        }
    }
    report.add("exact", "worst", worst);
    report.add("oneLayer", "difference", asVsm);
}

double rmseOf(const Lit& scene, int layers, Format format, float width)
{
    const Layering layering{relaxedSplits(scene.scene, layers), format, 0.01f, width};
    return errorsOf(scene.view, visibilities(scene, layered(layering))).rmse;
}

/// Storage in 16-bit fixed point against 32-bit floats; the scene also in the last twentieth of the light's range.
void formats(Report& report, const std::string& name, const Lit& scene)
{
    for (const int count : {1, 2, 4, 8})
        report.add("bits16", name + std::to_string(count),
                   rmseOf(scene, count, Format::Unorm16, 0.0f) / rmseOf(scene, count, Format::Fp32, 0.0f));
}

/// Without transitions against with them.
void transitions(Report& report, const std::string& name, const Lit& scene)
{
    for (const int count : {2, 4, 8})
        report.add("transition", name + std::to_string(count),
                   rmseOf(scene, count, Format::Unorm16, 0.0f) / rmseOf(scene, count, Format::Unorm16, 0.01f));
}

} // namespace

void lvsmLayers(Report& report)
{
    leastBound(report);
    exactness(report);
    for (const auto& [name, setup] : {std::pair<std::string, Setup>("bench", bench()), {"blocks", blocks()}})
    {
        const Lit scene = lit(name, setup, 256, 7, 300);
        transitions(report, name, scene);
        formats(report, name, scene);
        formats(report, name + "_far", farther(scene, 0.05f));
    }
    report.add("memory", "lvsm2", layered({uniformSplits(2), Format::Unorm16}).bits);
    report.add("memory", "vsm", layered({}).bits);
}

} // namespace lvsm::papers
