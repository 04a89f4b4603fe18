// The shaders that run one row on all inputs.
#ifndef LVSM_PARITY_KERNEL_HPP
#define LVSM_PARITY_KERNEL_HPP

#include "rows.hpp"

#include <string>

namespace parity
{

constexpr int kGroupSize = 64;

// How many numbers a kind of result has.
int componentCount(const std::string& kind);

// In both, the library comes first: an #include of lvsm/lvsm.glsl or .hlsli, or the text of the one-file version.
std::string glslKernel(const Row& row, const std::string& library);
std::string hlslKernel(const Row& row, const std::string& library);

// The same in WGSL, which includes nothing and has no macros: library is the text of the one-file version.
std::string wgslKernel(const Row& row, const std::string& library);

// The same as a fragment shader of GLSL 3.30 and of ES 3.00, to put after #version, precision and the library. The
// texture lvsm_inputs holds 64 inputs a row, six texels of four words each; an input's results go to its pixel.
constexpr int kInputsPerRow = 64;
std::string glslFragmentKernel(const Row& row);

} // namespace parity

#endif
