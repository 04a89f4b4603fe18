#ifndef LVSM_GALLERY_MEASURE_HPP
#define LVSM_GALLERY_MEASURE_HPP

#include <optional>
#include <vector>

#include "light.hpp"

namespace lvsm::gallery
{

/// What the camera sees, one entry for each pixel, row by row from the top.
struct Picture
{
    int width = 0;
    int height = 0;
    /// xyz: position; w: number of the object, 0 where there is none.
    std::vector<glm::vec4> surface;
    std::vector<glm::vec4> normal;
    std::vector<glm::vec4> colour;
};

/// Exact visibility in x, arriving light in y (cosine and spot cone), 1 in z where the shadow map reaches.
using Truth = std::vector<glm::vec4>;

/// Visibilities against the truth, in shares of full light. Each receiver counts by the light that arrives without
/// shadows, as it would be seen in a picture.
struct Figures
{
    double rmse = 0.0;
    /// Mean of what is lighter than the truth.
    double bleed = 0.0;
    /// Mean of what is darker than the truth.
    double dark = 0.0;
    /// Mean visibility on ground that the scene's shield puts in full shadow, where 0 is right.
    std::optional<double> behindShield;
};

/// Pixels of ground in the full shadow of the shield.
std::vector<bool> shieldedGround(const Picture& picture, const Truth& truth, const Light& light, const Box& shield);

/// Of the receivers from number `begin` on, and before `end`.
Figures measure(const std::vector<glm::vec2>& visibility, const Truth& truth, std::size_t begin, std::size_t end,
                const std::vector<bool>& shielded = {});

} // namespace lvsm::gallery

#endif
