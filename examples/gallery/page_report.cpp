#include <nlohmann/json.hpp>

#include "page.hpp"

namespace lvsm::gallery
{

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
            entry["every_surface"] = {{"peels", section.peels.peels},   {"receivers", section.peels.receivers},
                                      {"hidden", section.peels.hidden}, {"rmse", row.everywhere.rmse},
                                      {"bleed", row.everywhere.bleed},  {"dark", row.everywhere.dark},
                                      {"hidden_rmse", row.hidden.rmse}, {"hidden_bleed", row.hidden.bleed}};
            if (row.figures.behindShield)
                entry["shield_bleed"] = *row.figures.behindShield;
            if (!row.splits.empty())
                entry["splits"] = row.splits;
            rows.push_back(std::move(entry));
        }
    }
    return rows.dump(2) + "\n";
}

} // namespace lvsm::gallery
