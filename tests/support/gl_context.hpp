#ifndef LVSM_TESTS_SUPPORT_GL_CONTEXT_HPP
#define LVSM_TESTS_SUPPORT_GL_CONTEXT_HPP

#include <string>
#include <utility>
#include <vector>

#include "result.hpp"
#include "texture.hpp"

namespace lvsm::support
{

enum class GlApi
{
    Core45,
    Es31,
    Es30
};

/// An OpenGL context without any window, current on this thread until it is destroyed: Mesa's, in software.
class GlContext
{
public:
    static Result<GlContext> open(GlApi api);

    GlContext(GlContext&& other) noexcept;
    GlContext& operator=(GlContext&&) = delete;
    ~GlContext();

    /// What the driver calls its renderer and version.
    std::string name() const;

private:
    GlContext(void* display, void* context) : m_display(display), m_context(context) {}
    void* m_display;
    void* m_context;
};

/// Compiles and links; stages are (GL_FRAGMENT_SHADER, text) and so on. The error is the driver's log, and so are its
/// warnings.
Result<unsigned> makeGlProgram(const std::vector<std::pair<unsigned, std::string>>& stages);

/// A vertex shader that covers the target by vertices 0 to 2 of a triangle, in the language of an API.
std::string glWholeTarget(GlApi api);

/// A texture of 32-bit floats, an array where asked: linear within the nearest level, clamped to the edge.
unsigned makeGlTexture(const Pixels& pixels, bool array);

/// The first level of a texture array.
Pixels readGlTexture(unsigned texture, int width, int height, int slices);

/// Makes a slice of an array the target of drawing.
void drawToGlSlice(unsigned texture, int slice, int width, int height);

/// What the context has to complain of since the last call; empty is good.
std::string glErrors();

} // namespace lvsm::support

#endif
