#include <algorithm>

#include <nlohmann/json.hpp>

#include "page_parts.hpp"
#include "page_text.hpp"
#include "pictures.hpp"

namespace lvsm::gallery
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* kExact = "exact";

const Row& rowOr(const Section& section, const std::string& technique, std::size_t otherwise)
{
    const auto row = std::find_if(section.rows.begin(), section.rows.end(),
                                  [&](const Row& each) { return each.technique->id == technique; });
    return row != section.rows.end() ? *row : section.rows[std::min(otherwise, section.rows.size() - 1)];
}

std::string figuresOf(const Row& row)
{
    return "RMSE " + percent(row.figures.rmse) + "%, too light by " + percent(row.figures.bleed) + "%, too dark by " +
           percent(row.figures.dark) + "% of full light; " + std::to_string(row.technique->bits) + " bits a texel.";
}

// Colours of the layers and the metres from the light that they reach over.
Json layersOf(const Row& row, const Light& light)
{
    const auto metres = [&](float split)
    {
        return fixed(static_cast<double>(light.block.range.x + split * light.metresPerDepth()), 2);
    };
    Json layers = Json::array();
    for (std::size_t i = 0; i + 1 < row.splits.size(); ++i)
        layers.push_back({cssColour(layerColours()[i]), metres(row.splits[i]) + "–" + metres(row.splits[i + 1])});
    return layers;
}

// What page.js knows of the section.
std::string data(const Section& section)
{
    Json all;
    all[kExact] = {{"about", "Every texel under the filter compared with the receiver's own plane: what the others "
                             "estimate. It has no error and no layers."},
                   {"shaded", section.exact}};
    for (const Row& row : section.rows)
    {
        Json& entry = all[row.technique->id];
        entry = {{"about", row.technique->explanation + " " + figuresOf(row)},
                 {"shaded", row.shaded},
                 {"errors", row.errors}};
        if (!row.layers.empty())
        {
            entry["layers"] = row.layers;
            entry["splits"] = layersOf(row, section.light);
        }
    }
    std::string text = all.dump();
    for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
        text.insert(at + 1, "\\");
    return "<script type=\"application/json\">" + text + "</script>\n";
}

std::string choice(const Section& section, const std::string& side, const Row& chosen)
{
    std::string html = "<label class=\"key-" + side + "\">" + (side == "a" ? "A, left" : "B, right") +
                       " <select name=\"" + side + "\" autocomplete=\"off\">";
    const auto option = [&](const std::string& id, const std::string& title)
    {
        html += "<option value=\"" + id + "\"" + (id == chosen.technique->id ? " selected" : "") + ">" + title +
                "</option>";
    };
    for (const Row& row : section.rows)
        option(row.technique->id, row.technique->title);
    option(kExact, "Exact");
    return html + "</select></label>\n";
}

std::string views(const Section& section)
{
    const bool hasLayers =
        std::any_of(section.rows.begin(), section.rows.end(), [](const Row& row) { return !row.layers.empty(); });
    std::string html = "<fieldset><legend>Show</legend>";
    const auto view = [&](const std::string& name, const std::string& words)
    {
        html += "<label><input type=\"radio\" autocomplete=\"off\" name=\"" + idOf(section) + "-view\" value=\"" +
                name + "\"" + (name == "shaded" ? " checked" : "") + "> " + words + "</label> ";
    };
    view("shaded", "picture");
    view("errors", "error map");
    if (hasLayers)
        view("layers", "layers");
    return html + "</fieldset>\n";
}

std::string picture(const Row& row, const std::string& side)
{
    return "<img class=\"" + side + "\" src=\"" + row.shaded + "\" alt=\"" + row.technique->title +
           ", picture\" loading=\"lazy\" draggable=\"false\">";
}

std::string tag(const Row& row, const std::string& side)
{
    return "<span class=\"tag " + side + "\">" + row.technique->title + "</span>";
}

std::string about(const Row& row, const std::string& side)
{
    return "<p class=\"about " + side + "\"><strong>" + row.technique->title + ".</strong> <span>" +
           escaped(row.technique->explanation + " " + figuresOf(row)) + "</span> <span class=\"layers\"></span></p>\n";
}

std::string errorLegend()
{
    std::string stops, ticks;
    for (const glm::vec3 colour : errorColours())
        stops += ", " + cssColour(colour);
    for (const int part : {-2, -1, 0, 1, 2})
    {
        const double value = 50.0 * static_cast<double>(kErrorRange) * part;
        ticks += "<span>" +
                 std::string(part < 0   ? "&minus;"
                             : part > 0 ? "+"
                                        : "") +
                 fixed(std::abs(value), 0) + "%</span>";
    }
    return "<div class=\"legend\"><span>error map, of full light:</span><span class=\"ramp\" "
           "style=\"background:linear-gradient(90deg" +
           stops + ")\"></span><span class=\"ticks\">" + ticks +
           "</span><span class=\"ticks\"><span>too dark</span><span>too light</span></span></div>\n";
}

} // namespace

std::string idOf(const Section& section)
{
    return section.scene->id + "-" + section.light.id;
}

const Row& firstOf(const Section& section)
{
    return rowOr(section, "vsm", 0);
}

const Row& secondOf(const Section& section)
{
    return rowOr(section, "lvsm4", 1);
}

std::string marked(const Section& section, const Row& row, const std::string& classes)
{
    std::string all = classes;
    all += &row == &firstOf(section) ? " a" : "";
    all += &row == &secondOf(section) ? " b" : "";
    return " data-technique=\"" + row.technique->id + "\" class=\"" + all + "\"";
}

std::string comparison(const Section& section)
{
    const Row& first = firstOf(section);
    const Row& second = secondOf(section);
    return "<div class=\"compare\"><div class=\"stage\">" + picture(second, "b") + picture(first, "a") +
           "<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" autocomplete=\"off\" aria-label=\"Divider between "
           "A "
           "and B, percent from the left\"><span class=\"divider\"></span>" +
           tag(first, "a") + tag(second, "b") + "</div>\n<div class=\"side\"><div class=\"choice\">" +
           choice(section, "a", first) + choice(section, "b", second) + views(section) + "</div>\n" +
           about(first, "a") + about(second, "b") + errorLegend() + "</div></div>\n" + data(section);
}

} // namespace lvsm::gallery
