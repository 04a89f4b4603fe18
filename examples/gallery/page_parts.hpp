#ifndef LVSM_GALLERY_PAGE_PARTS_HPP
#define LVSM_GALLERY_PAGE_PARTS_HPP

#include <optional>
#include <string>

#include "page.hpp"

// Parts of the page, each as HTML. Whatever has the attribute data-technique gets the classes "a" and "b" where that is
// one of the two that are compared, by page.js; what is written here is the first pair.
namespace lvsm::gallery
{

/// The anchor of a scene under a light.
std::string idOf(const Section& section);

/// The attribute, and the classes as long as no other pair is chosen.
std::string marked(const Section& section, const Row& row, const std::string& classes = "");

/// The two techniques that a section begins with.
const Row& firstOf(const Section& section);
const Row& secondOf(const Section& section);

/// Two pictures with a divider, and what chooses them.
std::string comparison(const Section& section);

/// The depths of the shadow map with the pair's splits, and errors against storage and cost.
std::string depthChart(const Section& section);
std::string storageChart(const Section& section);
std::string costChart(const Section& section);

std::string figureTable(const Section& section);

/// What the papers say beside what was measured, from docs/papers.json.
std::string paperTables();

/// What a pixel costs by tests/cost/recorded.json.
struct Cost
{
    /// The estimate that comes nearest to the technique.
    std::string estimate;
    double units;
};
std::optional<Cost> costOf(const std::string& technique);

} // namespace lvsm::gallery

#endif
