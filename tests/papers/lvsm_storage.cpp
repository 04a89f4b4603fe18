// LVSM figures 8 and 10: convolution, layered and exponential shadow maps at equal storage, on the scene of figure 6.
#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

class Comparison
{
public:
    Comparison(Report& report, const Lit& scene) : m_report(report), m_scene(scene) {}

    std::vector<float> add(const std::string& name, const quality::Technique& technique)
    {
        const auto visibility = visibilities(m_scene, technique);
        const ViewErrors errors = errorsOf(m_scene.view, visibility);
        m_report.add("figure8", name, errors.rmse);
        m_report.add("figure8", name + "_bits", technique.bits);
        m_report.add("figure8", name + "_bleed", errors.bleed);
        m_report.add("figure8", name + "_contact", errors.contact);
        return visibility;
    }

private:
    Report& m_report;
    const Lit& m_scene;
};

} // namespace

void lvsmStorage(Report& report)
{
    const auto format = quality::Format::Unorm16;
    const Lit scene = lit("blocks", blocks(), 384, 7, 400);
    Comparison comparison(report, scene);
    Panels columns[] = {panelsOf(scene.view, 3), panelsOf(scene.view, 3), panelsOf(scene.view, 3)};
    int column = 0;
    for (const int layers : {2, 4, 8, 16})
    {
        const auto csm = comparison.add("csm" + std::to_string(2 * layers), quality::csm(2 * layers, 1.0f, true));
        const auto uniform =
            comparison.add("uniform" + std::to_string(layers), layered({uniformSplits(layers), format, 0.01f, 0.01f}));
        const std::vector<float> splits = relaxedSplits(scene.scene, layers);
        const std::string name = "relaxed" + std::to_string(layers);
        const auto relaxed = comparison.add(name, layered({splits, format, 0.01f, 0.01f}));
        report.add("figure8", name + "_last", static_cast<double>(splits[splits.size() - 2]));
        if (layers > 8)
            continue;
        shade(columns[0], column, scene.view, csm);
        shade(columns[1], column, scene.view, uniform);
        shade(columns[2], column++, scene.view, relaxed);
    }
    report.picture("lvsm-figure8-csm", columns[0]);
    report.picture("lvsm-figure8-uniform", columns[1]);
    report.picture("lvsm-figure8-relaxed", columns[2]);

    Panels panels = panelsOf(scene.view, 2);
    shade(panels, 0, scene.view, comparison.add("evsm4", techniqueNamed("EVSM4 rgba32f 42/42")));
    shade(panels, 1, scene.view, truths(scene.view));
    report.picture("lvsm-figure10", panels);
}

} // namespace lvsm::papers
