#include "plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

#include <stb_easy_font.h>
#include <stb_image_write.h>

namespace lvsm::place_layers
{
namespace
{

using Colour = std::array<unsigned char, 3>;

// Of Okabe and Ito's palette, which people with any colour vision tell apart; every row has its name beside it as well.
constexpr Colour kPaper = {255, 255, 255}, kInk = {40, 40, 40}, kFaint = {200, 200, 200}, kBars = {86, 180, 233};
constexpr Colour kMarks[] = {{0, 0, 0}, {213, 94, 0}, {0, 114, 178}};

constexpr int kWidth = 1000, kHeight = 560;
constexpr int kLeft = 110, kRight = 970, kTop = 60, kBottom = 380; // of the histogram
constexpr int kRowHeight = 40;
constexpr int kBins = 215; // of four pixels each
constexpr int kTextScale = 2;

class Canvas
{
public:
    Canvas() : m_pixels(static_cast<std::size_t>(kWidth) * kHeight, kPaper) {}

    void rectangle(double x0, double y0, double x1, double y1, const Colour& colour)
    {
        const auto within = [](double v, int most)
        {
            return std::clamp(static_cast<int>(std::lround(v)), 0, most);
        };
        for (int y = within(y0, kHeight); y < within(y1, kHeight); ++y)
            for (int x = within(x0, kWidth); x < within(x1, kWidth); ++x)
                m_pixels[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] = colour;
    }

    // share: of the text's width that is left of x.
    void text(double x, double y, double share, std::string words, const Colour& colour)
    {
        // stb_easy_font gives four corners of three floats and a colour for each rectangle.
        struct Corner
        {
            float x, y, z;
            unsigned char rgba[4];
        };
        std::vector<Corner> corners(words.size() * 80 + 4);
        x -= share * kTextScale * stb_easy_font_width(words.data());
        const int count = stb_easy_font_print(0, 0, words.data(), nullptr, corners.data(),
                                              static_cast<int>(corners.size() * sizeof(Corner)));
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        {
            const Corner &first = corners[4 * i], &last = corners[4 * i + 2];
            rectangle(x + kTextScale * static_cast<double>(first.x), y + kTextScale * static_cast<double>(first.y),
                      x + kTextScale * static_cast<double>(last.x), y + kTextScale * static_cast<double>(last.y),
                      colour);
        }
    }

    std::string png() const
    {
        std::string bytes;
        stbi_write_png_to_func(
            [](void* to, void* data, int size)
            { static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size)); },
            &bytes, kWidth, kHeight, 3, m_pixels.data(), 3 * kWidth);
        return bytes;
    }

private:
    std::vector<Colour> m_pixels;
};

double xOf(double depth)
{
    return kLeft + depth * (kRight - kLeft);
}

std::string printed(const char* pattern, double value)
{
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, pattern, value);
    return buffer;
}

// Bars as high as the root of a bin's share: few pixels far away can decide where a split goes.
void drawHistogram(Canvas& canvas, const Task& task)
{
    std::vector<double> counts(kBins);
    for (int y = 0; y < task.depths.height; ++y)
    {
        for (int x = 0; x < task.depths.width; ++x)
        {
            const float depth = task.depths.at(x, y);
            if (!std::isnan(depth))
                counts[static_cast<std::size_t>(std::min(static_cast<int>(depth * kBins), kBins - 1))] +=
                    task.weightAt(x, y);
        }
    }
    const double most = std::max(*std::max_element(counts.begin(), counts.end()), 1.0e-300);
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        const double height = std::sqrt(counts[i] / most) * (kBottom - kTop);
        const double x = static_cast<double>(i);
        canvas.rectangle(xOf(x / kBins), kBottom - height, xOf((x + 1) / kBins), kBottom, kBars);
    }
}

void drawAxis(Canvas& canvas)
{
    canvas.rectangle(kLeft, kBottom, kRight, kBottom + 2, kInk);
    for (int i = 0; i <= 4; ++i)
    {
        const double x = xOf(i / 4.0);
        canvas.rectangle(x - 1, kBottom, x + 1, kBottom + 8, kInk);
        canvas.text(x, kBottom + 12, 0.5, printed("%.2f", i / 4.0), kInk);
    }
    canvas.text((kLeft + kRight) / 2.0, kHeight - 24, 0.5, "linear depth, 0 at the light", kInk);
    canvas.text(kLeft - 10, kTop, 1, "share of", kInk);
    canvas.text(kLeft - 10, kTop + 24, 1, "pixels,", kInk);
    canvas.text(kLeft - 10, kTop + 48, 1, "root", kInk);
}

void drawSplits(Canvas& canvas, const Report& report)
{
    const float* const chosen = report.chosen.splits.data();
    for (int i = 1; i < report.task.layerCount; ++i)
    {
        const double x = xOf(static_cast<double>(chosen[i]));
        canvas.rectangle(x - 2, kTop, x + 2, kBottom, kPaper);
        canvas.rectangle(x - 1, kTop, x + 1, kBottom, kInk);
    }
    for (std::size_t row = 0; row < report.placements.size(); ++row)
    {
        const Placement& placement = report.placements[row];
        const double y = kBottom + 40 + static_cast<double>(row) * kRowHeight;
        canvas.rectangle(kLeft, y + 14, kRight, y + 15, kFaint);
        canvas.text(kLeft - 10, y + 6, 1, placement.method, kMarks[row]);
        for (const float split : placement.splits)
        {
            const double x = xOf(static_cast<double>(split));
            const double height = &placement == &report.chosen ? 13 : 9;
            canvas.rectangle(x - 2, y + 14 - height, x + 2, y + 14 + height, kMarks[row]);
        }
    }
}

} // namespace

std::string plot(const Report& report)
{
    Canvas canvas;
    const std::string layers = std::to_string(report.task.layerCount);
    canvas.text(
        kLeft, 20, 0,
        layers + " layers, " + report.chosen.method +
            printed(": predicted error %.4f", report.chosen.errors.bracketed.value_or(report.chosen.errors.layered)),
        kInk);
    drawHistogram(canvas, report.task);
    drawAxis(canvas);
    drawSplits(canvas, report);
    return canvas.png();
}

} // namespace lvsm::place_layers
