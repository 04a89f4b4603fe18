#ifndef LVSM_TESTS_QUALITY_REPORT_HPP
#define LVSM_TESTS_QUALITY_REPORT_HPP

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace lvsm::quality
{

/// What was measured, and with what.
struct Run
{
    unsigned seed;
    int size;
    int kernel;
    std::vector<Measurement> measurements;
};

/// Tables in Markdown: every technique by bits, ours beside the best peer, and the limits.
void printTables(const Run& run, std::ostream& out);

/// Writes the rows as JSON, all or nothing; the reason if that fails.
std::optional<std::string> writeJson(const Run& run, const std::string& path);

} // namespace lvsm::quality

#endif
