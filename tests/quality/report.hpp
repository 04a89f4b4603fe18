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

/// Inverse throughput of the estimates of tests/cost, loads included, by name.
using Costs = std::map<std::string, double>;

/// Those that a file records for GFX1100; none where it cannot be read.
Costs readCosts(const std::string& path);

/// What a measured estimate costs: one tap's times the taps, and for codes times four decisions. Nothing if unknown.
std::optional<double> costOf(const Measurement& measurement, const Costs& costs);

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
