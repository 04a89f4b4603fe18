#ifndef LVSM_GALLERY_TECHNIQUES_HPP
#define LVSM_GALLERY_TECHNIQUES_HPP

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "light.hpp"
#include "shaders.hpp"

namespace lvsm::gallery
{

/// The uniform block of shaders/technique.glsl.
struct TechniqueBlock
{
    glm::vec2 exponents{0.0f};
    float minVariance = 0.0f;
    float bias = 0.0f;
    float overlap = 0.0f;
    float transition = 0.0f;
    int layerCount = 1;
    float padding = 0.0f;
    std::array<glm::vec4, 9> splits{};
};

struct Technique
{
    std::string id;
    std::string title;
    /// One sentence for the reader of the page.
    std::string explanation;
    /// The storage format in words, and what it takes.
    std::string storage;
    int bits;
    vk::Format format;
    /// The same format as a GLSL layout qualifier.
    std::string qualifier;
    int texels;
    /// The shader that encodes and receives.
    std::string shader;
    bool filtered;
    int layerCount;
};

const std::vector<Technique>& techniques();

/// The splits that Lloyd relaxation places for a depth map; throws where it refuses the map.
std::vector<float> placeSplits(const std::vector<float>& depths, const support::Shape& size, int layerCount);

/// What the technique's shader needs for this light.
TechniqueBlock parameters(const Technique& technique, const Light& light, const std::vector<float>& splits);

/// The pipelines of one technique.
class TechniqueRunner
{
public:
    TechniqueRunner(const VulkanContext& gpu, const Technique& technique);

    /// Stores and blurs the depth map as the technique does and evaluates it for the camera's picture:
    /// visibility and layer for each pixel of `positions`, layer -1 where the map does not reach.
    std::vector<glm::vec2> run(const Buffer& light, const TechniqueBlock& block, const Texture& depthMap,
                               const Texture& positions) const;

private:
    const VulkanContext& m_gpu;
    const Technique& m_technique;
    Kernel m_encode;
    std::optional<Kernel> m_blur;
    Kernel m_receive;
    vk::raii::Sampler m_sampler;
};

} // namespace lvsm::gallery

#endif
