#ifndef LVSM_GALLERY_PAGE_HPP
#define LVSM_GALLERY_PAGE_HPP

#include <string>
#include <vector>

#include "measure.hpp"
#include "techniques.hpp"

namespace lvsm::gallery
{

/// One technique's pictures and figures; the pictures are named relative to the page.
struct Row
{
    const Technique* technique = nullptr;
    /// Of what the camera sees, of every surface along the light's rays, and of those that another hides from it.
    Figures figures;
    Figures everywhere;
    Figures hidden;
    std::string shaded;
    std::string errors;
    /// Empty for techniques of one layer.
    std::string layers;
    std::vector<float> splits;
};

/// The light as it moves: one frame of it.
struct Frame
{
    /// Of the light about the vertical, in radians.
    float angle;
    /// Shaded by the four layers that the device relaxed for it.
    std::string shaded;
    /// As the device relaxes them, and how far from the host's those and the optimal ones lie, in depth.
    std::vector<float> splits;
    float relaxedDifference;
    float optimalDifference;
    /// Whether the optimal ones are as good as the host's, to a float's precision.
    bool optimalIsAsGood;
};

/// How many receivers the depth peels of a light have, and how many of them lie behind another surface.
struct PeelCounts
{
    int peels = 0;
    std::size_t receivers = 0;
    std::size_t hidden = 0;
};

struct Section
{
    const Scene* scene;
    Light light;
    std::string exact;
    std::vector<Row> rows;
    PeelCounts peels = {};
    /// Shares of the shadow map's texels over depth; empty where it is not known.
    std::vector<double> histogram = {};
    /// Empty for a light that does not move.
    std::vector<Frame> frames = {};
};

/// The histogram of a map's depths in [0,1]; texels at 1 are background and left out.
std::vector<double> depthHistogram(const std::vector<float>& depths);

/// What one automatic comparison of the figures said.
struct Verdict
{
    bool holds;
    std::string sentence;
    /// Whether the gallery fails where it does not hold; else it is a finding.
    bool isRequired = true;
};

struct Setup
{
    std::string device;
    int mapSize;
};

std::string pageText(const std::vector<Section>& sections, const std::vector<Verdict>& verdicts, const Setup& setup);
std::string reportText(const std::vector<Section>& sections);

/// Whether bleeding is large in VSM and gone in LVSM-4 and EVSM4 where the bench shields the ground, what share of VSM's
/// error four placed layers leave, whose error is the least, of what the camera sees and of every surface, whether the
/// device's splits follow the host's, and what placing them in view space is worth.
std::vector<Verdict> judge(const std::vector<Section>& sections);

} // namespace lvsm::gallery

#endif
