#include "report.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

#include <nlohmann/json.hpp>

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

    const std::filesystem::path target(path);
    const std::filesystem::path part(path + ".part");
    std::error_code error;
    if (target.has_parent_path())
        std::filesystem::create_directories(target.parent_path(), error);
    std::ofstream file(part);
    file << rows.dump(1) << '\n';
    file.close();
    if (!file)
    {
        std::filesystem::remove(part, error);
        return "cannot write '" + path + "'";
    }
    std::filesystem::rename(part, target, error);
    if (error)
        return "cannot write '" + path + "': " + error.message();
    return std::nullopt;
}

} // namespace lvsm::quality
