// What a technique stores for a scene: at one of two resolutions, filtered for so many taps, and read anywhere.
#ifndef LVSM_TESTS_QUALITY_STORED_MAP_HPP
#define LVSM_TESTS_QUALITY_STORED_MAP_HPP

#include <array>
#include <map>

#include "techniques.hpp"
#include "truth.hpp"

namespace lvsm::quality
{

/// A freedom that every technique has: n x n taps on a map that is filtered less, so that the window stays the same; and
/// half resolution, one texel for 2 x 2 of the filtered map. Read bilinearly, both weigh nearly as one tap does.
struct Variant
{
    int tapsAcross = 1;
    bool half = false;

    std::string suffix() const;
};

/// Those that a window bears.
std::vector<Variant> variantsOf(const Technique& technique, int width);

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
    MapMaker(const Technique& technique, const Scene& scene, int width, Rounding rounding);

    const std::vector<double>& kernel() const { return m_kernel; }

private:
    friend class StoredMap;
    Image make(int blurWidth, bool half);

    const Technique& m_technique;
    const Scene& m_scene;
    std::vector<double> m_kernel;
    Rounding m_rounding;
    std::unique_ptr<Estimator> m_estimator;
    std::map<int, Image> m_blurred; ///< by width; in fp32 where it is rounded once
};

/// One variant's map.
class StoredMap
{
public:
    StoredMap(MapMaker& maker, const Variant& variant);

    /// The visibility before light bleeding reduction, unless the technique has its own.
    float estimate(const Receiver& receiver, const Setting& setting) const;

private:
    float tap(const Receiver& receiver, const Setting& setting, float depth, glm::vec2 away) const;
    float at(glm::vec2 place, glm::ivec2 texel, const float* channels, const Receiver& receiver, const Setting& setting,
             float depth) const;

    const Technique& m_technique;
    Variant m_variant;
    float m_scale; ///< texels of the shadow map over one of what is stored
    float m_roundings;
    float m_deviation; ///< in texels of the shadow map
    std::vector<double> m_taps;
    const Estimator& m_estimator;
    Image m_image;
};

} // namespace lvsm::quality

#endif
