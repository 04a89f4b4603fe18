#include "report.hpp"

#include <nlohmann/json.hpp>

#include "whole_file.hpp"

namespace lvsm::quality
{
namespace
{

using Json = nlohmann::ordered_json;

Json errors(const Errors& e)
{
    return {{"weight", e.weight}, {"rmse", e.rmse}, {"bleed", e.bleed}, {"dark", e.dark}};
}

Json row(const Measurement& m, unsigned seed)
{
    Json groups;
    for (std::size_t i = 0; i < kGroupNames.size(); ++i)
        groups[kGroupNames[i]] = errors(m.groups[i]);
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
            {"taps", m.taps},
            {"shift", m.setting.shift},
            {"slope_floor", m.setting.slopeFloor},
            {"stored_floor", m.setting.storedFloor},
            {"plain_rmse", m.plainRmse},
            {"unweighted", errors(m.unweighted)},
            {"groups", groups}};
}

} // namespace

std::optional<std::string> writeJson(const Run& run, const std::string& path)
{
    Json rows = Json::array();
    for (const Measurement& m : run.measurements)
        rows.push_back(row(m, run.seed));

    return support::writeWholeFile(path, rows.dump(1) + '\n');
}

} // namespace lvsm::quality
