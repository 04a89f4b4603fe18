#ifndef LVSM_GALLERY_RASTER_HPP
#define LVSM_GALLERY_RASTER_HPP

#include <array>
#include <string>
#include <vector>

#include "light.hpp"
#include "shaders.hpp"

namespace lvsm::gallery
{

/// The uniform block View of the raster shaders.
struct View
{
    glm::mat4 viewProjection;
    glm::vec4 eye;
};

constexpr std::size_t kSurfaceImages = 6;

/// What the camera sees, by the outputs of surface.frag.
struct Surface
{
    std::vector<Texture> images;

    const Texture& positions() const { return images[0]; }
    const Texture& shadingNormals() const { return images[1]; }
    const Texture& planeNormals() const { return images[2]; }
    const Texture& colours() const { return images[3]; }
    const Texture& alongX() const { return images[4]; }
    const Texture& alongY() const { return images[5]; }
};

/// The same on the host: a point to an entry.
using Points = std::array<std::vector<glm::vec4>, kSurfaceImages>;

Points readPoints(const VulkanContext& gpu, const Surface& surface);

/// Row by row, and nothing where the last row has no more of them.
Surface makeSurface(const VulkanContext& gpu, const Points& points, int width);

/// Draws a scene as the camera sees it.
class SurfacePass
{
public:
    explicit SurfacePass(const VulkanContext& gpu);

    Surface draw(const Buffer& vertices, const View& view, const support::Shape& size) const;

private:
    const VulkanContext& m_gpu;
    support::Raster m_raster;
};

/// Draws all that lies along the rays of a light's map, one surface behind the other.
class PeelPass
{
public:
    explicit PeelPass(const VulkanContext& gpu);

    /// Points on what faces the light, at an even grid of a quarter as many rays as the map has, each list behind the
    /// one before. Empty where nothing of a peel faces it.
    std::vector<Points> draw(const Buffer& vertices, const Light& light) const;

private:
    void drawFace(const Buffer& vertices, const Light& light, int face, std::vector<Points>& peels) const;

    const VulkanContext& m_gpu;
    support::Raster m_raster;
    vk::raii::Sampler m_sampler;
};

/// Draws a scene as a light sees it: its depth buffer, a slice to a face.
class ShadowPass
{
public:
    explicit ShadowPass(const VulkanContext& gpu);

    Texture draw(const Buffer& vertices, const Light& light) const;

private:
    const VulkanContext& m_gpu;
    support::Raster m_raster;
};

} // namespace lvsm::gallery

#endif
