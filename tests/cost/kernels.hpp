// The compute shaders whose cost is told: each function and estimate, and beside each one that only loads and stores.
#ifndef LVSM_COST_KERNELS_HPP
#define LVSM_COST_KERNELS_HPP

#include <string>
#include <vector>

namespace cost
{

struct Kernel
{
    std::string name;
    std::string text;
    // The same loads and stores, and nothing between but additions that keep the loads alive; none for a pass, which is
    // told whole.
    std::string loads;
};

// GLSL kernels: the rows of tests/parity/functions.def, then those of estimates.def.
std::vector<Kernel> functionKernels();
std::vector<Kernel> estimateKernels();
// The compute passes, with their resources at bindings 2 to 4.
// glslFolder: holds lvsm/lvsm.glsl.
std::vector<Kernel> passKernels(const std::string& glslFolder);

} // namespace cost

#endif
