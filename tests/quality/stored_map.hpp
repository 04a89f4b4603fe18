// What a technique stores for a scene: at one of two resolutions, filtered for so many taps, and read anywhere.
#ifndef LVSM_TESTS_QUALITY_STORED_MAP_HPP
#define LVSM_TESTS_QUALITY_STORED_MAP_HPP

#include <array>
#include <map>
#include <memory>

#include "techniques.hpp"
#include "truth.hpp"

namespace lvsm::quality
{

/// A freedom that every technique has: n x n taps on a map that is filtered less, so that the window stays the same; and
/// half resolution, one texel for 2 x 2 of the filtered map. Read bilinearly, both weigh nearly as one tap does. What is
/// read from the nearest texel may also be decided at four texels and mixed.
struct Variant
{
    int tapsAcross = 1;
    bool half = false;
    bool decoded = false;

    std::string suffix() const;
};

/// Those that a window bears.
std::vector<Variant> variantsOf(const Technique& technique, const Window& window);

/// How each technique is treated for slope, rounding and bleeding.
struct Setting
{
    float shift;       ///< of the receiver towards the light, in |dz/dx| + |dz/dy|
    float slopeFloor;  ///< variance floor, in (|grad z| sigma)^2 for the filter's deviation sigma
    float storedFloor; ///< variance floor in what is stored in [0,1], in the format's rounding error after the filter
    float bias;        ///< times the bias against rounding
    float bleeding;    ///< what counts as no light
};

/// What the techniques do by themselves.
constexpr Setting kPlainSetting{0.0f, 0.0f, 1.0f, 1.0f, 0.0f};

/// Whether what is stored is rounded once, after a filter in one pass, or also before it and between two passes.
enum class Rounding
{
    Once,
    EachPass
};

/// The filtered maps of one technique in one scene, as its variants ask for them.
class MapMaker
{
public:
    MapMaker(const Technique& technique, const Scene& scene, const Window& window, Rounding rounding,
             const Footprint& footprint = {});

private:
    friend class StoredMap;
    Image make(const std::vector<double>& kernel, int level);
    /// For a map of that level, where the technique filters by itself.
    std::shared_ptr<const Estimator> estimator(int level, bool decoded);

    const Technique& m_technique;
    const Scene& m_scene;
    Window m_window;
    Rounding m_rounding;
    Footprint m_footprint;
    std::shared_ptr<const Estimator> m_estimator;
    std::map<std::pair<int, bool>, std::shared_ptr<const Estimator>> m_own; ///< by level, and whether read by decisions
    std::map<std::vector<double>, Image> m_blurred;                         ///< in fp32 where it is rounded once
};

/// One variant's map.
class StoredMap
{
public:
    StoredMap(MapMaker& maker, const Variant& variant);

    /// How often the map is sampled or a decision made along the footprint, which is stretched.
    int samples() const;

    /// The visibility before light bleeding reduction, unless the technique has its own.
    float estimate(const Receiver& receiver, const Setting& setting) const;

private:
    /// One decision at a place that is so far from the receiver's; for what is filtered by a look-up of so many samples.
    float tap(const Receiver& receiver, const Setting& setting, float depth, glm::vec2 away, int samples = 1) const;
    float at(glm::vec2 place, glm::ivec2 texel, const float* channels, const Receiver& receiver, const Setting& setting,
             float depth, int samples) const;
    /// Between the samples along the footprint, in texels of what is stored.
    glm::vec2 stride(const Receiver& receiver) const;

    const Technique& m_technique;
    Variant m_variant;
    Reading m_reading;
    Footprint m_footprint;
    int m_level;
    float m_scale; ///< texels of the shadow map over one of what is stored
    float m_roundings;
    float m_deviation; ///< in texels of the shadow map
    std::vector<double> m_taps;
    std::shared_ptr<const Estimator> m_estimator;
    Image m_image;
};

} // namespace lvsm::quality

#endif
