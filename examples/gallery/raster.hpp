#ifndef LVSM_GALLERY_RASTER_HPP
#define LVSM_GALLERY_RASTER_HPP

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
