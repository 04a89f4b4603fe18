#ifndef LVSM_EXAMPLES_PLACE_LAYERS_DEPTH_IMAGE_HPP
#define LVSM_EXAMPLES_PLACE_LAYERS_DEPTH_IMAGE_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "result.hpp"

namespace lvsm::place_layers
{

/// One number a pixel, the first row on top. Of PNG in [0,1]; of EXR and PFM what the file holds.
struct Image
{
    int width = 0;
    int height = 0;
    std::vector<float> values;
    bool hasEightBits = false;

    float at(int x, int y) const
    {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// Reads a PNG, EXR or PFM file, which is told by its first bytes. Of several channels the depth is taken: Z, or else the
/// first, Y or R. As luminance a PNG's colours count together.
support::Result<Image> readImage(const std::string& path, bool asLuminance = false);

/// What the numbers of a file are. Without near and far they are linear depths in [0,1], or with isReversed 1 less those.
/// With both they are distances from the light, or, where isProjected, the depths of a perspective projection, which
/// isReversed has 1 at the near plane.
struct DepthMeaning
{
    std::optional<float> nearDistance;
    std::optional<float> farDistance;
    bool isProjected = false;
    bool isReversed = false;
};

/// Linear depths, NaN where the file's number was not finite, and what is to be said about them.
struct Depths
{
    Image image;
    std::size_t ignored = 0;
    std::size_t beyond = 0;
    float least = 1.0f;
    float most = 0.0f;
};

/// The reason, where there is nothing to place layers by: depths outside [0,1], none that is finite, or one alone.
support::Result<Depths> linearDepths(Image image, const DepthMeaning& meaning);

/// How many different depths there are, counted up to a limit.
std::size_t distinctDepths(const Image& depths, std::size_t limit);

} // namespace lvsm::place_layers

#endif
