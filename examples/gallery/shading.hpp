#ifndef LVSM_GALLERY_SHADING_HPP
#define LVSM_GALLERY_SHADING_HPP

#include <memory>
#include <vector>

#include "maps.hpp"
#include "measure.hpp"
#include "raster.hpp"

namespace lvsm::gallery
{

/// The pipelines of one technique.
class TechniqueRunner
{
public:
    TechniqueRunner(const VulkanContext& gpu, const Technique& technique);

    /// Visibility and layer for each pixel of the camera's picture, layer -1 where the map does not reach.
    /// splits: the block that the placement left.
    std::vector<glm::vec2> run(const Light& light, const Buffer& lightBlock, const LightDepths& depths,
                               const Buffer& splits, const Surface& surface) const;

private:
    const VulkanContext& m_gpu;
    const Technique& m_technique;
    std::unique_ptr<MapMaker> m_maps;
    Kernel m_shade;
    vk::raii::Sampler m_sampler;
};

/// Brute force, by shaders/exact.comp.
class TruthFinder
{
public:
    explicit TruthFinder(const VulkanContext& gpu);

    Truth find(const Buffer& lightBlock, const LightDepths& depths, const Surface& surface, const Window& window) const;

private:
    const VulkanContext& m_gpu;
    Kernel m_exact;
    vk::raii::Sampler m_sampler;
};

} // namespace lvsm::gallery

#endif
