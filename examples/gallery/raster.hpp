#ifndef LVSM_GALLERY_RASTER_HPP
#define LVSM_GALLERY_RASTER_HPP

#include <string>
#include <vector>

#include "mesh.hpp"
#include "shaders.hpp"

namespace lvsm::gallery
{

/// The uniform block View of the raster shaders.
struct View
{
    glm::mat4 viewProjection;
    glm::vec4 eye;
};

/// Draws a mesh with a depth test into colour images of one size.
class RasterPass
{
public:
    /// `usesLight`: the fragment shader reads the light's block at binding 0.
    RasterPass(const VulkanContext& gpu, const std::string& fragmentShader, std::vector<vk::Format> formats,
               bool usesLight);

    /// Makes and fills one image for each format; `clear` is what a pixel without a surface holds, in all components.
    std::vector<Texture> draw(const Buffer& vertices, const View& view, const support::Shape& size, float clear,
                              const Buffer* light = nullptr) const;

private:
    const VulkanContext& m_gpu;
    std::vector<vk::Format> m_formats;
    support::Raster m_raster;
};

} // namespace lvsm::gallery

#endif
