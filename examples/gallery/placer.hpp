#ifndef LVSM_GALLERY_PLACER_HPP
#define LVSM_GALLERY_PLACER_HPP

#include <vector>

#include <lvsm/passes_place.hpp>

#include "light_depths.hpp"
#include "scenes.hpp"
#include "techniques.hpp"

namespace lvsm::gallery
{

/// What the placement is asked for, on the host as on the device.
RelaxOptions<float> relaxing();

/// Splits of layers on the device.
class Placer
{
public:
    explicit Placer(const VulkanContext& gpu);

    /// The block that store and shading read, with its splits where the technique has them for this light.
    Buffer place(const Technique& technique, const Scene& scene, const Light& light, const LightDepths& depths) const;

    /// Runs one placement over all faces; the buffer is one of StoreBlock.
    void run(const PlacePass& pass, const LightDepths& depths, const Buffer& splits) const;

private:
    const VulkanContext& m_gpu;
    Kernel m_count;
    Kernel m_place;
    vk::raii::Sampler m_sampler;
};

/// What a buffer of StoreBlock holds of splits.
std::vector<float> readSplits(const Buffer& storeBlock, int layerCount);

} // namespace lvsm::gallery

#endif
