#ifndef LVSM_TESTS_QUALITY_PICTURE_HPP
#define LVSM_TESTS_QUALITY_PICTURE_HPP

#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace lvsm::quality
{

/// Writes a PNG, seen from the light. Left: the exact visibility of the nearest surfaces times n.l. Right: the largest
/// error of each texel's receivers, orange where too light, blue where too dark, full colour from 0.5 on.
/// The reason if it cannot be written.
std::optional<std::string> writePicture(const StoredMap& map, const Technique& technique, const Setting& setting,
                                        const LitScene& light, const std::string& path);

} // namespace lvsm::quality

#endif
