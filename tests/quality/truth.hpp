#ifndef LVSM_TESTS_QUALITY_TRUTH_HPP
#define LVSM_TESTS_QUALITY_TRUTH_HPP

#include <limits>
#include <vector>

#include "peel.hpp"

namespace lvsm::quality
{

/// The part of the map that a pixel sees, as long as so many texels and so many times narrower. One texel is none.
struct Footprint
{
    int length = 1;
    int stretch = 1;

    float across() const { return static_cast<float>(length) / static_cast<float>(stretch); }
    bool minified() const { return length > 1; }
};

/// A filter window around a place, with the footprint there: the share of each texel.
class PlacedWindow
{
public:
    /// offset: from a texel's centre, in texels. direction: of the footprint's length.
    PlacedWindow(const std::vector<double>& kernel, glm::vec2 offset, const Footprint& footprint, glm::vec2 direction);

    int first() const { return m_first; }
    int last() const { return m_first + m_size - 1; }
    double weight(int x, int y) const
    {
        return m_weights[static_cast<std::size_t>(y - m_first) * static_cast<std::size_t>(m_size) +
                         static_cast<std::size_t>(x - m_first)];
    }

private:
    int m_first;
    int m_size;
    std::vector<double> m_weights;
};

/// A place on a surface to be shaded, anywhere between texels, with its exact visibility.
struct Receiver
{
    int x, y;
    glm::vec2 offset;       ///< from the texel's centre, in texels
    Surface surface;        ///< at the texel's centre; the receiver is on its plane
    float visibility;       ///< the filter-weighted share of the window that is not in front of the receiver's surface
    float occluderDistance; ///< mean depth from the taps that are in front to the surface behind them; 0 where none is
    glm::vec2 direction = {1.0f, 0.0f}; ///< of the length of its footprint

    float depth() const { return surface.depth + glm::dot(surface.gradient, offset); }
};

/// How far in front, in depth, still counts as the surface itself.
constexpr float kSameDepth = 1.0e-6f;

/// The receiver's own surface at a tap: that which is nearest to the receiver's plane there, if a surface that starts
/// with the one slope and ends with the other can reach it, else none.
const Surface* ownSurface(const Peel& peel, const Surface& receiver, int x, int y, glm::ivec2 offset);

/// Depth of the receiver's own surface at a tap, or of the plane where it has none. So a bent surface is not its own
/// shadow, and past a surface's edge what lies behind or in front is not taken for it.
float ownDepth(const Peel& peel, const Surface& receiver, int x, int y, glm::ivec2 offset);

/// Works out the visibility and occluder distance of receivers whose place and surface are known.
void judgeAll(const Scene& scene, const std::vector<double>& kernel, std::vector<Receiver>& receivers,
              const Footprint& footprint = {});

/// Which receivers of a scene are measured.
struct Choice
{
    bool centred = false;                                       ///< on texel centres, not anywhere between them
    std::size_t most = std::numeric_limits<std::size_t>::max(); ///< evenly spread among all
    Footprint footprint = {};
};

/// Light-facing surfaces of every texel that is more than the filter's radius away from the border.
/// In the layered scenes, where a texel has more than three surfaces, each middle one with probability 1/2.
std::vector<Receiver> receiversOf(const Scene& scene, const std::vector<double>& kernel, const Choice& choice = {});

/// Each receiver and its neighbour in the next column on the same surface, where it has one: two after the other.
std::vector<Receiver> neighboursOf(const Scene& scene, const std::vector<Receiver>& receivers,
                                   const std::vector<double>& kernel);

} // namespace lvsm::quality

#endif
