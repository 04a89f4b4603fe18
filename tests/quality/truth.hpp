#ifndef LVSM_TESTS_QUALITY_TRUTH_HPP
#define LVSM_TESTS_QUALITY_TRUTH_HPP

#include <vector>

#include "peel.hpp"

namespace lvsm::quality
{

/// A surface to be shaded, with its exact visibility.
struct Receiver
{
    int x, y;
    Surface surface;
    float visibility;       ///< the filter-weighted share of the window that is not in front of the receiver's surface
    float occluderDistance; ///< mean depth from the taps that are in front to the surface behind them; 0 where none is
};

/// How far in front, in depth, still counts as the surface itself.
constexpr float kSameDepth = 1.0e-6f;

/// Depth of the receiver's own surface at a tap: that of the surface there that is nearest to the receiver's plane, if
/// a surface that starts with the one slope and ends with the other can reach it, else that of the plane. So a bent
/// surface is not its own shadow, and past a surface's edge what lies behind or in front is not taken for it.
float ownDepth(const Peel& peel, const Surface& receiver, int x, int y, glm::ivec2 offset);

/// Every light-facing surface of every texel that is more than the filter's radius away from the border.
/// In the layered scenes, where a texel has more than three surfaces, each middle one with probability 1/2.
std::vector<Receiver> receiversOf(const Scene& scene, const std::vector<double>& kernel);

} // namespace lvsm::quality

#endif
