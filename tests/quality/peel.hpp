#ifndef LVSM_TESTS_QUALITY_PEEL_HPP
#define LVSM_TESTS_QUALITY_PEEL_HPP

#include <cstddef>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "image.hpp"

namespace lvsm::quality
{

/// A surface that the light's ray through a texel meets.
struct Surface
{
    float depth;
    glm::vec2 gradient; ///< change of depth from one texel to the next, in x and in y
    float facing;       ///< n.l; nothing to light where it is 0 or less
};

/// Every surface along every ray of a light: what a shadow map sees, and all that it shades.
class Peel
{
public:
    /// Surfaces of each texel, row by row, in any order; sorted here, nearest first.
    Peel(int size, std::vector<std::vector<Surface>> texels);

    int size() const { return m_size; }
    const Surface* begin(int x, int y) const { return m_surfaces.data() + m_first[texelIndex(x, y, m_size)]; }
    const Surface* end(int x, int y) const { return m_surfaces.data() + m_first[texelIndex(x, y, m_size) + 1]; }

    /// What the shadow map holds: the nearest surface, or depth 1.
    Surface nearest(int x, int y) const { return begin(x, y) == end(x, y) ? kNothing : *begin(x, y); }

    static constexpr Surface kNothing{1.0f, {0.0f, 0.0f}, 0.0f};

private:
    int m_size;
    std::vector<std::size_t> m_first;
    std::vector<Surface> m_surfaces;
};

struct Scene
{
    std::string name;
    Peel peel;
    bool mesh; ///< a depth peel of meshes, as against a world of flat layers
};

} // namespace lvsm::quality

#endif
