// The mixture passes as an OpenGL program without compute shaders has them, draw by draw.
#include "opengl_mixtures.hpp"

#include "mixtures_truth.hpp"

#include <gl_context.hpp>

#include <cstdio>

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace sampling
{
namespace
{

// Whole numbers, which nothing filters.
GLuint makeTarget(GLenum format, const Shape& shape)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, format, shape.width, shape.height, shape.slices);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

std::vector<Packed> readSlice(int slice, const lvsm::Rectangle& r)
{
    std::vector<Packed> texels(static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height));
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(slice));
    glReadPixels(r.x, r.y, r.width, r.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
    return texels;
}

// Draws a pass into slices of a target, which stays bound. Returns what they hold in the pass's region, slice by slice.
std::vector<std::vector<Packed>> drawPass(GLuint program, const lvsm::Pass<lvsm::MixingBlock>& pass, bool fromMixtures,
                                          GLuint source, GLuint target, int slices)
{
    glUseProgram(program);
    glUniformBlockBinding(program, glGetUniformBlockIndex(program, "lvsm_Mixing"), 2);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(fromMixtures ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, source);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBufferBase(GL_UNIFORM_BUFFER, 2, buffer);
    glBufferData(GL_UNIFORM_BUFFER, sizeof(pass.block), &pass.block, GL_STREAM_DRAW);
    GLuint frame = 0;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    std::vector<GLenum> all;
    for (int slice = 0; slice < slices; ++slice)
    {
        all.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(slice));
        glFramebufferTextureLayer(GL_FRAMEBUFFER, all.back(), target, 0, slice);
    }
    glDrawBuffers(slices, all.data());
    // The triangle covers a viewport from the corner on; what is outside the region stays as it is.
    glViewport(0, 0, pass.region.x + pass.region.width, pass.region.y + pass.region.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(pass.region.x, pass.region.y, pass.region.width, pass.region.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    std::vector<std::vector<Packed>> drawn;
    for (int slice = 0; slice < slices; ++slice)
        drawn.push_back(readSlice(slice, pass.region));
    glDeleteFramebuffers(1, &frame);
    glDeleteBuffers(1, &buffer);
    return drawn;
}

Mixtures mixturesOf(const lvsm::Pass<lvsm::MixingBlock>& pass, const std::vector<std::vector<Packed>>& slices)
{
    const auto& block = pass.block;
    Mixtures made({block.region[0], block.region[1], pass.region.width, pass.region.height});
    for (std::size_t i = 0; i < made.texels.size(); ++i)
    {
        for (std::size_t k = 0; k < slices.size(); ++k)
            made.texels[i].packed[k] = slices[k][i];
    }
    return made;
}

bool checkDraws(const MixtureProgram& makeProgram, const MixtureCase& test, const DepthOf& depth)
{
    const auto draws = lvsm::mixtureDrawsOf(test.window(), test.map, test.region);
    Pixels pixels(test.depths.width, test.depths.height);
    for (int y = 0; y < test.depths.height; ++y)
    {
        for (int x = 0; x < test.depths.width; ++x)
            pixels.at(x, y).x = depth(x, y);
    }
    const GLuint depths = makeGlTexture(pixels, false);
    Comparison components(test.name);
    Comparison codes(test.name + ", codes");
    GLuint source = depths;
    Mixtures before({});
    for (int i = 0; i < draws.count; ++i)
    {
        const auto& pass = draws.passes[i];
        const std::string macros = "#define LVSM_MIXTURE_COUNT " + std::to_string(test.count) + "\n" +
                                   (i > 0 ? "#define LVSM_MIXTURE_FROM_MIXTURES\n" : "");
        const bool isLast = i + 1 == draws.count;
        Shape shape = isLast ? test.coded() : Shape{draws.between.width, draws.between.height};
        shape.slices = test.count;
        const GLuint target = makeTarget(GL_RGBA32UI, shape);
        const Mixtures made = mixturesOf(pass, drawPass(makeProgram(macros + "#define LVSM_MIXTURE_TO_MIXTURES\n"),
                                                        pass, i > 0, source, target, test.count));
        const int x = pass.block.steps[0], y = pass.block.steps[1];
        Mixtures from = i > 0 ? before : depthMixtures(test, lvsm::detail::grown(made.area, x, y), depth);
        compareComponents(components, made,
                          x + y > 0 ? mixed(test, from, x, y, static_cast<double>(pass.block.shares[0])) : from,
                          test.count);
        if (isLast)
        {
            Shape coded = test.coded();
            const GLuint codeTarget = makeTarget(test.count == 2 ? GL_RG32UI : GL_RGBA32UI, coded);
            const auto drawn = drawPass(makeProgram(macros), pass, i > 0, source, codeTarget, 1)[0];
            for (std::size_t t = 0; t < drawn.size(); ++t)
                compareCode(codes, test.count, drawn[t], trueCode(test, made.texels[t]), 1, std::to_string(t));
        }
        source = target;
        before = made;
    }
    const bool passed = components.passed();
    return codes.passed() && passed;
}

} // namespace

bool checkMixtureDraws(const MixtureProgram& makeProgram)
{
    bool passed = true;
    for (const int count : {4, 2})
    {
        for (const auto& [width, half] : {std::pair(1, false), {1, true}, {7, false}, {5, true}, {11, false}})
        {
            MixtureCase test{std::to_string(count) + " components, width " + std::to_string(width) +
                                 (half ? ", half" : ""),
                             count, width, half};
            passed = checkDraws(makeProgram, test, barDepth) && passed;
            test.name += ", a part";
            test.deviation = width == 11 ? 2.6f : 0.0f;
            test.map = {4, 2, 21, 17};
            test.region = {7, 2, 11, 30};
            passed = checkDraws(makeProgram, test, noiseDepth) && passed;
        }
    }
    return passed;
}

} // namespace sampling
