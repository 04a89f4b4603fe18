// How the tests by OpenGL have the one-file shaders. Of a pass, the first line is changed to the #version of the context,
// with what ES asks a user to write and the pass's macros behind it; nothing else.
#ifndef LVSM_SAMPLING_OPENGL_HPP
#define LVSM_SAMPLING_OPENGL_HPP

#include <gl_context.hpp>

#include <string>
#include <utility>
#include <vector>

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace sampling
{

struct Options
{
    lvsm::support::GlApi api = lvsm::support::GlApi::Core45;
    std::string single;
    std::string kernels;
};

std::string readFile(const std::string& path);
std::string head(lvsm::support::GlApi api);
std::string passText(const Options& options, const std::string& file, const std::string& macros);
GLuint program(const std::vector<std::pair<unsigned, std::string>>& stages, const std::string& what);

// The relaxation by fragment passes, and its splits in the uniform buffer of the store pass without leaving the device.
bool checkGlSteps(const Options& options);

} // namespace sampling

#endif
