// The one-file version pasted into fragment shaders of OpenGL, after #version and, in ES, two lines of precision:
//   lvsm_client_opengl functions VERSION LIBRARY FOLDER   runs what `lvsm_client_rows write FOLDER` has written
//   lvsm_client_opengl quick_start VERSION LIBRARY README draws with the README's GLSL, and compares with plain filtering
// VERSION is that of the shaders, such as "330 core" or "300 es"; LIBRARY the one-file version. Status 77 says that there
// is no such OpenGL.
#include <lvsm/filter.hpp>
#include <lvsm/optimal.hpp>
#include <lvsm/pcf.hpp>

#include <gl_context.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace
{

using namespace lvsm::support;

constexpr int kWords = 24;
constexpr int kInputsPerRow = 64;

std::string readFile(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class Client
{
public:
    Client(const std::string& version, const std::string& library) : m_library(readFile(library))
    {
        const bool es = version.find("es") != std::string::npos;
        m_api = !es ? GlApi::Core45 : version == "300 es" ? GlApi::Es30 : GlApi::Es31;
        m_head = "#version " + version + "\n" + (es ? "precision highp float;\nprecision highp int;\n" : "");
    }

    GlApi api() const { return m_api; }

    GLuint program(const std::string& text) const
    {
        const auto made =
            makeGlProgram({{GL_VERTEX_SHADER, glWholeTarget(m_api)}, {GL_FRAGMENT_SHADER, m_head + m_library + text}});
        if (!made)
            throw std::runtime_error(made.error());
        glUseProgram(*made);
        return *made;
    }

private:
    std::string m_library;
    GlApi m_api;
    std::string m_head;
};

GLuint texture(GLenum format, int width, int height, GLint filter)
{
    GLuint made = 0;
    glGenTextures(1, &made);
    glBindTexture(GL_TEXTURE_2D, made);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return made;
}

// Draws over the whole of the textures with the current program and textures.
void drawInto(const std::vector<GLuint>& targets, int width, int height)
{
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    std::vector<GLenum> attachments;
    for (const GLuint target : targets)
    {
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, target, 0);
    }
    glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("this OpenGL does not draw to such a format");
    glViewport(0, 0, width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<float> readTarget(int number, int width, int height)
{
    std::vector<float> pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(number));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

void runRow(const Client& client, const nlohmann::json& row, const std::string& folder)
{
    const std::string name = folder + "/" + row.at("function").get<std::string>();
    const std::string words = readFile(name + ".inputs");
    const int count = row.at("inputs").get<int>();
    const int height = count / kInputsPerRow;
    const int width = kInputsPerRow * kWords / 4;
    const GLuint inputs = texture(GL_RGBA32UI, width, height, GL_NEAREST);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words.data());
    std::vector<GLuint> targets;
    for (int i = 0; i < 3; ++i)
        targets.push_back(texture(GL_RGBA32F, kInputsPerRow, height, GL_NEAREST));

    // Three targets hold twelve numbers of an input's result.
    const std::size_t numbers = row.at("numbers").get<std::size_t>();
    std::vector<float> results(numbers * static_cast<std::size_t>(count));
    for (std::size_t first = 0; first < numbers; first += 12)
    {
        const std::string define = "#define FIRST " + std::to_string(first) + "\n";
        const GLuint program = client.program(define + row.at("kernel").get<std::string>());
        glBindTexture(GL_TEXTURE_2D, inputs);
        drawInto(targets, kInputsPerRow, height);
        for (std::size_t begin = first; begin < std::min(first + 12, numbers); begin += 4)
        {
            const std::vector<float> four = readTarget(static_cast<int>((begin - first) / 4), kInputsPerRow, height);
            for (std::size_t i = 0; i < results.size(); ++i)
            {
                const std::size_t number = i % numbers;
                if (number >= begin && number < begin + 4)
                    results[i] = four[4 * (i / numbers) + number - begin];
            }
        }
        glDeleteProgram(program);
    }
    std::ofstream(name + ".results", std::ios::binary)
        .write(reinterpret_cast<const char*>(results.data()),
               static_cast<std::streamsize>(results.size() * sizeof(float)));
    glDeleteTextures(1, &inputs);
    glDeleteTextures(3, targets.data());
}

// A square map of depths: a lattice over a table over the ground.
constexpr int kSize = 256;
constexpr int kTaps = 7;
constexpr float kGround = 0.8f;

float depthAt(int x, int y)
{
    const bool lattice = x % 28 < 10 || y % 28 < 10;
    const bool table = x > 60 && x < 180 && y > 80 && y < 160;
    return lattice && x > 20 && x < 230 && y > 20 && y < 230 ? 0.2f : table ? 0.5f : kGround;
}

// Visibility of the ground at a texel's centre: the depth tests that the blur's window holds, with its weights.
float plainFiltering(int x, int y)
{
    float lit = 0.0f;
    for (int j = 0; j < kTaps; ++j)
    {
        for (int i = 0; i < kTaps; ++i)
            lit += lvsm::binomialWeight(i, kTaps) * lvsm::binomialWeight(j, kTaps) *
                   lvsm::depthTest(depthAt(x + i - kTaps / 2, y + j - kTaps / 2), kGround, 1.0e-4f);
    }
    return lit;
}

// The first GLSL of the README's section Quick start.
std::string snippetOf(const std::string& readme)
{
    const std::string text = readFile(readme);
    const std::size_t section = text.find("## Quick start");
    const std::size_t begin = text.find("```glsl\n", section) + 8;
    return text.substr(begin, text.find("```", begin) - begin);
}

const char* const kStore = R"(
uniform highp sampler2D depths;
uniform float split;
out vec4 result;
void main()
{
    result = store(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).x, split);
}
)";

const char* const kBlur = R"(
uniform highp sampler2D map;
uniform vec2 direction;
out vec4 result;
void main()
{
    vec2 size = vec2(textureSize(map, 0));
    result = vec4(0.0);
    for (int tap = -3; tap <= 3; ++tap)
        result += lvsm_binomialWeight(tap + 3, 7) * texture(map, (gl_FragCoord.xy + float(tap) * direction) / size);
}
)";

const char* const kJudge = R"(
uniform highp sampler2D map;
uniform float split;
out vec4 result;
void main()
{
    result = vec4(visibility(texture(map, gl_FragCoord.xy / vec2(textureSize(map, 0))), 0.8, split));
}
)";

int quickStart(const Client& client, const std::string& readme)
{
    const std::string snippet = snippetOf(readme);
    std::vector<float> depths;
    for (int i = 0; i < kSize * kSize; ++i)
        depths.push_back(depthAt(i % kSize, i / kSize));
    float splits[3];
    if (!lvsm::optimalSplits(depths.data(), kSize, kSize, splits, 2))
        return 1;

    const GLuint source = texture(GL_R32F, kSize, kSize, GL_NEAREST);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize, kSize, GL_RED, GL_FLOAT, depths.data());
    const GLuint map = texture(GL_RGBA16F, kSize, kSize, GL_LINEAR);
    const GLuint other = texture(GL_RGBA16F, kSize, kSize, GL_LINEAR);
    const GLuint answer = texture(GL_RGBA32F, kSize, kSize, GL_NEAREST);

    const GLuint store = client.program(snippet + kStore);
    glUniform1f(glGetUniformLocation(store, "split"), splits[1]);
    glBindTexture(GL_TEXTURE_2D, source);
    drawInto({map}, kSize, kSize);
    const GLuint blur = client.program(kBlur);
    glUniform2f(glGetUniformLocation(blur, "direction"), 1.0f, 0.0f);
    glBindTexture(GL_TEXTURE_2D, map);
    drawInto({other}, kSize, kSize);
    glUniform2f(glGetUniformLocation(blur, "direction"), 0.0f, 1.0f);
    glBindTexture(GL_TEXTURE_2D, other);
    drawInto({map}, kSize, kSize);
    const GLuint judge = client.program(snippet + kJudge);
    glUniform1f(glGetUniformLocation(judge, "split"), splits[1]);
    glBindTexture(GL_TEXTURE_2D, map);
    drawInto({answer}, kSize, kSize);
    const std::vector<float> visibilities = readTarget(0, kSize, kSize);

    double squared = 0.0;
    for (int i = 0; i < kSize * kSize; ++i)
    {
        const float truth = plainFiltering(i % kSize, i / kSize);
        const double error = static_cast<double>(visibilities[4 * static_cast<std::size_t>(i)] - truth);
        squared += error * error;
    }
    const double grey = 255.0 * std::sqrt(squared / (kSize * kSize));
    std::printf("the README's quick start errs %.2f grey levels of 255, with the split at %.3f\n", grey,
                static_cast<double>(splits[1]));
    return grey <= 2.55 ? 0 : 1; // a hundredth of white: a right picture
}

int runFunctions(const Client& client, const std::string& folder)
{
    const nlohmann::json rows = nlohmann::json::parse(readFile(folder + "/rows.json"));
    for (const nlohmann::json& row : rows)
        runRow(client, row, folder);
    return 0;
}

} // namespace

int main(int argc, char** argv)
try
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() != 4)
        throw std::runtime_error("usage: lvsm_client_opengl functions|quick_start VERSION LIBRARY FOLDER|README");
    const Client client(words[1], words[2]);
    const auto context = GlContext::open(client.api());
    if (!context)
    {
        std::printf("skipped: %s\n", context.error().c_str());
        return 77;
    }
    std::printf("%s, #version %s\n", context->name().c_str(), words[1].c_str());
    if (words[0] == "functions")
        std::ofstream(words[3] + "/version") << context->name();
    GLuint vertices = 0;
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
    const int status = words[0] == "quick_start" ? quickStart(client, words[3]) : runFunctions(client, words[3]);
    const std::string errors = glErrors();
    if (!errors.empty())
        throw std::runtime_error(errors);
    return status;
}
catch (const std::exception& error)
{
    std::fprintf(stderr, "lvsm_client_opengl: %s\n", error.what());
    return 1;
}
