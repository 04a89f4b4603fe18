#include "page.hpp"

#include <sstream>

#include "page_parts.hpp"
#include "page_text.hpp"

namespace lvsm::gallery
{
namespace
{

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

std::string contents(const std::vector<Section>& sections)
{
    std::string html = "<nav aria-label=\"Contents\"><ul>";
    for (const Section& section : sections)
    {
        html += "<li><a href=\"#" + idOf(section) + "\">" + escaped(section.scene->title) + ", " + section.light.title +
                "</a></li>";
    }
    return html + "<li><a href=\"#papers\">The papers, as numbers</a></li></ul></nav>\n";
}

// The light as it moves.
std::string frames(const Section& section)
{
    if (section.frames.empty())
        return "";
    std::string html = "<h4>While the light moves: four layers, relaxed anew on the device for each frame</h4>\n"
                       "<div class=\"frames\">\n";
    for (const Frame& frame : section.frames)
    {
        const std::string angle = fixed(static_cast<double>(glm::degrees(frame.angle)), 0) + "&deg;";
        html += "<figure><img loading=\"lazy\" src=\"" + frame.shaded + "\" alt=\"LVSM-4, the light turned by " +
                angle + "\"><figcaption>" + angle + "</figcaption></figure>\n";
    }
    return html + "</div>\n";
}

std::string underOneLight(const Section& section)
{
    return "<article id=\"" + idOf(section) + "\"><h3>" + section.light.title + "</h3>\n" + comparison(section) +
           "<div class=\"charts\">\n" + depthChart(section) + storageChart(section) + costChart(section) + "</div>\n" +
           figureTable(section) + frames(section) + "</article>\n";
}

// Lights of one scene come one after the other.
std::string scenes(const std::vector<Section>& sections)
{
    std::string html;
    const Scene* scene = nullptr;
    for (const Section& section : sections)
    {
        if (section.scene != scene)
        {
            html += scene != nullptr ? "</section>\n" : "";
            scene = section.scene;
            html += "<section id=\"" + scene->id + "\"><h2>" + escaped(scene->title) + "</h2>\n<p>" +
                    escaped(scene->description) + "</p>\n";
        }
        html += underOneLight(section);
    }
    return html + (scene != nullptr ? "</section>\n" : "");
}

} // namespace

std::string pageText(const std::vector<Section>& sections, const std::vector<Verdict>& verdicts, const Setup& setup)
{
    std::ostringstream html;
    html << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
            "<title>Filterable shadow maps: the lvsm gallery</title>\n"
            "<script>document.documentElement.classList.add(\"scripted\");</script>\n<style>\n"
         << readText(LVSM_GALLERY_PAGE ".css") << "</style></head>\n<body><main>\n<h1>Filterable shadow maps</h1>\n"
         << "<p class=\"lead\">Ways to read a shadow map of " << setup.mapSize << " &times; " << setup.mapSize
         << " texels, two at a time, against the exact answer. All mathematics come from the library's GLSL includes, "
            "run on "
         << escaped(setup.device) << ".</p>\n"
         << contents(sections) << verdictList(verdicts)
         << "<details><summary>How to read it</summary><p>Choose A and B and drag the divider between them, or move it "
            "by the arrow keys. Maps of moments are blurred by a binomial kernel of 9 &times; 9 texels in the format "
            "named, and sampled bilinearly. The exact "
            "picture uses the same weights but compares every unfiltered texel with the receiver's own plane; what "
            "rises from that plane by less than 3 in 10 "
            "is taken for the receiver's curvature, not for an occluder. The plain shadow map "
            "makes one comparison with the nearest texel. "
            "Figures cover the "
            "surfaces that face the light within the shadow map; each pixel counts by the light that would reach it "
            "unshadowed. Figures of every surface are of depth peels: of all that faces the light along its rays, such "
            "as the inside of a tree's crown, whether or not the camera sees it. No technique uses light bleeding "
            "reduction where its name does not say so.</p></details>\n"
         << scenes(sections) << paperTables()
         << "<footer><h2>Sources</h2><ul>"
            "<li>Williams, <cite>Casting Curved Shadows on Curved Surfaces</cite>, SIGGRAPH 1978: shadow maps.</li>"
            "<li>Donnelly and Lauritzen, <cite>Variance Shadow Maps</cite>, I3D 2006: VSM.</li>"
            "<li>Lauritzen and McCool, <cite>Layered Variance Shadow Maps</cite>, Graphics Interface 2008: LVSM, EVSM, "
            "Lloyd relaxation of the layers, and the scenes of figures 2 and 3.</li>"
            "<li>Colours: ColorBrewer PuOr for errors, Okabe and Ito for layers.</li></ul></footer>\n"
            "</main>\n<script>\n"
         << readText(LVSM_GALLERY_PAGE ".js") << "</script></body></html>\n";
    return html.str();
}

} // namespace lvsm::gallery
