#ifndef LVSM_GALLERY_RASTER_HPP
#define LVSM_GALLERY_RASTER_HPP

#include <string>
#include <vector>

#include "gpu.hpp"
#include "mesh.hpp"

namespace lvsm::gallery {

/// The push constants of the raster shaders.
struct View {
  glm::mat4 viewProjection;
  glm::vec3 eye;
};

/// Draws a mesh with a depth test into colour images of one size.
class RasterPass {
 public:
  /// `usesLight`: the fragment shader reads the light's block at binding 0.
  RasterPass(const VulkanContext& gpu, const std::string& fragmentShader, std::vector<vk::Format> formats,
             bool usesLight);

  /// Makes and fills one image for each format; `clear` is what a pixel without a surface holds, in all components.
  std::vector<Image> draw(const Buffer& vertices, const View& view, vk::Extent2D extent, float clear,
                          const Buffer* light = nullptr) const;

 private:
  const VulkanContext& gpu_;
  std::vector<vk::Format> formats_;
  vk::raii::RenderPass renderPass_;
  vk::raii::DescriptorSetLayout setLayout_;
  vk::raii::PipelineLayout layout_;
  vk::raii::Pipeline pipeline_;
};

Buffer uploadMesh(const VulkanContext& gpu, const Mesh& mesh);

}  // namespace lvsm::gallery

#endif
