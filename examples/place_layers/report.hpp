#ifndef LVSM_EXAMPLES_PLACE_LAYERS_REPORT_HPP
#define LVSM_EXAMPLES_PLACE_LAYERS_REPORT_HPP

#include <string>
#include <vector>

#include "placement.hpp"

namespace lvsm::place_layers
{

/// What is said about a placement. chosen: of the placements, the one whose splits are given.
struct Report
{
    std::string path;
    const Depths& depths;
    const Task& task;
    const std::vector<Placement>& placements;
    const Placement& chosen;
};

/// The names that format() takes.
std::vector<std::string> formatNames();

/// The splits in words, as JSON, or as constants of a language, ready to paste.
std::string format(const Report& report, const std::string& name);

} // namespace lvsm::place_layers

#endif
