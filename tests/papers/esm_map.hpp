#ifndef LVSM_TESTS_PAPERS_ESM_MAP_HPP
#define LVSM_TESTS_PAPERS_ESM_MAP_HPP

#include "image.hpp"
#include "scenes.hpp"

namespace lvsm::papers
{

using quality::Image;

/// Depths of a scene's map, with depth 1 where there is nothing.
Image depthImage(const quality::Scene& scene);

/// A bilinear sample of the first channel; place: in texels, whole ones at their centres.
float bilinear(const Image& image, glm::vec2 place);

/// An image with its mip chain.
class Mips
{
public:
    explicit Mips(Image base);
    /// Trilinear, like a texture unit; place: in texels of the base.
    float sample(glm::vec2 place, float level) const;

private:
    std::vector<Image> m_levels;
};

/// An exponential shadow map under a binomial filter, with what classifies its failures and what the fallback reads.
class EsmMap
{
public:
    static constexpr float kExponent = 80.0f;

    /// width: of the filter; 1 for none.
    EsmMap(const quality::Scene& scene, int width);

    /// The filtered term where a receiver is.
    float occluder(const Receiver& receiver) const;
    /// The greatest depth of all texels that have a part in it.
    float greatest(const Receiver& receiver) const;
    float visibility(const Receiver& receiver) const;
    /// Of the four unfiltered texels around it.
    float fallback(const Receiver& receiver) const;
    /// Unfiltered.
    const Image& terms() const { return m_terms; }

private:
    Image m_depths, m_terms, m_filtered;
    int m_radius;
};

/// Where a receiver is, in texels.
inline glm::vec2 placeOf(const Receiver& r)
{
    return glm::vec2(r.x, r.y) + r.offset;
}

} // namespace lvsm::papers

#endif
