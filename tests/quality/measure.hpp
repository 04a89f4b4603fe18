#ifndef LVSM_TESTS_QUALITY_MEASURE_HPP
#define LVSM_TESTS_QUALITY_MEASURE_HPP

#include <array>
#include <string>
#include <vector>

#include "stored_map.hpp"

namespace lvsm::quality
{

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
    std::string technique; ///< with its variant
    bool peer = false;
    int bits = 0; ///< a texel of what is stored
    Reading reading = Reading::Bilinear;
    Variant variant;
    int width = 0;
    std::string estimate; ///< of one tap, in tests/cost/estimates.def
    std::string scene;
    bool mesh = false;
    Setting setting = kPlainSetting; ///< chosen in other lights or of another seed
    Errors all;                      ///< weighted by n.l
    Errors unweighted;
    double p99 = 0.0;                              ///< 99th percentile of the size of the error, weighted by n.l
    double plainRmse = 0.0;                        ///< with kPlainSetting
    double calm = 0.0;                             ///< RMSE of the difference between neighbours on one surface
    std::array<Errors, kGroupNames.size()> groups; ///< weighted by n.l

    /// Of a texel of the shadow map: half resolution has a texel for four of them.
    double texelBits() const { return variant.half ? 0.25 * bits : bits; }
    int taps() const { return variant.tapsAcross * variant.tapsAcross; }
    /// How often the estimate is made for one receiver.
    int decisions() const { return taps() * (reading == Reading::Decoded ? 4 : 1); }
    /// Its row in tests/cost/estimates.def, where it has one.
    std::string estimateName() const
    {
        return estimate == "PCF whole window" ? estimate + " " + std::to_string(width) : estimate;
    }
};

/// One light of a world, or one seed of a scene, with its receivers.
struct LitScene
{
    Scene scene;
    bool isReported;
    std::vector<Receiver> receivers;
    std::vector<Receiver> pairs; ///< of neighboursOf
};

/// Errors of one technique, in all its variants or with one tap alone, in each light that is reported. The setting of each light is the best
/// in the other lights together; a light that is alone is judged with its own best. shown is called with each of them.
using Shown = std::function<void(const Measurement&, const StoredMap&, const LitScene&)>;
std::vector<Measurement> measure(const Technique& technique, const std::vector<LitScene>& lights, int width,
                                 Rounding rounding, bool variants = true, const Shown& shown = {});

/// Settings in the order in which they are tried: one member after the other, twice.
class Settings
{
public:
    explicit Settings(const Technique& technique);

    using Index = std::array<std::size_t, 5>;
    Setting at(const Index& index) const;
    Index plain() const;
    /// How many values a member has.
    std::size_t count(std::size_t member) const { return m_values[member].size(); }

private:
    std::array<std::vector<float>, 5> m_values;
};

/// The estimate that counts: with light bleeding reduced.
float estimateOf(const StoredMap& map, const Technique& technique, const Receiver& receiver, const Setting& setting);

} // namespace lvsm::quality

#endif
