// What the figures say, compared with what is promised.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "page.hpp"
#include "page_text.hpp"

namespace lvsm::gallery
{
namespace
{

// VSM must bleed at least so much for the scene to show anything, and the others at most so much of that.
constexpr double kVisibleBleed = 0.03;
constexpr double kLeftOver = 0.1;
constexpr double kThird = 1.0 / 3.0;
// How far the device's splits may lie from the host's.
constexpr double kSplitTolerance = 1.0 / 4096.0;

std::string scientific(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", value);
    return text;
}

// Null where the technique was not asked for.
const Row* find(const Section& section, const std::string& technique)
{
    const auto row = std::find_if(section.rows.begin(), section.rows.end(),
                                  [&](const Row& each) { return each.technique->id == technique; });
    return row == section.rows.end() ? nullptr : &*row;
}

std::string nameOf(const Section& section)
{
    return section.scene->title + ", " + section.light.title + ": ";
}

Verdict judgeBleeding(const Section& section, const Row& vsm, const Row& row)
{
    const std::optional<double> bleeding = vsm.figures.behindShield;
    const std::string where = "Behind the bench, " + section.light.title + ": ";
    if (!bleeding)
        return {false, where + "the camera sees no ground in the bench's full shadow."};
    const double left = row.figures.behindShield.value_or(1.0);
    const bool holds = *bleeding >= kVisibleBleed && left <= kLeftOver * *bleeding;
    return {holds, where + row.technique->title + " lets through " + percent(left) + "% of the light, VSM " +
                       percent(*bleeding) + "%" +
                       (holds ? "." : ": not the difference that this scene is made to show.")};
}

// How many surfaces lie in the layer before a receiver's, and how a layer is read, decides; so it is a finding.
Verdict judgeLayers(const Section& section, const Row& vsm, const Row& layers)
{
    const double share = layers.figures.rmse / vsm.figures.rmse;
    const bool holds = share <= kThird;
    std::string sentence = nameOf(section) + "LVSM-4 with relaxed splits has " + fixed(share, 2) + " of VSM's error, " +
                           (holds ? "at most a third." : "more than a third");
    if (!holds)
    {
        sentence += ": a receiver's own layer still holds two occluders of different depth";
        if (const Row* bracketed = find(section, "lvsm4-bracketed"))
            sentence += "; the same layers, bracketed, have " + fixed(bracketed->figures.rmse / vsm.figures.rmse, 2);
        sentence += ".";
    }
    return {holds, sentence, false};
}

bool isLayered(const Row& row)
{
    return row.technique->id.rfind("lvsm", 0) == 0;
}

// Which map is the best where it is not a layered one.
Verdict nameBest(const Section& section)
{
    const Row* best = nullptr;
    const Row* everywhere = nullptr;
    const Row* layered = nullptr;
    for (const Row& row : section.rows)
    {
        // Percentage-closer filtering compares as the truth does.
        if (row.technique->making == Making::Stored)
            continue;
        if (isLayered(row) && (layered == nullptr || row.figures.rmse < layered->figures.rmse))
            layered = &row;
        if (best == nullptr || row.figures.rmse < best->figures.rmse)
            best = &row;
        if (everywhere == nullptr || row.everywhere.rmse < everywhere->everywhere.rmse)
            everywhere = &row;
    }
    if (best == nullptr || layered == nullptr)
        return {true, "", false};
    std::string sentence = nameOf(section) + best->technique->title + " errs least, by " + percent(best->figures.rmse) +
                           "% of full light in " + std::to_string(best->technique->bits) + " bits a texel";
    if (best != layered)
        sentence += "; of layered maps " + layered->technique->title + " does, by " + percent(layered->figures.rmse) +
                    "% in " + std::to_string(layered->technique->bits);
    sentence += ". Over every surface along the light's rays, up to " + std::to_string(section.peels.peels) +
                " of them one behind the other, " + everywhere->technique->title + " does, by " +
                percent(everywhere->everywhere.rmse) + "%";
    if (const Row* vsm = find(section, "vsm"))
        sentence += "; VSM by " + percent(vsm->everywhere.rmse) + "%, of what the camera sees " +
                    percent(vsm->figures.rmse) + "%";
    return {true, sentence + ".", false};
}

Verdict judgeFrames(const Section& section)
{
    double difference = 0.0;
    int ties = 0;
    for (const Frame& frame : section.frames)
    {
        difference = std::max(difference, static_cast<double>(frame.relaxedDifference));
        const double optimal = static_cast<double>(frame.optimalDifference);
        // Optimal splits may tie, and then be far apart.
        if (optimal > kSplitTolerance && frame.optimalIsAsGood)
            ++ties;
        else
            difference = std::max(difference, optimal);
    }
    return {difference <= kSplitTolerance,
            nameOf(section) + "while the light moves, over " + std::to_string(section.frames.size()) +
                " frames, the device's splits stay within " + scientific(difference) + " of the host's" +
                (ties > 0 ? ", or are as good in " + std::to_string(ties) : "") + "; 1/4096 is " +
                scientific(kSplitTolerance) + "."};
}

// What the paper leaves to future work: the relaxation in view space, against the one in light space.
std::optional<Verdict> judgeView(const std::vector<Section>& sections)
{
    double logarithms = 0.0;
    int better = 0, count = 0;
    for (const Section& section : sections)
    {
        const Row* light = find(section, "lvsm4");
        const Row* view = find(section, "lvsm4-view");
        if (light == nullptr || view == nullptr)
            continue;
        const double share = view->figures.rmse / light->figures.rmse;
        logarithms += std::log(share);
        better += share < 1.0 ? 1 : 0;
        ++count;
    }
    if (count == 0)
        return std::nullopt;
    const double mean = std::exp(logarithms / count);
    return Verdict{mean < 1.0,
                   "Four layers relaxed in view space, by what is on the screen, have " + fixed(mean, 2) +
                       " of the error of those relaxed in light space, in the geometric mean of " +
                       std::to_string(count) + " scenes and lights; in " + std::to_string(better) + " they err less.",
                   false};
}

} // namespace

std::vector<Verdict> judge(const std::vector<Section>& sections)
{
    std::vector<Verdict> verdicts;
    for (const Section& section : sections)
    {
        const Row* vsm = find(section, "vsm");
        const std::string& scene = section.scene->id;
        for (const char* technique : {"lvsm4", "evsm4"})
        {
            const Row* row = find(section, technique);
            if (scene == "bench" && vsm != nullptr && row != nullptr)
                verdicts.push_back(judgeBleeding(section, *vsm, *row));
        }
        const Row* layers = find(section, "lvsm4");
        if ((scene == "bench" || scene == "blocks") && vsm != nullptr && layers != nullptr)
            verdicts.push_back(judgeLayers(section, *vsm, *layers));
        if (const Verdict best = nameBest(section); !best.sentence.empty())
            verdicts.push_back(best);
        if (!section.frames.empty())
            verdicts.push_back(judgeFrames(section));
    }
    if (const std::optional<Verdict> view = judgeView(sections))
        verdicts.push_back(*view);
    return verdicts;
}

} // namespace lvsm::gallery
