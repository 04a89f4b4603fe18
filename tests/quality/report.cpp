#include "report.hpp"

#include <fstream>

#include <nlohmann/json.hpp>

#include "whole_file.hpp"

namespace lvsm::quality
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* kTarget = "GFX1100";

Json errors(const Errors& e)
{
    return {{"weight", e.weight}, {"rmse", e.rmse}, {"bleed", e.bleed}, {"dark", e.dark}};
}

Json row(const Measurement& m, unsigned seed, const Costs& costs)
{
    Json groups;
    for (std::size_t i = 0; i < kGroupNames.size(); ++i)
        groups[kGroupNames[i]] = errors(m.groups[i]);
    const auto cost = costOf(m, costs);
    return {{"technique", m.technique},
            {"peer", m.peer},
            {"bits", m.bits},
            {"scene", m.scene},
            {"seed", seed},
            {"rmse", m.all.rmse},
            {"bleed", m.all.bleed},
            {"dark", m.all.dark},
            {"p99", m.p99},
            {"mesh", m.mesh},
            {"window", m.window.tree ? "tree" : "binomial"},
            {"width", m.window.width},
            {"footprint", m.footprint.length},
            {"stretch", m.footprint.stretch},
            {"taps", m.taps()},
            {"resolution", m.variant.half ? 0.5 : 1.0},
            {"texel_bits", m.texelBits()},
            {"filtered", m.reading == Reading::Bilinear},
            {"calm", m.footprint.minified() ? Json() : Json(m.calm)},
            {"cost", cost ? Json(*cost) : Json()},
            {"estimate", m.estimateName()},
            {"decisions", m.decisions()},
            {"shift", m.setting.shift},
            {"slope_floor", m.setting.slopeFloor},
            {"stored_floor", m.setting.storedFloor},
            {"bias", m.setting.bias},
            {"bleeding", m.setting.bleeding},
            {"plain_rmse", m.plainRmse},
            {"chosen_rmse", m.chosenRmse},
            {"unweighted", errors(m.unweighted)},
            {"groups", groups}};
}

} // namespace

Costs readCosts(const std::string& path)
{
    Costs costs;
    const Json recorded = Json::parse(std::ifstream(path), nullptr, false);
    if (recorded.is_discarded())
        return costs;
    for (const Json& row : recorded.at("rows"))
    {
        if (row.at("target") == kTarget)
            costs[row.at("name")] =
                row.at("inverse_throughput").get<double>() + row.at("load_inverse_throughput").get<double>();
    }
    return costs;
}

std::optional<double> costOf(const Measurement& m, const Costs& costs)
{
    const auto found = costs.find(m.estimateName());
    if (found == costs.end())
        return std::nullopt;
    return found->second * m.decisions();
}

std::optional<std::string> writeJson(const Run& run, const std::string& path)
{
    Json rows = Json::array();
    for (const Measurement& m : run.measurements)
        rows.push_back(row(m, run.seed, run.costs));

    return support::writeWholeFile(path, rows.dump(1) + '\n');
}

} // namespace lvsm::quality
