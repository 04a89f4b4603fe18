#include <map>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "page_parts.hpp"
#include "page_text.hpp"

namespace lvsm::gallery
{
namespace
{

constexpr const char* kTarget = "GFX1100";

// Estimates of tests/cost by technique; one that nothing there comes near has no cost.
const std::map<std::string, std::string>& estimates()
{
    static const std::map<std::string, std::string> names{
        {"basic", "one comparison"},
        {"pcf2", "PCF 2x2"},
        {"pcf3", "PCF 3x3"},
        {"vsm", "VSM"},
        {"vsm-reduced", "VSM less bleeding"},
        {"lvsm2", "LVSM one placed layer"},
        {"lvsm4-uniform", "LVSM one placed layer"},
        {"lvsm4-manual", "LVSM one placed layer"},
        {"lvsm4", "LVSM one placed layer"},
        {"lvsm4-view", "LVSM one placed layer"},
        {"lvsm4-optimal", "LVSM one placed layer"},
        {"lvsm4-apart", "LVSM one placed layer"},
        {"lvsm8", "LVSM one placed layer"},
        {"lvsm4-bracketed", "LVSM-N bracketed and placed"},
        {"lvsm4-plane", "LVSM-N plane 8-bit"},
        {"evsm2", "EVSM2"},
        {"evsm4", "EVSM4"},
        {"esm", "ESM with fallback"},
        {"csm", "CSM 16 terms"},
        {"msm4", "MSM4 16-bit"},
        {"msm4-layers", "MSM4 x N 16-bit"},
        {"trigonometric", "trigonometric 16-bit"},
        {"mixture2", "mixture 64-bit moved"},
        {"mixture4", "mixture 128-bit moved"},
    };
    return names;
}

std::map<std::string, double> recordedUnits()
{
    std::map<std::string, double> units;
    const auto recorded = nlohmann::json::parse(readText(LVSM_GALLERY_COSTS));
    for (const auto& row : recorded.at("rows"))
    {
        if (row.at("target") == kTarget && row.at("kind") == "estimate")
            units[row.at("name")] = row.at("inverse_throughput").get<double>();
    }
    return units;
}

} // namespace

std::optional<Cost> costOf(const std::string& technique)
{
    static const std::map<std::string, double> units = recordedUnits();
    const auto estimate = estimates().find(technique);
    if (estimate == estimates().end())
        return std::nullopt;
    const auto cost = units.find(estimate->second);
    if (cost == units.end())
        throw std::runtime_error(LVSM_GALLERY_COSTS " has no " + estimate->second);
    return Cost{estimate->second, cost->second};
}

} // namespace lvsm::gallery
