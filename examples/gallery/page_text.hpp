#ifndef LVSM_GALLERY_PAGE_TEXT_HPP
#define LVSM_GALLERY_PAGE_TEXT_HPP

#include <string>

#include <glm/vec3.hpp>

namespace lvsm::gallery
{

/// Text as HTML. Titles of techniques and lights are HTML already; whatever else is shown is text.
std::string escaped(const std::string& text);

std::string fixed(double value, int decimals);

/// A share in percent, without the sign.
std::string percent(double share);

/// An sRGB colour in [0,1].
std::string cssColour(glm::vec3 colour);

/// A file of the repository; throws where it cannot be read.
std::string readText(const std::string& path);

} // namespace lvsm::gallery

#endif
