// The mixture passes, drawn by OpenGL.
#ifndef LVSM_SAMPLING_OPENGL_MIXTURES_HPP
#define LVSM_SAMPLING_OPENGL_MIXTURES_HPP

#include <functional>
#include <string>

namespace sampling
{

// The pass as a program, with macros in front of it.
using MixtureProgram = std::function<unsigned(const std::string&)>;

bool checkMixtureDraws(const MixtureProgram& makeProgram);

} // namespace sampling

#endif
