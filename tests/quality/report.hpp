#ifndef LVSM_TESTS_QUALITY_REPORT_HPP
#define LVSM_TESTS_QUALITY_REPORT_HPP

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace lvsm::quality
{

/// What lvsm_cost recorded for GFX1100, in units of inverse throughput.
struct Costs
{
    /// A row of estimates.def, or of so many taps of it, samples included; and the map that it reads.
    struct Estimate
    {
        double units;
        double decisions;
        std::string map;
    };
    /// A map: units and bytes read and written for each texel of the shadow map, of slices for each of them.
    struct Map
    {
        double units;
        double bytes;
        int bits;
        bool slice;
    };
    std::map<std::string, Estimate> estimates;
    std::map<std::string, Map> maps;
};

/// Those that a file records; none where it cannot be read.
Costs readCosts(const std::string& path);

/// What a measured estimate costs a lit pixel, all its taps and decisions. Nothing if unknown.
std::optional<double> costOf(const Measurement& measurement, const Costs& costs);

/// What the map that it reads costs a texel of the shadow map. Nothing if unknown.
std::optional<Costs::Map> mapCostOf(const Measurement& measurement, const Costs& costs);

/// What was measured, and with what.
struct Run
{
    unsigned seed;
    int size;
    std::vector<Measurement> measurements;
    Costs costs;
};

/// Tables in Markdown: every technique by bits, ours beside the best peer, and the limits.
void printTables(const Run& run, std::ostream& out);

/// Writes the rows as JSON, all or nothing; the reason if that fails.
std::optional<std::string> writeJson(const Run& run, const std::string& path);

} // namespace lvsm::quality

#endif
