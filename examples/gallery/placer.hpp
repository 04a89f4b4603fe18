#ifndef LVSM_GALLERY_PLACER_HPP
#define LVSM_GALLERY_PLACER_HPP

#include <optional>
#include <vector>

#include <lvsm/passes_place.hpp>

#include "light_depths.hpp"
#include "raster.hpp"
#include "scenes.hpp"
#include "techniques.hpp"

namespace lvsm::gallery
{

/// The largest distance between the device's splits and the host's, in depth.
struct Differences
{
    float relaxed;
    float optimal;
    /// Whether the host finds no splits that are better than the device's optimal ones by more than a float's precision.
    bool optimalIsAsGood;
};

/// Splits of layers on the device.
class Placer
{
public:
    explicit Placer(const VulkanContext& gpu);

    /// How many pixels of the camera's picture, size of it, read each texel of the light's map.
    Texture countSeen(const Buffer& lightBlock, const LightDepths& depths, const Surface& surface,
                      const support::Shape& size) const;

    /// The block that store and shading read, with its splits where the technique has them for this light. seen: of
    /// countSeen, for a technique that is placed in view.
    Buffer place(const Technique& technique, const Scene& scene, const Light& light, const LightDepths& depths,
                 const std::optional<Texture>& seen = {}) const;

    /// Both placements on the device, against lloydRelax and optimalSplits; throws where these refuse the map.
    Differences compareWithHost(int layerCount, const LightDepths& depths) const;

private:
    /// Runs one placement over all faces; the buffer is one of StoreBlock.
    void run(const PlacePass& pass, const LightDepths& depths, const Buffer& splits,
             const std::optional<Texture>& seen = {}) const;
    std::vector<float> placedBy(const PlacePass& pass, const LightDepths& depths) const;

    const VulkanContext& m_gpu;
    Kernel m_see;
    Kernel m_count;
    Kernel m_countSeen;
    Kernel m_place;
    vk::raii::Sampler m_sampler;
};

/// What a buffer of StoreBlock holds of splits.
std::vector<float> readSplits(const Buffer& storeBlock, int layerCount);

} // namespace lvsm::gallery

#endif
