#ifndef LVSM_GALLERY_RASTER_HPP
#define LVSM_GALLERY_RASTER_HPP

#include <string>
#include <vector>

#include "gpu.hpp"
#include "mesh.hpp"

namespace lvsm::gallery
{

/// The push constants of the raster shaders.
struct View
{
    glm::mat4 viewProjection;
    glm::vec3 eye;
};

/// Draws a mesh with a depth test into colour images of one size.
class RasterPass
{
public:
    /// `usesLight`: the fragment shader reads the light's block at binding 0.
    RasterPass(const VulkanContext& gpu, const std::string& fragmentShader, std::vector<vk::Format> formats,
               bool usesLight);

    /// Makes and fills one image for each format; `clear` is what a pixel without a surface holds, in all components.
    std::vector<Image> draw(const Buffer& vertices, const View& view, vk::Extent2D extent, float clear,
                            const Buffer* light = nullptr) const;

private:
    const VulkanContext& m_gpu;
    std::vector<vk::Format> m_formats;
    vk::raii::RenderPass m_renderPass;
    vk::raii::DescriptorSetLayout m_setLayout;
    vk::raii::PipelineLayout m_layout;
    vk::raii::Pipeline m_pipeline;
};

Buffer uploadMesh(const VulkanContext& gpu, const Mesh& mesh);

} // namespace lvsm::gallery

#endif
