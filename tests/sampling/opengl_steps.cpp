#include "opengl.hpp"

#include "steps_truth.hpp"

#include <fstream>
#include <sstream>

namespace sampling
{

using namespace lvsm::support;

std::string readFile(const std::string& path)
{
    std::ifstream stream(path);
    if (!stream)
        throw std::runtime_error("cannot read " + path);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string head(GlApi api)
{
    if (api == GlApi::Core45)
        return "#version 450\n";
    return std::string(api == GlApi::Es31 ? "#version 310 es\n" : "#version 300 es\n") +
           "precision highp float;\nprecision highp int;\n";
}

std::string passText(const Options& options, const std::string& file, const std::string& macros)
{
    const std::string text = readFile(options.single + '/' + file);
    return head(options.api) + macros + text.substr(text.find('\n') + 1);
}

GLuint program(const std::vector<std::pair<unsigned, std::string>>& stages, const std::string& what)
{
    const auto made = makeGlProgram(stages);
    if (!made)
        throw std::runtime_error(what + ": " + made.error());
    return *made;
}

namespace
{

constexpr int kLayersOfTest = 4;
// Where StoreBlock has its splits.
constexpr int kSplitsOffset = 8 * static_cast<int>(sizeof(float));

GLuint makeTarget(GLenum kind, int width, int height, int slices, int levels)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(kind, texture);
    if (kind == GL_TEXTURE_2D)
        glTexStorage2D(kind, levels, GL_RGBA32F, width, height);
    else
        glTexStorage3D(kind, levels, GL_RGBA32F, width, height, slices);
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void readLevel(GLuint texture, int level)
{
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, level);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, level);
}

// The passes and what they keep from frame to frame.
class GlSteps
{
public:
    GlSteps(const Options& options, int slices)
        : m_sumsProgram(pass(options, "step_sums", "lvsm_Step")), m_mipProgram(pass(options, "mip", "lvsm_Mip")),
          m_moveProgram(pass(options, "step_move", "lvsm_Step")), m_levels(lvsm::levelCount(kMap)),
          m_sums(makeTarget(GL_TEXTURE_2D_ARRAY, kMap.width, kMap.height, slices, m_levels)),
          m_states{makeTarget(GL_TEXTURE_2D, kStateWidth, 2, 1, 1), makeTarget(GL_TEXTURE_2D, kStateWidth, 2, 1, 1)}
    {
        const State state = startState(kLayersOfTest);
        glBindTexture(GL_TEXTURE_2D, m_states[0]);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kStateWidth, 2, GL_RGBA, GL_FLOAT, state.data());
        glGenFramebuffers(1, &m_framebuffer);
        glGenBuffers(1, &m_block);
        glGenBuffers(1, &m_store);
        glBindBuffer(GL_UNIFORM_BUFFER, m_store);
        glBufferData(GL_UNIFORM_BUFFER, sizeof(lvsm::StoreBlock), nullptr, GL_DYNAMIC_COPY);
    }

    State draw(lvsm::PlaceStep step, const Depths& image)
    {
        const GLuint depths = makeGlTexture(image.pixels, false);
        for (int slice = 0; slice < step.slices; ++slice)
        {
            step.block.slice = slice;
            use(m_sumsProgram, "lvsm_depths", GL_TEXTURE_2D, depths, step.block);
            drawTo(m_sums, slice, 0, step.sums);
            for (int level = 1; level < m_levels; ++level)
            {
                auto mip = lvsm::mipPass(step.sums, level);
                mip.block.slice = slice;
                readLevel(m_sums, level - 1);
                use(m_mipProgram, "lvsm_source", GL_TEXTURE_2D_ARRAY, m_sums, mip.block);
                drawTo(m_sums, slice, level, mip.region);
            }
        }
        readLevel(m_sums, m_levels - 1);
        use(m_moveProgram, "lvsm_sums", GL_TEXTURE_2D_ARRAY, m_sums, step.block);
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_states[1], 0);
        glViewport(0, 0, kStateWidth, 2);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::swap(m_states[0], m_states[1]);
        glDeleteTextures(1, &depths);
        // The first row to where the store pass and the lighting read it.
        glBindBuffer(GL_PIXEL_PACK_BUFFER, m_store);
        glReadPixels(0, 0, kStateWidth, 1, GL_RGBA, GL_FLOAT, reinterpret_cast<void*>(std::size_t{kSplitsOffset}));
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        State state(static_cast<std::size_t>(8 * kStateWidth));
        glReadPixels(0, 0, kStateWidth, 2, GL_RGBA, GL_FLOAT, state.data());
        return state;
    }

    // The buffer's splits.
    std::vector<float> stored() const
    {
        glBindBuffer(GL_UNIFORM_BUFFER, m_store);
        const auto* splits = static_cast<const float*>(
            glMapBufferRange(GL_UNIFORM_BUFFER, kSplitsOffset, (kMaxLayers + 1) * sizeof(float), GL_MAP_READ_BIT));
        const std::vector<float> copy(splits, splits + kMaxLayers + 1);
        glUnmapBuffer(GL_UNIFORM_BUFFER);
        return copy;
    }

private:
    static GLuint pass(const Options& options, const std::string& name, const char* block)
    {
        const std::string file = "lvsm_" + name + ".frag";
        const GLuint made = program(
            {{GL_VERTEX_SHADER, glWholeTarget(options.api)}, {GL_FRAGMENT_SHADER, passText(options, file, "")}}, file);
        glUniformBlockBinding(made, glGetUniformBlockIndex(made, block), 2);
        return made;
    }

    template <typename Block>
    void use(GLuint made, const char* name, GLenum kind, GLuint texture, const Block& block)
    {
        glUseProgram(made);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(kind, texture);
        glUniform1i(glGetUniformLocation(made, name), 0);
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, m_states[0]);
        glUniform1i(glGetUniformLocation(made, "lvsm_state"), 1);
        glActiveTexture(GL_TEXTURE0);
        glBindBufferBase(GL_UNIFORM_BUFFER, 2, m_block);
        glBufferData(GL_UNIFORM_BUFFER, sizeof(Block), &block, GL_STREAM_DRAW);
    }

    void drawTo(GLuint texture, int slice, int level, const lvsm::Rectangle& region) const
    {
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, level, slice);
        glViewport(region.x, region.y, region.width, region.height);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    GLuint m_sumsProgram;
    GLuint m_mipProgram;
    GLuint m_moveProgram;
    int m_levels;
    GLuint m_sums;
    GLuint m_states[2];
    GLuint m_framebuffer = 0;
    GLuint m_block = 0;
    GLuint m_store = 0;
};

} // namespace

bool checkGlSteps(const Options& options)
{
    const std::vector<Depths> images = stillImages();
    Comparison steps("steps");
    Comparison ends("where steps of all come to rest");
    Comparison stored("splits in the uniform buffer");
    for (const bool inPairs : {false, true})
    {
        for (const std::size_t i : {0u, 1u, 6u})
        {
            GlSteps passes(options, inPairs ? 1 : kLayersOfTest / 2);
            State last;
            const auto draw = [&](const lvsm::PlaceStep& step, const Depths& image)
            {
                return last = passes.draw(step, image);
            };
            compareSteps({images[i], kLayersOfTest, inPairs, false, "image " + std::to_string(i)}, draw, steps, ends);
            const std::vector<float> splits = passes.stored();
            for (std::size_t k = 0; k < splits.size(); ++k)
                stored.expect(static_cast<double>(splits[k]), static_cast<double>(last[k]), 0, std::to_string(k));
        }
    }
    return steps.passed() & ends.passed() & stored.passed();
}

} // namespace sampling
