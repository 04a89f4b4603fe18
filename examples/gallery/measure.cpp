#include "measure.hpp"

#include <algorithm>
#include <cmath>

namespace lvsm::gallery
{
namespace
{

constexpr float kNoLight = 1e-4f;

bool meets(const Box& box, glm::vec3 from, glm::vec3 direction)
{
    const glm::vec3 toLow = (box.low - from) / direction;
    const glm::vec3 toHigh = (box.high - from) / direction;
    const glm::vec3 enter = glm::min(toLow, toHigh);
    const glm::vec3 leave = glm::max(toLow, toHigh);
    const float first = std::max({enter.x, enter.y, enter.z, 0.0f});
    return first < std::min({leave.x, leave.y, leave.z});
}

} // namespace

std::vector<bool> shieldedGround(const Picture& picture, const Truth& truth, const Light& light, const Box& shield)
{
    std::vector<bool> shielded(picture.surface.size());
    for (std::size_t i = 0; i < shielded.size(); ++i)
    {
        const glm::vec3 position(picture.surface[i]);
        const bool onGround = picture.surface[i].w == static_cast<float>(Object::Ground);
        const bool inFullShadow = truth[i].z > 0.0f && truth[i].x < kNoLight;
        shielded[i] = onGround && inFullShadow && meets(shield, position, light.towards(position));
    }
    return shielded;
}

Figures measure(const std::vector<glm::vec2>& visibility, const Truth& truth, std::size_t begin, std::size_t end,
                const std::vector<bool>& shielded)
{
    double weights = 0.0;
    double squares = 0.0;
    double lighter = 0.0;
    double darker = 0.0;
    double behind = 0.0;
    std::size_t behindCount = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
        if (truth[i].z == 0.0f)
            continue;
        const double weight = static_cast<double>(truth[i].y);
        const double error = static_cast<double>(visibility[i].x) - static_cast<double>(truth[i].x);
        weights += weight;
        squares += weight * error * error;
        lighter += weight * std::max(error, 0.0);
        darker += weight * std::max(-error, 0.0);
        if (!shielded.empty() && shielded[i])
        {
            behind += static_cast<double>(visibility[i].x);
            ++behindCount;
        }
    }
    Figures figures;
    if (weights > 0.0)
        figures = {std::sqrt(squares / weights), lighter / weights, darker / weights, std::nullopt};
    if (behindCount > 0)
        figures.behindShield = behind / static_cast<double>(behindCount);
    return figures;
}

} // namespace lvsm::gallery
