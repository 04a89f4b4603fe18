#include <sstream>

#include <nlohmann/json.hpp>

#include "page_parts.hpp"
#include "page_text.hpp"

namespace lvsm::gallery
{
namespace
{

std::string costCell(const Row& row)
{
    const std::optional<Cost> cost = costOf(row.technique->id);
    if (!cost)
        return "<td>&ndash;</td>";
    return "<td title=\"as " + escaped(cost->estimate) + "\">" + fixed(cost->units, 0) + "</td>";
}

// Text with `code` in it.
std::string withCode(const std::string& text)
{
    std::string html;
    bool inCode = false;
    for (const char c : escaped(text))
    {
        if (c != '`')
        {
            html += c;
            continue;
        }
        html += inCode ? "</code>" : "<code>";
        inCode = !inCode;
    }
    return html + (inCode ? "</code>" : "");
}

std::string cell(const std::string& heading, const std::string& html)
{
    return "<td data-heading=\"" + heading + "\">" + html + "</td>";
}

std::string claimRow(const nlohmann::json& row)
{
    const bool isJudged = row.at("agrees").is_boolean();
    const bool agrees = isJudged && row.at("agrees").get<bool>();
    const std::string verdict = agrees ? "agrees" : isJudged ? "does not agree" : "not reproduced";
    const std::string kind = agrees ? "agrees" : "differs";
    const std::string why = withCode(row.at("why"));
    return "<tr class=\"" + kind + "\"><th scope=\"row\">" + escaped(row.at("item")) + "</th>" +
           cell("claim", withCode(row.at("claim"))) + cell("theirs", withCode(row.at("theirs"))) +
           cell("ours", withCode(row.at("ours"))) + "<td class=\"verdict\">" + verdict + "</td></tr>\n" +
           (why.empty() ? "" : "<tr class=\"reason " + kind + "\"><td></td><td colspan=\"4\">" + why + "</td></tr>\n");
}

} // namespace

std::string figureTable(const Section& section)
{
    const bool shielded = section.scene->shield.has_value();
    const std::string share = "<br><small>% of full light</small></th>";
    std::ostringstream html;
    html
        << "<details><summary>All figures of " << section.rows.size() << " techniques</summary>\n"
        << "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"Table of figures\"><table class=\"figures\">"
        << "<thead><tr><th>technique</th><th>storage</th><th>bits<br><small>a texel</small></th>"
        << "<th>cost<br><small>units a pixel</small></th><th>RMSE" << share << "<th>mean bleeding" << share
        << "<th>mean darkening" << share << "<th>RMSE, every surface" << share << "<th>RMSE, hidden surfaces" << share;
    if (shielded)
    {
        html << "<th>light behind " << escaped(section.scene->shield->name)
             << "<br><small>% of full light, right: 0</small></th>";
    }
    html << "</tr></thead><tbody>\n";
    for (const Row& row : section.rows)
    {
        html << "<tr" << marked(section, row) << "><th scope=\"row\">" << row.technique->title << "</th><td>"
             << row.technique->storage << "</td><td>" << row.technique->bits << "</td>" << costCell(row) << "<td>"
             << percent(row.figures.rmse) << "</td><td>" << percent(row.figures.bleed) << "</td><td>"
             << percent(row.figures.dark) << "</td><td>" << percent(row.everywhere.rmse) << "</td><td>"
             << percent(row.hidden.rmse) << "</td>";
        if (shielded)
            html << "<td>" << (row.figures.behindShield ? percent(*row.figures.behindShield) : "&ndash;") << "</td>";
        html << "</tr>\n";
    }
    html << "</tbody></table></div>\n<p>Every surface: " << section.peels.receivers
         << " receivers, wherever a grid of the light's rays meets a surface that faces it, up to "
         << section.peels.peels << " behind one another. " << section.peels.hidden
         << " of them are hidden from the light by another, and most of those from the camera too.</p></details>\n";
    return html.str();
}

std::string paperTables()
{
    const auto rows = nlohmann::json::parse(readText(LVSM_GALLERY_PAPERS));
    std::size_t agreeing = 0;
    std::string tables, paper;
    for (const auto& row : rows)
    {
        agreeing += row.at("agrees") == true ? 1 : 0;
        if (row.at("paper") != paper)
        {
            tables += paper.empty() ? "" : "</tbody></table>\n";
            paper = row.at("paper");
            tables +=
                "<h3>" + escaped(paper) +
                "</h3>\n<table class=\"claims\"><thead><tr><th>item</th><th>claim</th><th>theirs</th><th>ours</th>"
                "<th>agrees?</th></tr></thead><tbody>\n";
        }
        tables += claimRow(row);
    }
    return "<section id=\"papers\"><h2>The papers, as numbers</h2>\n<p>Claims and figures of the papers beside what "
           "the "
           "library makes of them. " +
           std::to_string(agreeing) + " of " + std::to_string(rows.size()) +
           " agree. docs/papers.md has the criteria, the pictures and how it is measured.</p>\n"
           "<p><label><input type=\"checkbox\" id=\"only-differing\" autocomplete=\"off\"> only those that do not "
           "agree</label></p>\n" +
           tables + (paper.empty() ? "" : "</tbody></table>\n") + "</section>\n";
}

} // namespace lvsm::gallery
