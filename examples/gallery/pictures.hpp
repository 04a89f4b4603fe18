#ifndef LVSM_GALLERY_PICTURES_HPP
#define LVSM_GALLERY_PICTURES_HPP

#include <array>
#include <string>
#include <vector>

#include "measure.hpp"

namespace lvsm::gallery
{

/// Sub-pixels of the camera's picture along each side of a pixel of the written file.
constexpr int kSupersampling = 2;

/// Errors of this size, in shares of full light, have the full colour of an error map.
constexpr float kErrorRange = 0.5f;

/// Colours from `-kErrorRange` to `kErrorRange`, evenly spaced, as sRGB in [0,1].
const std::array<glm::vec3, 5>& errorColours();
const std::array<glm::vec3, 8>& layerColours();

/// Each writes one PNG file; all throw where it cannot be written.
void writeShaded(const std::string& path, const Picture& picture, const Truth& truth,
                 const std::vector<glm::vec2>& visibility, bool isSpot);
void writeErrors(const std::string& path, const Picture& picture, const Truth& truth,
                 const std::vector<glm::vec2>& visibility);
void writeLayers(const std::string& path, const Picture& picture, const Truth& truth,
                 const std::vector<glm::vec2>& visibility);

} // namespace lvsm::gallery

#endif
