// The compute shaders whose cost is told: functions, beside each one that only loads and stores, and whole estimates and
// passes, with all that they read and write.
#ifndef LVSM_COST_KERNELS_HPP
#define LVSM_COST_KERNELS_HPP

#include <string>
#include <utility>
#include <vector>

namespace cost
{

struct Kernel
{
    std::string kind; ///< "function", "form", "estimate" or "pass"
    std::string name;
    std::string text;
    /// What stands beside it. Of a function or a form of one: the same loads and stores, and nothing between but additions that keep the
    /// loads alive. Of an estimate: the same with the wrappers' rule for borders.
    std::string beside = {};
    /// Of an estimate: the map that it reads, of maps(), and how many decisions it makes, of taps and of the texels that
    /// each decodes.
    std::string map = {};
    int decisions = 0;
    /// Of a pass: bytes of textures for each texel that it makes, each counted once.
    double readBytes = 0.0;
    double writtenBytes = 0.0;
};

/// The rows of tests/parity/functions.def.
std::vector<Kernel> functionKernels();

/// One of them by a text of the library.
Kernel functionKernel(const std::string& function, const std::string& library);

/// Functions without a part of theirs, or in fewer operations.
std::vector<Kernel> formKernels(const std::string& glslFolder);

/// Those of estimates.def, with their taps. glslFolder: holds lvsm/lvsm.glsl.
std::vector<Kernel> estimateKernels(const std::string& glslFolder);

/// The compute passes, their settings constants and their loops of the length that they have for a texel in the middle of
/// a map.
std::vector<Kernel> passKernels(const std::string& glslFolder);

/// A map, or a slice of one: the passes that make it, and how many of their texels for one of the shadow map.
struct Map
{
    std::string name;
    int width;         ///< of the window in texels
    double resolution; ///< 0.5: a texel for 2 x 2 of the shadow map
    int bits;          ///< of a texel of what is stored
    bool slice;        ///< whether a texel of more bits is as many of it
    std::vector<std::pair<std::string, double>> passes;
};
std::vector<Map> maps();

} // namespace cost

#endif
