#include "page.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>

#include "pictures.hpp"

namespace lvsm::gallery
{
namespace
{

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        switch (c)
        {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

std::string fixed(double value, int decimals)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string percent(double share)
{
    return fixed(100.0 * share, 2);
}

std::string cssColour(glm::vec3 colour)
{
    char text[32];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(colour.r * 255.0f + 0.5f),
                  static_cast<unsigned>(colour.g * 255.0f + 0.5f), static_cast<unsigned>(colour.b * 255.0f + 0.5f));
    return text;
}

std::string styleSheet()
{
    std::ifstream file(LVSM_GALLERY_STYLE);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string figure(const std::string& file, const std::string& title, const std::string& sentence)
{
    return "<figure><a href=\"" + file + "\"><img loading=\"lazy\" src=\"" + file + "\" alt=\"" + escaped(title) +
           "\"></a><figcaption><strong>" + escaped(title) + ".</strong> " + sentence + "</figcaption></figure>\n";
}

std::string errorLegend()
{
    std::string stops;
    for (const glm::vec3 colour : errorColours())
        stops += ", " + cssColour(colour);
    const std::string range = fixed(100.0 * static_cast<double>(kErrorRange), 0);
    return "<div class=\"legend\"><span>darker than the truth</span><span class=\"scale\"><span class=\"ramp\" "
           "style=\"background:linear-gradient(90deg" +
           stops + ")\"></span><span class=\"ticks\"><span>&minus;" + range + "%</span><span>0</span><span>+" + range +
           "%</span></span></span><span>lighter: light bleeding</span></div>\n";
}

std::string layerLegend(const Row& row, const Light& light)
{
    std::string items;
    for (std::size_t i = 0; i + 1 < row.splits.size(); ++i)
    {
        const auto metres = [&](float split)
        {
            return fixed(static_cast<double>(light.block.range.x + split * light.metresPerDepth()), 2);
        };
        items += "<span class=\"key\"><i style=\"background:" + cssColour(layerColours()[i]) + "\"></i>" +
                 metres(row.splits[i]) + "&ndash;" + metres(row.splits[i + 1]) + "&thinsp;m</span> ";
    }
    return items;
}

std::string table(const Section& section)
{
    const bool shielded = section.scene->shield.has_value();
    std::ostringstream html;
    html << "<div class=\"wide\"><table><thead><tr><th>technique</th><th>storage</th><th>bits per texel</th>"
            "<th>RMSE<br><small>% of full light</small></th><th>mean bleeding<br><small>% of full light</small></th>"
            "<th>mean darkening<br><small>% of full light</small></th>";
    if (shielded)
    {
        html << "<th>light behind " << escaped(section.scene->shield->name)
             << "<br><small>% of full light, right: 0</small></th>";
    }
    html << "</tr></thead><tbody>\n";
    for (const Row& row : section.rows)
    {
        html << "<tr><th scope=\"row\">" << row.technique->title << "</th><td>" << row.technique->storage << "</td><td>"
             << row.technique->bits << "</td><td>" << percent(row.figures.rmse) << "</td><td>"
             << percent(row.figures.bleed) << "</td><td>" << percent(row.figures.dark) << "</td>";
        if (shielded)
        {
            html << "<td>" << (row.figures.behindShield ? percent(*row.figures.behindShield) : "&ndash;") << "</td>";
        }
        html << "</tr>\n";
    }
    html << "</tbody></table></div>\n";
    return html.str();
}

std::string figuresOf(const Row& row)
{
    return "RMSE " + percent(row.figures.rmse) + "%, bleeding " + percent(row.figures.bleed) + "%, darkening " +
           percent(row.figures.dark) + "% of full light.";
}

std::string sectionText(const Section& section)
{
    std::ostringstream html;
    const std::string id = section.scene->id + "-" + section.light.id;
    html << "<section id=\"" << id << "\"><h2>" << escaped(section.scene->title) << " <small>" << section.light.title
         << "</small></h2>\n<p>" << escaped(section.scene->description) << "</p>\n"
         << table(section) << "<div class=\"pictures\">\n"
         << figure(section.exact, "Exact",
                   "Every texel under the filter compared with the receiver's own plane: what the others estimate.");
    for (const Row& row : section.rows)
    {
        html << figure(row.shaded, row.technique->title, escaped(row.technique->explanation) + " " + figuresOf(row));
    }
    html << "</div>\n<h3>Difference from the exact picture</h3>\n" << errorLegend() << "<div class=\"pictures\">\n";
    for (const Row& row : section.rows)
    {
        html << figure(row.errors, row.technique->title,
                       "Visibility less the exact one, " + percent(row.figures.bleed) + "% too light and " +
                           percent(row.figures.dark) + "% too dark on average.");
    }
    html << "</div>\n<h3>Layers</h3>\n<div class=\"pictures\">\n";
    for (const Row& row : section.rows)
    {
        if (row.layers.empty())
            continue;
        html << figure(row.layers, row.technique->title + ", layers in colour",
                       "The layer that each surface reads, by distance from the light as Lloyd relaxation cut it: " +
                           layerLegend(row, section.light));
    }
    html << "</div>\n</section>\n";
    return html.str();
}

std::string contents(const std::vector<Section>& sections)
{
    std::string html = "<nav><ul>";
    for (const Section& section : sections)
    {
        html += "<li><a href=\"#" + section.scene->id + "-" + section.light.id + "\">" + escaped(section.scene->title) +
                ", " + section.light.title + "</a></li>";
    }
    return html + "</ul></nav>\n";
}

std::string verdictList(const std::vector<Verdict>& verdicts)
{
    std::string html = "<ul class=\"verdicts\">";
    for (const Verdict& verdict : verdicts)
    {
        html += std::string("<li class=\"") + (verdict.holds ? "holds" : "fails") + "\"><b>" +
                (verdict.holds ? "holds" : "does not hold") + "</b><span>" + escaped(verdict.sentence) +
                "</span></li>\n";
    }
    return html + "</ul>\n";
}

// The pictures that the verdicts are about: light bleeding through the bench, and gone.
std::string showpiece(const std::vector<Section>& sections)
{
    std::string html = "<div class=\"pair\">\n";
    for (const Row& row : sections.front().rows)
    {
        if (row.technique->id == "vsm")
        {
            html += figure(row.shaded, "VSM", "The outlines of the leaves' shadow shine through the bench.");
        }
        else if (row.technique->id == "lvsm4")
        {
            html += figure(row.shaded, "LVSM-4", "The ground behind the bench is evenly dark.");
        }
    }
    return html + "</div>\n";
}

} // namespace

std::string pageText(const std::vector<Section>& sections, const std::vector<Verdict>& verdicts, const Setup& setup)
{
    std::ostringstream html;
    html
        << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
           "<title>Filterable shadow maps: the lvsm gallery</title>\n<style>\n"
        << styleSheet() << "</style></head>\n<body><main>\n<h1>Filterable shadow maps</h1>\n"
        << "<p class=\"lead\">Five ways to read a shadow map of " << setup.mapSize << " &times; " << setup.mapSize
        << " texels, against the exact answer. All mathematics come from the library's GLSL includes, run on "
        << escaped(setup.device) << ".</p>\n"
        << contents(sections) << "<h2>What it shows</h2>\n"
        << verdictList(verdicts) << showpiece(sections)
        << "<h2>How to read it</h2>\n<p>VSM, LVSM and EVSM4 store moments of depth in the format named, blur them with "
           "the same binomial kernel of 9 &times; 9 texels in that format, and sample them bilinearly. The exact "
           "picture uses the same weights but compares every unfiltered texel with the receiver's own plane; what "
           "rises from that plane by less than 3 in 10 "
           "is taken for the receiver's curvature, not for an occluder. The plain shadow map "
           "cannot be filtered, so it makes one comparison with the nearest texel. LVSM layers overlap by 1% "
           "of the depth range and blend over as much, and Lloyd relaxation places their splits; it ends in a local "
           "optimum, which another scene may make a worse one. "
           "Figures cover the "
           "surfaces that face the light within the shadow map; each pixel counts by the light that would reach it "
           "unshadowed. No technique uses light bleeding reduction.</p>\n";
    for (const Section& section : sections)
        html << sectionText(section);
    html << "<footer><h2>Sources</h2><ul>"
            "<li>Williams, <cite>Casting Curved Shadows on Curved Surfaces</cite>, SIGGRAPH 1978: shadow maps.</li>"
            "<li>Donnelly and Lauritzen, <cite>Variance Shadow Maps</cite>, I3D 2006: VSM.</li>"
            "<li>Lauritzen and McCool, <cite>Layered Variance Shadow Maps</cite>, Graphics Interface 2008: LVSM, EVSM, "
            "Lloyd relaxation of the layers, and the scenes of figures 2 and 3.</li>"
            "<li>Colours: ColorBrewer PuOr for differences, Okabe and Ito for layers.</li></ul></footer>\n"
            "</main></body></html>\n";
    return html.str();
}

} // namespace lvsm::gallery
