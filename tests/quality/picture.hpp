#ifndef LVSM_TESTS_QUALITY_PICTURE_HPP
#define LVSM_TESTS_QUALITY_PICTURE_HPP

#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace lvsm::quality
{

/// An error as a colour: orange where too light, blue where too dark, full colour from 0.5 on.
glm::vec3 errorColour(float error);

/// Writes a PNG of rows of colours in [0,1], as they are to be displayed; the reason if it cannot be written.
std::optional<std::string> writePng(const std::string& path, const std::vector<glm::vec3>& colours, int width);

/// Writes a PNG, seen from the light. Left: the exact visibility of the nearest surfaces times n.l. Right: the largest
/// error of each texel's receivers, as errorColour shows it. The reason if it cannot be written.
std::optional<std::string> writePicture(const StoredMap& map, const Technique& technique, const Setting& setting,
                                        const LitScene& light, const std::string& path);

} // namespace lvsm::quality

#endif
