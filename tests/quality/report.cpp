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
    const auto map = mapCostOf(m, costs);
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
            {"map_cost", map ? Json(map->units) : Json()},
            {"map_bytes", map ? Json(map->bytes) : Json()},
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
        if (row.at("target") != kTarget)
            continue;
        if (row.at("kind") == "estimate")
            costs.estimates[row.at("name")] = {row.at("inverse_throughput"), row.at("decisions"), row.at("map")};
        if (row.at("kind") == "map")
            costs.maps[row.at("name")] = {row.at("inverse_throughput"),
                                          row.at("read_bytes").get<double>() + row.at("written_bytes").get<double>(),
                                          row.at("bits"), row.at("slice")};
    }
    return costs;
}

std::optional<double> costOf(const Measurement& m, const Costs& costs)
{
    const std::string taps = m.taps() > 1 ? ' ' + std::to_string(m.taps()) + " taps" : "";
    const auto found = costs.estimates.find(m.estimateName() + taps);
    if (found == costs.estimates.end())
        return std::nullopt;
    return found->second.units * m.decisions() / found->second.decisions;
}

std::optional<Costs::Map> mapCostOf(const Measurement& m, const Costs& costs)
{
    const auto estimate = costs.estimates.find(m.estimateName());
    if (estimate == costs.estimates.end())
        return std::nullopt;
    if (estimate->second.map == "depths")
        return Costs::Map{0.0, 0.0, m.bits, false};
    const auto found = costs.maps.find("map " + estimate->second.map + ' ' + std::to_string(m.window.width) +
                                       (m.variant.half ? " half" : ""));
    if (found == costs.maps.end())
        return std::nullopt;
    Costs::Map map = found->second;
    const double share = static_cast<double>(m.bits) / map.bits;
    map.units *= map.slice ? share : 1.0;
    map.bytes *= share;
    return map;
}

std::optional<std::string> writeJson(const Run& run, const std::string& path)
{
    Json rows = Json::array();
    for (const Measurement& m : run.measurements)
        rows.push_back(row(m, run.seed, run.costs));

    return support::writeWholeFile(path, rows.dump(1) + '\n');
}

} // namespace lvsm::quality
