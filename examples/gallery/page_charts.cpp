#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "page_parts.hpp"
#include "page_text.hpp"

namespace lvsm::gallery
{
namespace
{

// In pixels, as a chart is shown on a phone; elsewhere it is a little larger.
constexpr double kWidth = 360.0;
constexpr double kHeight = 240.0;
constexpr double kLeft = 44.0;
constexpr double kRight = 350.0;
constexpr double kTop = 12.0;
constexpr double kBottom = 200.0;
constexpr double kLetter = 6.4;
constexpr double kLine = 13.0;
constexpr double kMarker = 5.0;
// Who compares every texel of the window has next to no error and is on no front; the axis begins here.
constexpr double kLeastError = 1e-3;

struct Rectangle
{
    double left, top, right, bottom;

    bool meets(const Rectangle& other) const
    {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

struct Axis
{
    double low, high, from, to;

    double at(double value) const { return from + (to - from) * std::log(value / low) / std::log(high / low); }
};

struct Point
{
    const Row* row;
    double value;
    double x, y;
    bool onFront = false;
};

struct Label
{
    double x, y;
    const char* anchor;
    Rectangle box;
};

std::string number(double value)
{
    return fixed(value, value < 9.0 && value != std::floor(value) ? 1 : 0);
}

std::string text(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& attributes = "")
{
    return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" text-anchor=\"" + anchor + "\"" + attributes +
           ">" + words + "</text>";
}

std::string line(double x0, double y0, double x1, double y1)
{
    return "<line x1=\"" + fixed(x0, 1) + "\" y1=\"" + fixed(y0, 1) + "\" x2=\"" + fixed(x1, 1) + "\" y2=\"" +
           fixed(y1, 1) + "\"/>";
}

std::string circle(const Point& point, const std::string& attributes)
{
    return "<circle cx=\"" + fixed(point.x, 1) + "\" cy=\"" + fixed(point.y, 1) + "\" " + attributes + "/>";
}

// Letters of HTML, an entity being one.
double widthOf(const std::string& words)
{
    int letters = 0;
    bool inEntity = false;
    for (const char c : words)
    {
        letters += inEntity ? 0 : 1;
        inEntity = c == '&' || (inEntity && c != ';');
    }
    return kLetter * letters;
}

Label labelAt(double x, double y, const char* anchor, double width)
{
    const double left = anchor[0] == 's' ? x : anchor[0] == 'e' ? x - width : x - width / 2;
    return {x, y, anchor, {left, y - kLine + 3.0, left + width, y + 3.0}};
}

// Around the point, the best place first.
std::vector<Label> placesFor(const Point& point)
{
    const double width = widthOf(point.row->technique->title);
    return {labelAt(point.x + 9, point.y + 4, "start", width),  labelAt(point.x - 9, point.y + 4, "end", width),
            labelAt(point.x, point.y - 10, "middle", width),    labelAt(point.x, point.y + 19, "middle", width),
            labelAt(point.x + 6, point.y - 9, "start", width),  labelAt(point.x - 6, point.y - 9, "end", width),
            labelAt(point.x + 6, point.y + 17, "start", width), labelAt(point.x - 6, point.y + 17, "end", width)};
}

bool isInside(const Rectangle& box)
{
    return box.left >= kLeft && box.right <= kWidth && box.top >= 0.0 && box.bottom <= kBottom;
}

// Those of the front that find room beside all points and earlier labels are shown; the others when they are asked for.
std::string points(const Section& section, std::vector<Point>& all, const std::string& unit)
{
    std::vector<Rectangle> taken;
    for (const Point& point : all)
        taken.push_back({point.x - kMarker, point.y - kMarker, point.x + kMarker, point.y + kMarker});
    std::string svg;
    for (const Point& point : all)
    {
        const std::vector<Label> places = placesFor(point);
        const auto isFree = [&](const Label& label)
        {
            return isInside(label.box) &&
                   std::none_of(taken.begin(), taken.end(), [&](const Rectangle& box) { return label.box.meets(box); });
        };
        const auto free = std::find_if(places.begin(), places.end(), isFree);
        const bool isShown = point.onFront && free != places.end();
        const auto inside = std::find_if(places.begin(), places.end(), [](const Label& l) { return isInside(l.box); });
        const Label label = isShown ? *free : inside != places.end() ? *inside : places.front();
        if (isShown)
            taken.push_back(label.box);
        const std::string& title = point.row->technique->title;
        const std::string error = percent(point.row->figures.rmse);
        svg += "<g tabindex=\"-1\" role=\"img\" aria-label=\"" + title + ": " + number(point.value) + " " + unit +
               ", error " + error + "%\"" + marked(section, *point.row, isShown ? "point labelled" : "point") + ">" +
               circle(point, "r=\"6\" class=\"reach\"") + circle(point, "r=\"4\"");
        for (const char* side : {"A", "B"})
        {
            svg +=
                text(point.x, point.y + 4, "middle", side, std::string(" class=\"letter\" data-side=\"") + side + "\"");
        }
        svg += text(label.x, label.y, label.anchor, title, " class=\"label\"") + "</g>\n";
    }
    return svg;
}

void markFront(std::vector<Point>& points)
{
    for (Point& point : points)
    {
        const double mine = point.row->figures.rmse;
        const auto isBetter = [&](const Point& other)
        {
            const double theirs = other.row->figures.rmse;
            return theirs > kLeastError && other.value <= point.value && theirs <= mine &&
                   (other.value < point.value || theirs < mine);
        };
        point.onFront = mine > kLeastError && std::none_of(points.begin(), points.end(), isBetter);
    }
}

// Round values between the ends, more of them where the ends are near.
std::vector<double> decades(double low, double high)
{
    const std::vector<double> steps =
        high / low > 15.0 ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0, 1.5, 2.0, 3.0, 5.0, 7.0};
    std::vector<double> ticks;
    for (double power = 1e-3; power < 1e7; power *= 10.0)
    {
        for (const double step : steps)
        {
            if (power * step >= low * 0.999 && power * step <= high * 1.001)
                ticks.push_back(power * step);
        }
    }
    return ticks;
}

std::vector<double> octaves(double low, double high)
{
    std::vector<double> ticks;
    for (double tick = 1.0; tick <= high; tick *= 2.0)
    {
        if (tick >= low)
            ticks.push_back(tick);
    }
    return ticks;
}

std::string figure(const std::string& svg, const std::string& title, const std::string& caption)
{
    return "<figure class=\"chart\"><h4>" + title + "</h4><svg viewBox=\"0 0 " + fixed(kWidth, 0) + " " +
           fixed(kHeight, 0) + "\" tabindex=\"0\" role=\"group\" aria-label=\"" + title + "\">\n" + svg +
           "</svg><figcaption>" + caption + "</figcaption></figure>\n";
}

using Ticks = std::vector<double> (*)(double, double);

std::string errorChart(const Section& section, const std::function<std::optional<double>(const Row&)>& valueOf,
                       Ticks ticksOf, const std::string& unit, const std::string& title, const std::string& caption)
{
    std::vector<Point> all;
    double low = 1e9, high = 0.0, least = 1.0, most = 0.0;
    for (const Row& row : section.rows)
    {
        const std::optional<double> value = valueOf(row);
        if (!value)
            continue;
        all.push_back({&row, *value, 0.0, 0.0});
        low = std::min(low, *value);
        high = std::max(high, *value);
        least = std::min(least, std::max(row.figures.rmse, kLeastError));
        most = std::max(most, std::max(row.figures.rmse, kLeastError));
    }
    if (all.empty())
        return "";
    const Axis across{low / 1.3, high * 1.3, kLeft, kRight};
    const Axis up{least * 100.0 / 1.25, most * 100.0 * 1.25, kBottom, kTop};
    std::string svg = "<g class=\"axes\">";
    for (const double tick : ticksOf(across.low, across.high))
        svg += line(across.at(tick), kTop, across.at(tick), kBottom) +
               text(across.at(tick), kBottom + 15, "middle", number(tick));
    for (const double tick : decades(up.low, up.high))
        svg +=
            line(kLeft, up.at(tick), kRight, up.at(tick)) + text(kLeft - 5, up.at(tick) + 4, "end", number(tick) + "%");
    svg += text((kLeft + kRight) / 2, kHeight - 8, "middle", unit) + "</g>\n";
    for (Point& point : all)
    {
        point.x = across.at(point.value);
        point.y = up.at(std::max(point.row->figures.rmse, kLeastError) * 100.0);
    }
    markFront(all);
    return figure(svg + points(section, all, unit), title, caption);
}

} // namespace

std::string depthChart(const Section& section)
{
    if (section.histogram.empty())
        return "";
    const double most = *std::max_element(section.histogram.begin(), section.histogram.end());
    const auto xOf = [](double depth)
    {
        return kLeft + (kRight - kLeft) * depth;
    };
    std::ostringstream svg;
    svg << "<path class=\"bars\" d=\"M" << fixed(kLeft, 1) << " " << fixed(kBottom, 1);
    for (std::size_t i = 0; i < section.histogram.size(); ++i)
    {
        const double count = static_cast<double>(section.histogram.size());
        const double height = std::sqrt(section.histogram[i] / std::max(most, 1e-300)) * (kBottom - kTop);
        svg << "V" << fixed(kBottom - height, 1) << "H" << fixed(xOf(static_cast<double>(i + 1) / count), 1);
    }
    svg << "V" << fixed(kBottom, 1) << "Z\"/><g class=\"axes\">" << line(kLeft, kBottom, kRight, kBottom);
    for (const double depth : {0.0, 0.25, 0.5, 0.75, 1.0})
    {
        const double metres = static_cast<double>(section.light.block.range.x) +
                              depth * static_cast<double>(section.light.metresPerDepth());
        svg << text(xOf(depth), kBottom + 15, "middle", fixed(metres, 1));
    }
    svg << text((kLeft + kRight) / 2, kHeight - 8, "middle", "metres from the light") << "</g>\n";
    for (const Row& row : section.rows)
    {
        svg << "<g" << marked(section, row, "splits") << ">";
        for (std::size_t i = 1; i + 1 < row.splits.size(); ++i)
        {
            const double x = xOf(static_cast<double>(row.splits[i]));
            svg << line(x, kTop, x, kBottom);
        }
        svg << "</g>\n";
    }
    return figure(svg.str(), "Depths in the shadow map, and splits",
                  "Bars as high as the root of their share, the empty background left out. "
                  "<span class=\"key-a\">Splits of A</span>, <span class=\"key-b\">splits of B</span>, where they have "
                  "layers.");
}

std::string storageChart(const Section& section)
{
    return errorChart(
        section, [](const Row& row) { return std::optional<double>(row.technique->bits); }, octaves, "bits of a texel",
        "Error against storage",
        "RMSE in percent of full light. Named is what nothing stored beats in both; the others tell their names under "
        "the pointer or by the arrow keys. Who compares each texel of its filter has next to no error, at the bottom.");
}

std::string costChart(const Section& section)
{
    const auto units = [](const Row& row) -> std::optional<double>
    {
        const std::optional<Cost> cost = costOf(row.technique->id);
        return cost ? std::optional<double>(cost->units) : std::nullopt;
    };
    return errorChart(section, units, decades, "units a pixel, samples included", "Error against cost",
                      "Inverse throughput on GFX1100 (RDNA 3) of the estimate in docs/cost.md that comes nearest; what "
                      "has none is left out.");
}

std::vector<double> depthHistogram(const std::vector<float>& depths)
{
    constexpr std::size_t kBins = 102;
    std::vector<double> shares(kBins);
    for (const float depth : depths)
    {
        if (depth >= 0.0f && depth < 1.0f)
        {
            const auto bin = static_cast<std::size_t>(depth * static_cast<float>(kBins));
            shares[std::min(bin, kBins - 1)] += 1.0 / static_cast<double>(depths.size());
        }
    }
    return shares;
}

} // namespace lvsm::gallery
