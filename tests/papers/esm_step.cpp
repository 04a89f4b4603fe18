// ESM figures 2 and 3, section 3.1 and the memory that figure 1 tells: what needs no scene.
#include <algorithm>
#include <cmath>

#include <lvsm/convolution.hpp>
#include <lvsm/esm.hpp>

#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

constexpr double kExponent = 80.0;
constexpr int kTerms = 16;

/// A convolution shadow map's answer to one depth, not yet rounded to any format.
double fourierStep(double occluder, double depth)
{
    double sum = 0.0;
    for (int first = 1; first <= kTerms; first += 4)
        sum += fourierSum(fourierSines(occluder, first, kTerms), fourierCosines(occluder, first, kTerms), depth,
                          fourierOffset<double>(kTerms), first, kTerms, 0.0);
    return fourierVisibility(sum, 1.0);
}

/// Figure 2b: mean error of the step over all d - z > 0, and the largest where d - z is more than the CSM's offset.
void approximations(Report& report)
{
    double csmSum = 0.0, esmSum = 0.0, csmWorst = 0.0, esmWorst = 0.0;
    int count = 0;
    for (double difference = 0.0005; difference < 1.0; difference += 0.0005, ++count)
    {
        const double csm = fourierStep(0.0, difference);
        const double esm = exponentialShadow(occluderTerm(0.0, kExponent), difference, kExponent);
        csmSum += csm;
        esmSum += esm;
        if (difference > fourierOffset<double>(kTerms))
        {
            csmWorst = std::max(csmWorst, csm);
            esmWorst = std::max(esmWorst, esm);
        }
    }
    report.add("esm_figure2", "csm_mean", csmSum / count);
    report.add("esm_figure2", "esm_mean", esmSum / count);
    report.add("esm_figure2", "csm_worst", csmWorst);
    report.add("esm_figure2", "esm_worst", esmWorst);
    report.add("esm_figure2", "offset", fourierOffset<double>(kTerms));
}

void draw(Report& report)
{
    constexpr int kWidth = 360, kHeight = 160;
    constexpr double kRange = 0.2;
    Panels panels(kWidth, kHeight, 1);
    const auto plot = [&](double from, double to, int x, glm::vec3 colour)
    {
        const auto row = [](double value)
        {
            return static_cast<int>((1.0 - value) * (kHeight - 9)) + 4;
        };
        for (int y = std::min(row(from), row(to)); y <= std::max(row(from), row(to)) + 1; ++y)
            panels.at(0, x, y) = colour;
    };
    const auto esm = [](double d)
    {
        return exponentialShadow(occluderTerm(0.0, kExponent), d, kExponent);
    };
    for (int x = 0; x + 1 < kWidth; ++x)
    {
        const double d = kRange * x / kWidth, next = kRange * (x + 1) / kWidth;
        plot(0.0, 0.0, x, glm::vec3(0.75f));
        plot(fourierStep(0.0, d), fourierStep(0.0, next), x, {0.85f, 0.45f, 0.05f});
        plot(esm(d), esm(next), x, {0.15f, 0.25f, 0.7f});
    }
    report.picture("esm-figure2", panels);
}

/// Figure 3a: half of the window in front of the receiver, half beyond it.
void failure(Report& report)
{
    const double depth = 0.6;
    const double occluder = 0.5 * (occluderTerm(0.3, kExponent) + occluderTerm(0.9, kExponent));
    report.add("esm_figure3", "estimate", exponentialShadow(occluder, depth, kExponent));
    report.add("esm_figure3", "threshold", violatesThreshold(occluder, depth, kExponent, 0.02) ? 1.0 : 0.0);
    report.add("esm_figure3", "z_max", violatesZMax(depth, 0.9, 0.001) ? 1.0 : 0.0);
    report.add("esm_figure3", "fallback",
               exponentialShadow2x2(glm::dvec4(occluderTerm(0.3, kExponent), occluderTerm(0.9, kExponent),
                                               occluderTerm(0.3, kExponent), occluderTerm(0.9, kExponent)),
                                    glm::dvec2(0.5), depth, kExponent));
    report.add("esm_c", "largest", maxTermExponent(static_cast<double>(std::numeric_limits<float>::max()), 1.0));
}

/// MiB of a 2048 x 2048 map with its mip chain, a third more.
void memory(Report& report)
{
    const auto mebibytes = [](const std::string& name)
    {
        return 2048.0 * 2048.0 * techniqueNamed(name).bits / 8.0 * 4.0 / 3.0 / 1048576.0;
    };
    report.add("esm_memory", "esm", mebibytes("ESM r32f 80"));
    report.add("esm_memory", "vsm", mebibytes("VSM rg32f"));
    report.add("esm_memory", "csm", mebibytes("CSM-16 unorm8 offset"));
    report.add("esm_memory", "evsm4", mebibytes("EVSM4 rgba32f 42/10"));
    report.add("esm_memory", "msm4", mebibytes("MSM4 unorm16"));
    report.add("esm_memory", "pcf", 2048.0 * 2048.0 * techniqueNamed("PCF, 2 x 2").bits / 8.0 / 1048576.0);
    report.add("esm_memory", "lvsm2", mebibytes("LVSM-2 unorm16 paper, uniform"));
    report.add("esm_memory", "lvsm4", mebibytes("LVSM-4 unorm16 paper, uniform"));
    report.add("esm_memory", "lvsm8", mebibytes("LVSM-8 unorm16 paper, uniform"));
}

} // namespace

void esmStep(Report& report)
{
    approximations(report);
    draw(report);
    failure(report);
    memory(report);
}

} // namespace lvsm::papers
