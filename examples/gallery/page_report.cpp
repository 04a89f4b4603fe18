#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "page.hpp"

namespace lvsm::gallery
{
namespace
{

// VSM must bleed at least so much for the scene to show anything, and the others at most so much of that.
constexpr double kVisibleBleed = 0.03;
constexpr double kLeftOver = 0.1;

// Null where the technique was not asked for.
const Row* find(const Section& section, const std::string& technique)
{
    const auto row = std::find_if(section.rows.begin(), section.rows.end(),
                                  [&](const Row& each) { return each.technique->id == technique; });
    return row == section.rows.end() ? nullptr : &*row;
}

std::string percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2f%%", 100.0 * share);
    return text;
}

Verdict compare(const Section& section, const std::string& technique)
{
    const std::optional<double> bleeding = find(section, "vsm")->figures.behindShield;
    const Row& row = *find(section, technique);
    const std::string where = "Behind the bench, " + section.light.title + ": ";
    if (!bleeding)
        return {false, where + "the camera sees no ground in the bench's full shadow."};
    const double left = row.figures.behindShield.value_or(1.0);
    const bool holds = *bleeding >= kVisibleBleed && left <= kLeftOver * *bleeding;
    return {holds, where + row.technique->title + " lets through " + percent(left) + " of the light, VSM " +
                       percent(*bleeding) + (holds ? "." : ": not the difference that this scene is made to show.")};
}

} // namespace

std::string reportText(const std::vector<Section>& sections)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Section& section : sections)
    {
        for (const Row& row : section.rows)
        {
            nlohmann::ordered_json entry = {{"scene", section.scene->id},     {"light", section.light.id},
                                            {"technique", row.technique->id}, {"bits", row.technique->bits},
                                            {"rmse", row.figures.rmse},       {"bleed", row.figures.bleed},
                                            {"dark", row.figures.dark}};
            if (row.figures.behindShield)
                entry["shield_bleed"] = *row.figures.behindShield;
            if (!row.splits.empty())
                entry["splits"] = row.splits;
            rows.push_back(std::move(entry));
        }
    }
    return rows.dump(2) + "\n";
}

std::vector<Verdict> judge(const std::vector<Section>& sections)
{
    std::vector<Verdict> verdicts;
    for (const Section& section : sections)
    {
        if (section.scene->id != "bench")
            continue;
        for (const char* technique : {"lvsm4", "evsm4"})
        {
            if (find(section, "vsm") != nullptr && find(section, technique) != nullptr)
                verdicts.push_back(compare(section, technique));
        }
    }
    return verdicts;
}

} // namespace lvsm::gallery
