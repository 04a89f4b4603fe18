// lvsm_opengl: runs the one-file passes and wrappers as an OpenGL program has them, and compares with the library's C++
// functions.
#include "opengl.hpp"
#include "opengl_mixtures.hpp"
#include "passes_truth.hpp"
#include "wrappers_truth.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>

namespace
{

using namespace lvsm::support;
using namespace sampling;

constexpr int kSkipped = 77;
// Of Mesa's software rasteriser, at level 0.
constexpr int kSubTexelBits = 8;

const std::map<std::string, GlApi> kApis = {
    {"core_4.5", GlApi::Core45}, {"es_3.1", GlApi::Es31}, {"es_3.0", GlApi::Es30}};

// One of the passes as a program that has its block at binding 2.
GLuint passProgram(const Options& options, const std::string& name, bool compute, const std::string& macros)
{
    const std::string file = "lvsm_" + name + (compute ? ".comp" : ".frag");
    const std::string text = passText(options, file, macros);
    const GLuint made =
        compute ? program({{GL_COMPUTE_SHADER, text}}, file)
                : program({{GL_VERTEX_SHADER, glWholeTarget(options.api)}, {GL_FRAGMENT_SHADER, text}}, file);
    glUniformBlockBinding(made, glGetUniformBlockIndex(made, name == "blur" ? "lvsm_Blur" : "lvsm_Store"), 2);
    return made;
}

template <typename Block>
void runPass(GLuint made, bool compute, GLenum kind, GLuint source, GLuint target, lvsm::Pass<Block> pass)
{
    glUseProgram(made);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(kind, source);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBufferBase(GL_UNIFORM_BUFFER, 2, buffer);
    for (int slice = 0; slice < (compute ? 1 : kSlices); ++slice)
    {
        if (!compute)
            pass.block.slice = slice;
        glBufferData(GL_UNIFORM_BUFFER, sizeof(Block), &pass.block, GL_STREAM_DRAW);
        if (compute)
        {
            glBindImageTexture(1, target, 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
            glDispatchCompute(static_cast<GLuint>(pass.groups.x), static_cast<GLuint>(pass.groups.y),
                              static_cast<GLuint>(pass.groups.z));
            glMemoryBarrier(GL_ALL_BARRIER_BITS);
            continue;
        }
        drawToGlSlice(target, slice, kWidth, kHeight);
        glEnable(GL_SCISSOR_TEST);
        glScissor(pass.region.x, pass.region.y, pass.region.width, pass.region.height);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDisable(GL_SCISSOR_TEST);
    }
    glDeleteBuffers(1, &buffer);
}

bool checkBlurs(const Options& options, bool compute)
{
    const GLuint made = passProgram(options, "blur", compute, compute ? "#define LVSM_BLUR_FORMAT rgba32f\n" : "");
    bool passed = true;
    for (const Blur& blur : {binomialBlur(), gaussianBlur(), boxBlur(), blurOfPart()})
    {
        const Pixels pixels = randomPixels(kSlices);
        const GLuint source = makeGlTexture(pixels, true);
        const GLuint between = makeGlTexture(Pixels(kWidth, kHeight, kSlices), true);
        const GLuint target = makeGlTexture(Pixels(kWidth, kHeight, kSlices), true);
        runPass(made, compute, GL_TEXTURE_2D_ARRAY, source, between, blur.passes().across);
        runPass(made, compute, GL_TEXTURE_2D_ARRAY, between, target, blur.passes().down);
        passed = compareBlur(compute ? "blur.comp" : "blur.frag", blur, pixels,
                             readGlTexture(target, kWidth, kHeight, kSlices), kSubTexelBits) &&
                 passed;
    }
    return passed;
}

bool checkStores(const Options& options, bool compute)
{
    bool passed = true;
    for (const Store& store : {layersStore(), exponentialStore(false)})
    {
        const std::string format = compute ? "#define LVSM_STORE_FORMAT rgba32f\n" : "";
        const GLuint made = passProgram(options, "store", compute, format + store.macros);
        const Pixels depths = storeDepths();
        const GLuint source = makeGlTexture(depths, false);
        const GLuint target = makeGlTexture(Pixels(kWidth, kHeight, kSlices), true);
        runPass(made, compute, GL_TEXTURE_2D, source, target, storePassOfTest());
        passed = compareStore(compute ? "store.comp" : "store.frag", store, depths,
                              readGlTexture(target, kWidth, kHeight, kSlices)) &&
                 passed;
    }
    return passed;
}

std::string wrappersText(const Options& options)
{
    std::string kernel = readFile(options.kernels + "/wrappers.frag");
    const std::string mark = "CALL_WRAPPERS\n";
    kernel.replace(kernel.rfind(mark), mark.size(), readFile(options.kernels + "/wrappers.glsl"));
    return head(options.api) + readFile(options.single + "/lvsm_combined.glsl") + kernel;
}

bool checkWrappersOf(const Options& options)
{
    const Maps maps = makeMaps();
    std::vector<Receiver> receivers = makeReceivers();
    const std::vector<Receiver> walk = makeWalk();
    receivers.insert(receivers.end(), walk.begin(), walk.end());
    const auto count = static_cast<int>(receivers.size());
    Pixels inputs(kInputs, count);
    for (int i = 0; i < count; ++i)
    {
        const auto own = inputsOf(receivers[static_cast<std::size_t>(i)], kAlone);
        for (int k = 0; k < kInputs; ++k)
            inputs.at(k, i) = own[static_cast<std::size_t>(k)];
    }
    const GLuint made = program(
        {{GL_VERTEX_SHADER, glWholeTarget(options.api)}, {GL_FRAGMENT_SHADER, wrappersText(options)}}, "wrappers");
    glUseProgram(made);
    const GLuint target = makeGlTexture(Pixels(count, kResults, 1), true);
    GLint unit = 0;
    for (const auto& [name, pixels] : {std::pair<const char*, const Pixels*>("receivers", &inputs),
                                       {"map", &maps.map},
                                       {"slices", &maps.slices},
                                       {"unfiltered", &maps.unfiltered},
                                       {"greatest", &maps.greatest}})
    {
        glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
        makeGlTexture(*pixels, pixels->slices > 1);
        glUniform1i(glGetUniformLocation(made, name), unit++);
    }
    drawToGlSlice(target, 0, count, kResults);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const Pixels drawn = readGlTexture(target, count, kResults, 1);
    std::vector<float> results;
    for (int i = 0; i < count * kResults; ++i)
        results.push_back(drawn.at(i / kResults, i % kResults).x);
    return compareWrappers(maps, receivers, results);
}

bool check(const Options& options, const std::string& what)
{
    // Core OpenGL draws with a vertex array bound, if only an empty one.
    GLuint vertices = 0;
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
    if (what == "wrappers")
        return checkWrappersOf(options);
    if (what == "steps")
        return checkGlSteps(options);
    if (what == "mixtures")
    {
        const auto drawing = [&](const std::string& macros)
        {
            return program({{GL_VERTEX_SHADER, glWholeTarget(options.api)},
                            {GL_FRAGMENT_SHADER, passText(options, "lvsm_mixture.frag", macros)}},
                           "lvsm_mixture.frag");
        };
        return checkMixtureDraws(drawing);
    }
    const bool fragment = checkBlurs(options, false) & checkStores(options, false);
    return options.api == GlApi::Es30 ? fragment : fragment & checkBlurs(options, true) & checkStores(options, true);
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    std::string what;
    std::string api;
    CLI::App app("Runs the one-file passes and wrappers by OpenGL, and compares with the library's C++ functions.");
    app.add_option("what", what, "wrappers, passes, steps or mixtures")
        ->required()
        ->check(CLI::IsMember({"wrappers", "passes", "steps", "mixtures"}));
    app.add_option("api", api, "of OpenGL")->required()->check(CLI::IsMember(kApis));
    app.add_option("--single", options.single, "folder of the one-file versions")->required();
    app.add_option("--kernels", options.kernels, "folder of the shaders that call the wrappers")->required();
    CLI11_PARSE(app, argc, argv);
    options.api = kApis.at(api);
    const auto context = GlContext::open(options.api);
    if (!context)
    {
        std::printf("skip: %s\n", context.error().c_str());
        return kSkipped;
    }
    std::printf("%s\n", context->name().c_str());
    try
    {
        const bool passed = check(options, what);
        const std::string errors = glErrors();
        std::printf("%s", errors.c_str());
        return passed && errors.empty() ? 0 : 1;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "lvsm_opengl: %s\n", error.what());
        return 1;
    }
}
