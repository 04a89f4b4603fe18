#ifndef LVSM_TESTS_QUALITY_MEASURE_HPP
#define LVSM_TESTS_QUALITY_MEASURE_HPP

#include <array>
#include <string>
#include <vector>

#include "techniques.hpp"
#include "truth.hpp"

namespace lvsm::quality
{

/// How a technique treats slope and rounding. Each technique is given the best of allSettings in each scene.
struct Setting
{
    float shift;       ///< of the receiver towards the light, in |dz/dx| + |dz/dy|
    float slopeFloor;  ///< variance floor, in (|grad z| sigma)^2 for the filter's deviation sigma
    float storedFloor; ///< variance floor in what is stored in [0,1], in the format's rounding error after the filter
};

const std::vector<Setting>& allSettings();

/// No shift and no floor for slopes: what the techniques do by themselves.
constexpr Setting kPlainSetting{0.0f, 0.0f, 1.0f};

/// Errors of a set of receivers: estimate less truth.
struct Errors
{
    double weight = 0.0;
    double rmse = 0.0;
    double bleed = 0.0; ///< mean of what is too light
    double dark = 0.0;  ///< mean of what is too dark
};

/// The same receivers seen apart.
enum class Group
{
    Lit,
    Penumbra,
    Shadow,
    NearOccluder,
    MiddleOccluder,
    FarOccluder,
    Flat,
    Sloped,
    Steep
};
constexpr std::array<const char*, 9> kGroupNames{"lit", "penumbra", "shadow", "near", "middle",
                                                 "far", "flat",     "sloped", "steep"};

struct Measurement
{
    std::string technique;
    bool peer = false;
    int bits = 0;
    int taps = 1;
    std::string scene;
    bool mesh = false;
    Setting setting = kPlainSetting;
    Errors all; ///< weighted by n.l
    Errors unweighted;
    double p99 = 0.0;                              ///< 99th percentile of the size of the error, weighted by n.l
    double plainRmse = 0.0;                        ///< with kPlainSetting
    std::array<Errors, kGroupNames.size()> groups; ///< weighted by n.l
};

/// Estimates of one technique for every receiver of a scene.
class Judge
{
public:
    Judge(const Technique& technique, const Scene& scene, const std::vector<Receiver>& receivers,
          const std::vector<double>& kernel);

    float estimate(const Receiver& receiver, const Setting& setting) const;
    Setting bestSetting() const;
    Measurement measure() const;

private:
    double rmse(const Setting& setting, std::size_t stride) const;
    float atTexel(const Receiver& receiver, float depth, const Setting& setting, const float* texel) const;

    const Technique& m_technique;
    const Scene& m_scene;
    const std::vector<Receiver>& m_receivers;
    std::vector<double> m_kernel;
    float m_deviation;
    std::unique_ptr<Estimator> m_estimator;
    Image m_image;
};

} // namespace lvsm::quality

#endif
