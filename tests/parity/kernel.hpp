// The compute shader that runs one row on all inputs.
#ifndef LVSM_PARITY_KERNEL_HPP
#define LVSM_PARITY_KERNEL_HPP

#include "rows.hpp"

#include <string>

namespace parity
{

constexpr int kGroupSize = 64;

// In both, the library comes first: an #include of lvsm/lvsm.glsl or .hlsli, or the text of the one-file version.
std::string glslKernel(const Row& row, const std::string& library);
std::string hlslKernel(const Row& row, const std::string& library);

} // namespace parity

#endif
