#ifndef LVSM_GALLERY_MAPS_HPP
#define LVSM_GALLERY_MAPS_HPP

#include <memory>
#include <optional>

#include "light_depths.hpp"
#include "techniques.hpp"

namespace lvsm::gallery
{

/// What a technique's wrapper reads.
struct Maps
{
    Texture map;
    /// Of Making::BlurredBeside and BlurredWithGreatest.
    std::optional<Texture> unfiltered{};
    /// Of the latter alone.
    std::optional<Texture> greatest{};
};

/// The passes of one technique.
class MapMaker
{
public:
    virtual ~MapMaker() = default;
    /// splits: the buffer of StoreBlock, with its splits placed.
    virtual Maps make(const LightDepths& depths, const Buffer& splits) const = 0;
};

std::unique_ptr<MapMaker> makeMapMaker(const VulkanContext& gpu, const Technique& technique);

/// Of Making::Mixed.
std::unique_ptr<MapMaker> makeMixtureMaker(const VulkanContext& gpu, const Technique& technique);

} // namespace lvsm::gallery

#endif
