#include "esm_map.hpp"

#include <algorithm>
#include <cmath>

#include <lvsm/esm.hpp>

#include "filter.hpp"

namespace lvsm::papers
{
namespace
{

float texelAt(const Image& image, int x, int y)
{
    const int last = image.size() - 1;
    return image.texel(std::clamp(x, 0, last), std::clamp(y, 0, last))[0];
}

Image termsOf(const Image& depths)
{
    Image terms(depths.size(), 1);
    for (int y = 0; y < depths.size(); ++y)
    {
        for (int x = 0; x < depths.size(); ++x)
            *terms.texel(x, y) = occluderTerm(*depths.texel(x, y), EsmMap::kExponent);
    }
    return terms;
}

} // namespace

Image depthImage(const quality::Scene& scene)
{
    Image depths(scene.peel.size(), 1);
    for (int y = 0; y < depths.size(); ++y)
    {
        for (int x = 0; x < depths.size(); ++x)
            *depths.texel(x, y) = scene.peel.nearest(x, y).depth;
    }
    return depths;
}

float bilinear(const Image& image, glm::vec2 place)
{
    const glm::ivec2 low(glm::floor(place));
    const glm::vec2 f = place - glm::vec2(low);
    return glm::mix(glm::mix(texelAt(image, low.x, low.y), texelAt(image, low.x + 1, low.y), f.x),
                    glm::mix(texelAt(image, low.x, low.y + 1), texelAt(image, low.x + 1, low.y + 1), f.x), f.y);
}

Mips::Mips(Image base) : m_levels{std::move(base)}
{
    while (m_levels.back().size() > 1)
        m_levels.push_back(quality::halved(m_levels.back()));
}

float Mips::sample(glm::vec2 place, float level) const
{
    const float last = static_cast<float>(m_levels.size() - 1);
    const float at = std::clamp(level, 0.0f, last);
    const auto in = [&](float whole)
    {
        const float scale = std::exp2(whole);
        return bilinear(m_levels[static_cast<std::size_t>(whole)], (place + 0.5f) / scale - 0.5f);
    };
    const float low = std::floor(at);
    return glm::mix(in(low), in(std::min(low + 1.0f, last)), at - low);
}

EsmMap::EsmMap(const quality::Scene& scene, int width)
    : m_depths(depthImage(scene)), m_terms(termsOf(m_depths)), m_filtered(m_terms), m_radius(width / 2)
{
    if (width > 1)
        blur(m_filtered, quality::binomialKernel(width), quality::Format::Fp32);
}

float EsmMap::occluder(const Receiver& receiver) const
{
    return bilinear(m_filtered, placeOf(receiver));
}

float EsmMap::greatest(const Receiver& receiver) const
{
    const glm::ivec2 low(glm::floor(placeOf(receiver)));
    float greatest = 0.0f;
    for (int y = low.y - m_radius; y <= low.y + 1 + m_radius; ++y)
    {
        for (int x = low.x - m_radius; x <= low.x + 1 + m_radius; ++x)
            greatest = std::max(greatest, texelAt(m_depths, x, y));
    }
    return greatest;
}

float EsmMap::visibility(const Receiver& receiver) const
{
    return exponentialShadow(occluder(receiver), receiver.depth(), kExponent);
}

float EsmMap::fallback(const Receiver& receiver) const
{
    const glm::vec2 place = placeOf(receiver);
    const glm::ivec2 low(glm::floor(place));
    const glm::vec4 four(texelAt(m_terms, low.x, low.y), texelAt(m_terms, low.x + 1, low.y),
                         texelAt(m_terms, low.x, low.y + 1), texelAt(m_terms, low.x + 1, low.y + 1));
    return exponentialShadow2x2(four, place - glm::vec2(low), receiver.depth(), kExponent);
}

} // namespace lvsm::papers
