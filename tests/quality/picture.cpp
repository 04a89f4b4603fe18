#include "picture.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>

#include <stb_image_write.h>

namespace lvsm::quality
{
namespace
{

using Colour = glm::vec3;

constexpr float kFullColour = 0.5f;

} // namespace

// The ends and the middle of ColorBrewer's PuOr, which the colour-blind can tell apart.
glm::vec3 errorColour(float error)
{
    const Colour middle(0.97f);
    const Colour light(0.70f, 0.35f, 0.02f);
    const Colour dark(0.18f, 0.10f, 0.55f);
    const float amount = std::min(std::abs(error) / kFullColour, 1.0f);
    return glm::mix(middle, error > 0.0f ? light : dark, std::sqrt(amount));
}

std::optional<std::string> writePng(const std::string& path, const std::vector<glm::vec3>& colours, int width)
{
    std::vector<std::uint8_t> bytes;
    for (const Colour& colour : colours)
    {
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<std::uint8_t>(255.0f * glm::clamp(colour[c], 0.0f, 1.0f) + 0.5f));
    }
    std::error_code error;
    const std::filesystem::path target(path);
    if (target.has_parent_path())
        std::filesystem::create_directories(target.parent_path(), error);
    const int height = static_cast<int>(colours.size()) / width;
    if (stbi_write_png(path.c_str(), width, height, 3, bytes.data(), 3 * width) == 0)
    {
        return "cannot write '" + path + "'";
    }
    return std::nullopt;
}

std::optional<std::string> writePicture(const StoredMap& map, const Technique& technique, const Setting& setting,
                                        const LitScene& light, const std::string& path)
{
    const Scene& scene = light.scene;
    const int size = scene.peel.size();
    std::vector<float> worst(texelIndex(0, size, size));
    std::vector<float> shade(texelIndex(0, size, size));
    for (const Receiver& r : light.receivers)
    {
        const float error = estimateOf(map, technique, r, setting) - r.visibility;
        float& kept = worst[texelIndex(r.x, r.y, size)];
        if (std::abs(error) > std::abs(kept))
            kept = error;
        if (r.surface.depth <= scene.peel.nearest(r.x, r.y).depth)
        {
            shade[texelIndex(r.x, r.y, size)] = (0.1f + 0.9f * r.visibility) * r.surface.facing;
        }
    }

    std::vector<Colour> pixels(2 * texelIndex(0, size, size));
    for (int y = 0; y < size; ++y)
    {
        for (int x = 0; x < size; ++x)
        {
            const int row = size - 1 - y;
            pixels[texelIndex(x, row, 2 * size)] = Colour(std::sqrt(shade[texelIndex(x, y, size)]));
            pixels[texelIndex(size + x, row, 2 * size)] = errorColour(worst[texelIndex(x, y, size)]);
        }
    }
    return writePng(path, pixels, 2 * size);
}

} // namespace lvsm::quality
