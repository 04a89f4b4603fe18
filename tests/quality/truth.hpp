#ifndef LVSM_TESTS_QUALITY_TRUTH_HPP
#define LVSM_TESTS_QUALITY_TRUTH_HPP

#include <limits>
#include <vector>

#include "peel.hpp"

namespace lvsm::quality
{

/// A place on a surface to be shaded, anywhere between texels, with its exact visibility.
struct Receiver
{
    int x, y;
    glm::vec2 offset;       ///< from the texel's centre, in texels
    Surface surface;        ///< at the texel's centre; the receiver is on its plane
    float visibility;       ///< the filter-weighted share of the window that is not in front of the receiver's surface
    float occluderDistance; ///< mean depth from the taps that are in front to the surface behind them; 0 where none is

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
void judgeAll(const Scene& scene, const std::vector<double>& kernel, std::vector<Receiver>& receivers);

/// Which receivers of a scene are measured.
struct Choice
{
    bool centred = false;                                       ///< on texel centres, not anywhere between them
    std::size_t most = std::numeric_limits<std::size_t>::max(); ///< evenly spread among all
};

/// Light-facing surfaces of every texel that is more than the filter's radius away from the border.
/// In the layered scenes, where a texel has more than three surfaces, each middle one with probability 1/2.
std::vector<Receiver> receiversOf(const Scene& scene, const std::vector<double>& kernel, const Choice& choice = {});

/// Each receiver and its neighbour in the next column on the same surface, where it has one: two after the other.
std::vector<Receiver> neighboursOf(const Scene& scene, const std::vector<Receiver>& receivers,
                                   const std::vector<double>& kernel);

} // namespace lvsm::quality

#endif
