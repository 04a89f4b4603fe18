#include "gl_context.hpp"

#include <cstdlib>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace lvsm::support
{
namespace
{

std::vector<EGLint> attributesOf(GlApi api)
{
    const bool es = api != GlApi::Core45;
    std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, es ? 3 : 4, EGL_CONTEXT_MINOR_VERSION,
                                   api == GlApi::Core45 ? 5
                                   : api == GlApi::Es31 ? 1
                                                        : 0};
    if (!es)
        attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
    attributes.push_back(EGL_NONE);
    return attributes;
}

std::string logOf(GLuint object, bool program)
{
    std::string log(4096, '\0');
    GLsizei length = 0;
    const auto size = static_cast<GLsizei>(log.size());
    if (program)
        glGetProgramInfoLog(object, size, &length, log.data());
    else
        glGetShaderInfoLog(object, size, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

} // namespace

Result<GlContext> GlContext::open(GlApi api)
{
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        return Failure{"no EGL without a window system (Debian: libegl-mesa0, libgl1-mesa-dri)"};
    eglBindAPI(api == GlApi::Core45 ? EGL_OPENGL_API : EGL_OPENGL_ES_API);
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributesOf(api).data());
    if (context == EGL_NO_CONTEXT)
        return Failure{"EGL makes no context of this version"};
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    return GlContext(display, context);
}

GlContext::GlContext(GlContext&& other) noexcept
    : m_display(std::exchange(other.m_display, nullptr)), m_context(std::exchange(other.m_context, nullptr))
{
}

GlContext::~GlContext()
{
    if (m_context == nullptr)
        return;
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
}

std::string GlContext::name() const
{
    const auto text = [](GLenum name)
    {
        return std::string(reinterpret_cast<const char*>(glGetString(name)));
    };
    return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

Result<unsigned> makeGlProgram(const std::vector<std::pair<unsigned, std::string>>& stages)
{
    const GLuint program = glCreateProgram();
    std::string log;
    for (const auto& [stage, text] : stages)
    {
        const GLuint shader = glCreateShader(stage);
        const char* source = text.c_str();
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        log += logOf(shader, false);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    log += logOf(program, true);
    if (linked != GL_TRUE || !log.empty())
        return Failure{"the driver's log: " + log};
    return program;
}

std::string glWholeTarget(GlApi api)
{
    const char* version = api == GlApi::Core45 ? "450" : api == GlApi::Es31 ? "310 es" : "300 es";
    return std::string("#version ") + version + R"(
void main()
{
    gl_Position = vec4(4.0 * float(gl_VertexID & 1) - 1.0, 4.0 * float(gl_VertexID >> 1) - 1.0, 0.0, 1.0);
}
)";
}

unsigned makeGlTexture(const Pixels& pixels, bool array)
{
    const GLenum target = array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(target, texture);
    if (array)
        glTexStorage3D(target, pixels.levels, GL_RGBA32F, pixels.width, pixels.height, pixels.slices);
    else
        glTexStorage2D(target, pixels.levels, GL_RGBA32F, pixels.width, pixels.height);
    for (int level = 0; level < pixels.levels; ++level)
    {
        const glm::vec4* texels = &pixels.at(0, 0, 0, level);
        const int width = pixels.width >> level;
        const int height = pixels.height >> level;
        if (array)
            glTexSubImage3D(target, level, 0, 0, 0, width, height, pixels.slices, GL_RGBA, GL_FLOAT, texels);
        else
            glTexSubImage2D(target, level, 0, 0, width, height, GL_RGBA, GL_FLOAT, texels);
    }
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, pixels.levels > 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

void drawToGlSlice(unsigned texture, int slice, int width, int height)
{
    static thread_local GLuint framebuffer = 0;
    if (glIsFramebuffer(framebuffer) == GL_FALSE)
        glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0, slice);
    glViewport(0, 0, width, height);
}

Pixels readGlTexture(unsigned texture, int width, int height, int slices)
{
    Pixels pixels(width, height, slices);
    for (int slice = 0; slice < slices; ++slice)
    {
        drawToGlSlice(texture, slice, width, height);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, &pixels.at(0, 0, slice));
    }
    return pixels;
}

std::string glErrors()
{
    std::string errors;
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        errors += "OpenGL error " + std::to_string(error) + ' ';
    return errors;
}

} // namespace lvsm::support
