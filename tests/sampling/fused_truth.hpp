// The store pass and the first direction of the blur in one, by the definition of both.
#ifndef LVSM_SAMPLING_FUSED_TRUTH_HPP
#define LVSM_SAMPLING_FUSED_TRUTH_HPP

#include "passes_truth.hpp"

namespace sampling
{

// More than a group is wide, and more than it is high.
constexpr Shape kFusedSize{150, 11, kSlices};

Pixels fusedDepths();

// Nine taps in pairs, a part of a map, and as many taps as there may be.
std::vector<Blur> fusedBlurs();

lvsm::FusedPasses fusedPassesOf(const Blur& blur);

// result: what the fused pass has left, where it was 0 before.
bool compareFused(const std::string& what, const Blur& blur, const Pixels& result);

} // namespace sampling

#endif
