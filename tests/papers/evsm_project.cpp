// The project on EVSM: light bleeding reduction, the ground's edges under a wide blur, and the taps of its blurs.
#include <algorithm>
#include <cmath>

#include <lvsm/moments.hpp>
#include <lvsm/passes.hpp>

#include "esm_map.hpp"
#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

/// A technique whose map holds 0 where there is nothing, as one cleared to black does.
class ClearedToBlack : public quality::Estimator
{
public:
    ClearedToBlack(std::unique_ptr<Estimator> estimator, int channels)
        : m_estimator(std::move(estimator)), m_channels(channels)
    {
    }
    void store(const quality::Surface& nearest, float* texel) const override
    {
        if (nearest.depth < 1.0f)
            m_estimator->store(nearest, texel);
        else
            std::fill_n(texel, m_channels, 0.0f);
    }
    float visibility(const quality::Query& query) const override { return m_estimator->visibility(query); }

private:
    std::unique_ptr<Estimator> m_estimator;
    int m_channels;
};

quality::Technique cleared(const quality::Technique& technique)
{
    quality::Technique black = technique;
    black.prepare = [technique](const quality::Map& map)
    {
        return std::make_unique<ClearedToBlack>(technique.prepare(map), technique.channels);
    };
    return black;
}

void add(Report& report, const std::string& name, const ViewErrors& errors)
{
    report.add("evsm_quality", name, errors.rmse);
    report.add("evsm_quality", name + "_bleed", errors.bleed);
    report.add("evsm_quality", name + "_penumbra", errors.penumbra);
}

/// RMSE of what has nothing at all in a part of its window: the edges of the ground.
double atEdges(const Lit& scene, const EsmMap& depths, const std::vector<float>& visibility)
{
    double squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < visibility.size(); ++i)
    {
        const Receiver& r = scene.view.receivers[i];
        if (depths.greatest(r) < 1.0f)
            continue;
        const auto error = static_cast<double>(visibility[i] - r.visibility);
        squares += error * error;
        ++count;
    }
    return std::sqrt(squares / count);
}

} // namespace

void evsmProject(Report& report)
{
    constexpr int kWidth = 9;
    const Lit scene = lit("yard", yard(), 512, kWidth, 400);
    const auto vsm = visibilities(scene, layered({}));
    const auto evsm = visibilities(scene, techniqueNamed("EVSM4 rgba32f 42/42"));
    const auto lvsm = visibilities(scene, layered({relaxedSplits(scene.scene, 2), quality::Format::Unorm16}));
    Panels panels = panelsOf(scene.view, 4);
    int panel = 0;
    for (const auto& [name, amount] : {std::pair("vsm", 0.0f), {"vsm3", 0.3f}, {"vsm6", 0.6f}})
    {
        std::vector<float> reduced;
        for (const float visibility : vsm)
            reduced.push_back(reduceLightBleeding(visibility, amount));
        add(report, name, errorsOf(scene.view, reduced));
        shade(panels, panel++, scene.view, reduced);
    }
    add(report, "evsm", errorsOf(scene.view, evsm));
    add(report, "lvsm2", errorsOf(scene.view, lvsm));
    shade(panels, panel, scene.view, evsm);
    report.picture("evsm-reduction", panels);

    const EsmMap depths(scene.scene, kWidth);
    report.add("evsm_edges", "vsm", atEdges(scene, depths, vsm));
    report.add("evsm_edges", "evsm", atEdges(scene, depths, evsm));
    report.add("evsm_edges", "vsm_black", atEdges(scene, depths, visibilities(scene, cleared(layered({})))));
    report.add("evsm_edges", "evsm_black",
               atEdges(scene, depths, visibilities(scene, cleared(techniqueNamed("EVSM4 rgba32f 42/42")))));
    for (const auto& [name, bits] : {std::pair("evsm", techniqueNamed("EVSM4 rgba32f 42/42").bits),
                                     {"lvsm2", techniqueNamed("LVSM-2 unorm16 paper, uniform").bits},
                                     {"lvsm4", techniqueNamed("LVSM-4 unorm16 paper, uniform").bits},
                                     {"lvsm8", techniqueNamed("LVSM-8 unorm16 paper, uniform").bits}})
        report.add("evsm_memory", name, bits);
    report.add("evsm_taps", "nine_linear", gaussianKernel(9, 2.0f, true).fetchCount);
    report.add("evsm_taps", "nine", gaussianKernel(9, 2.0f, false).fetchCount);
    report.add("evsm_taps", "five", gaussianKernel(5, 2.0f, false).fetchCount);
}

} // namespace lvsm::papers
