// A step of the relaxation by its definition, on numbers of double and every neighbourhood apart.
#ifndef LVSM_SAMPLING_STEPS_TRUTH_HPP
#define LVSM_SAMPLING_STEPS_TRUTH_HPP

#include "placing_images.hpp"

namespace sampling
{

constexpr int kMaxLayers = 8;
const int kStateWidth = lvsm::placeStateWidth(kMaxLayers);

// A row of the state and the next, as the device has them.
using State = std::vector<float>;

State startState(int layerCount);

// Draws a step on a device and gives the state after it.
using DrawStep = std::function<State(const lvsm::PlaceStep&, const Depths&)>;

struct Relaxed
{
    const Depths& image;
    int layerCount;
    bool inPairs;
    // Depths all over: the host moves whole bins of 1/1024 of them, and comes to rest a little before.
    bool isNoise;
    std::string name;
};

// Draws steps until no split moves, each of which is to be what the definition makes of the state before it. Where all
// splits move, these are the steps of lloydRelax, and they end where it does.
void compareSteps(const Relaxed& relaxed, const DrawStep& draw, Comparison& steps, Comparison& ends);

} // namespace sampling

#endif
