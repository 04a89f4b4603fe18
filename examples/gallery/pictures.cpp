#include "pictures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <stb_image_write.h>

namespace lvsm::gallery
{
namespace
{

// What lights a scene beside its light, in linear colours.
struct Ambience
{
    glm::vec3 background;
    glm::vec3 fromSky;
    glm::vec3 fromGround;
    glm::vec3 fromCamera;
    glm::vec3 light;
};
constexpr Ambience kDay{
    {0.70f, 0.76f, 0.82f}, {0.24f, 0.27f, 0.32f}, {0.14f, 0.13f, 0.12f}, {0.09f, 0.09f, 0.09f}, {1.08f, 1.02f, 0.92f}};
constexpr Ambience kStudio{{0.030f, 0.034f, 0.042f},
                           {0.13f, 0.14f, 0.17f},
                           {0.07f, 0.065f, 0.06f},
                           {0.06f, 0.06f, 0.06f},
                           {1.25f, 1.16f, 1.02f}};
constexpr glm::vec3 kCameraSide{0.45f, 0.25f, 0.86f};
constexpr float kHazeBegin = 9.0f;
constexpr float kHazeEnd = 32.0f;

constexpr glm::vec3 rgb(int hex)
{
    return {static_cast<float>(hex >> 16 & 255) / 255.0f, static_cast<float>(hex >> 8 & 255) / 255.0f,
            static_cast<float>(hex & 255) / 255.0f};
}

glm::vec3 toSrgb(glm::vec3 linear)
{
    const auto encode = [](float c)
    {
        c = std::clamp(c, 0.0f, 1.0f);
        return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
    };
    return {encode(linear.r), encode(linear.g), encode(linear.b)};
}

float haze(glm::vec4 surface)
{
    return glm::smoothstep(kHazeBegin, kHazeEnd, glm::length(glm::vec2(surface.x, surface.z)));
}

glm::vec3 ambient(const Ambience& ambience, glm::vec3 normal)
{
    return glm::mix(ambience.fromGround, ambience.fromSky, 0.5f + 0.5f * normal.y) +
           ambience.fromCamera * std::max(glm::dot(normal, kCameraSide), 0.0f);
}

// A quiet grey relief, so that colours laid over it can be placed in the scene.
float relief(const Picture& picture, std::size_t i)
{
    const glm::vec3 normal(picture.normal[i]);
    return 0.82f + 0.18f * glm::clamp(0.55f * normal.y + 0.45f * normal.z, 0.0f, 1.0f);
}

template <typename PixelColour>
void writePng(const std::string& path, const Picture& picture, const PixelColour& colourOf)
{
    const int width = picture.width / kSupersampling;
    const int height = picture.height / kSupersampling;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            glm::vec3 sum(0.0f);
            for (int sub = 0; sub < kSupersampling * kSupersampling; ++sub)
            {
                const int px = x * kSupersampling + sub % kSupersampling;
                const int py = y * kSupersampling + sub / kSupersampling;
                sum += colourOf(static_cast<std::size_t>(py) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(px));
            }
            sum *= 255.0f / (kSupersampling * kSupersampling);
            for (int c = 0; c < 3; ++c)
                bytes.push_back(static_cast<std::uint8_t>(sum[c] + 0.5f));
        }
    }
    if (stbi_write_png(path.c_str(), width, height, 3, bytes.data(), width * 3) == 0)
    {
        throw std::runtime_error("cannot write " + path);
    }
}

} // namespace

// Purple to orange (ColorBrewer PuOr): told apart with any common colour vision.
const std::array<glm::vec3, 5>& errorColours()
{
    static constexpr std::array colours{rgb(0x542788), rgb(0xB2A1D2), rgb(0xF5F5F4), rgb(0xFDB863), rgb(0xB35806)};
    return colours;
}

// The palette of Okabe and Ito, without black.
const std::array<glm::vec3, 8>& layerColours()
{
    static constexpr std::array colours{rgb(0xE69F00), rgb(0x56B4E9), rgb(0x009E73), rgb(0xF0E442),
                                        rgb(0x0072B2), rgb(0xD55E00), rgb(0xCC79A7), rgb(0x999999)};
    return colours;
}

void writeShaded(const std::string& path, const Picture& picture, const Truth& truth,
                 const std::vector<glm::vec2>& visibility, bool isSpot)
{
    const Ambience& ambience = isSpot ? kStudio : kDay;
    writePng(path, picture,
             [&](std::size_t i)
             {
                 const glm::vec4 surface = picture.surface[i];
                 if (surface.w == 0.0f)
                     return toSrgb(ambience.background);
                 const glm::vec3 direct = ambience.light * (truth[i].y * visibility[i].x);
                 const glm::vec3 shaded =
                     glm::vec3(picture.colour[i]) * (ambient(ambience, glm::vec3(picture.normal[i])) + direct);
                 return toSrgb(glm::mix(shaded, ambience.background, haze(surface)));
             });
}

void writeErrors(const std::string& path, const Picture& picture, const Truth& truth,
                 const std::vector<glm::vec2>& visibility)
{
    const auto& colours = errorColours();
    constexpr float kSteps = static_cast<float>(std::tuple_size_v<std::decay_t<decltype(colours)>> - 1);
    writePng(path, picture,
             [&](std::size_t i)
             {
                 if (picture.surface[i].w == 0.0f)
                     return colours[2];
                 const bool counts = truth[i].z > 0.0f && truth[i].y > 0.0f;
                 const float error = counts ? visibility[i].x - truth[i].x : 0.0f;
                 const float position = glm::clamp(0.5f + 0.5f * error / kErrorRange, 0.0f, 1.0f) * kSteps;
                 const float step = std::min(std::floor(position), kSteps - 1.0f);
                 const auto index = static_cast<std::size_t>(step);
                 return glm::mix(colours[index], colours[index + 1], position - step) * relief(picture, i);
             });
}

void writeLayers(const std::string& path, const Picture& picture, const Truth& truth,
                 const std::vector<glm::vec2>& visibility)
{
    writePng(path, picture,
             [&](std::size_t i)
             {
                 const float layer = visibility[i].y;
                 if (picture.surface[i].w == 0.0f || layer < 0.0f)
                     return rgb(0xE4E4E2);
                 const float lit = 0.55f + 0.45f * visibility[i].x * truth[i].y;
                 return layerColours()[static_cast<std::size_t>(layer)] * lit * relief(picture, i);
             });
}

} // namespace lvsm::gallery
