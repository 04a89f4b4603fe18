// What placing the splits on the device has to give: the host's splits, for still images and while a light moves.
#ifndef LVSM_SAMPLING_PLACING_TRUTH_HPP
#define LVSM_SAMPLING_PLACING_TRUTH_HPP

#include "placing_images.hpp"

#include <string>
#include <vector>

namespace sampling
{

constexpr int kPlacedLayers = 8;
constexpr int kPlacedBins = 1024;

// Images placed one after the other, with the same histogram and the same buffer of splits.
struct Placing
{
    std::string name;
    int layerCount;
    bool isOptimal;
    bool isProjected;
    // Each goes on from the splits of the one before.
    bool isMoving;
    std::vector<Depths> images;

    // What the passes of an image are, all the same.
    lvsm::PlacePass pass() const;
};

std::vector<Placing> placings();
// Fewer, of each kind one, for clients whose devices are slow.
std::vector<Placing> fewPlacings();

// What the device keeps from image to image, as it is at first.
lvsm::StoreBlock placedBlock(int layerCount);
// Of a reversed depth buffer.
lvsm::DepthBlock placedDepths();

// splits: of StoreBlock, for each image. histogram: what is left of it by then.
bool comparePlacing(const Placing& placing, const std::vector<std::vector<float>>& splits,
                    const std::vector<std::uint32_t>& histogram);

} // namespace sampling

#endif
