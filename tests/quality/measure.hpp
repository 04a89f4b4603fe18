#ifndef LVSM_TESTS_QUALITY_MEASURE_HPP
#define LVSM_TESTS_QUALITY_MEASURE_HPP

#include <array>
#include <cmath>
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
    Window window = {0};
    int reads = 0; ///< texels across the window that an estimate reads which reads them itself
    Footprint footprint;
    int samples = 1;      ///< along a footprint that is stretched
    std::string estimate; ///< of one tap, in tests/cost/estimates.def
    std::string scene;
    bool mesh = false;
    Setting setting = kPlainSetting; ///< chosen in other lights or of another seed, but for what filters by itself
    Errors all;                      ///< weighted by n.l
    Errors unweighted;
    double p99 = 0.0;                              ///< 99th percentile of the size of the error, weighted by n.l
    double plainRmse = 0.0;                        ///< with what the technique does by itself
    double chosenRmse = 0.0;                       ///< with the setting that is chosen
    double calm = 0.0;                             ///< RMSE of the difference between neighbours on one surface
    std::array<Errors, kGroupNames.size()> groups; ///< weighted by n.l

    /// Of a texel of the shadow map: half resolution has a texel for four of them.
    double texelBits() const { return variant.half ? 0.25 * bits : bits; }
    int taps() const { return variant.tapsAcross * variant.tapsAcross; }
    /// Gathers of 2 x 2 depths that PCF of the whole window takes, footprint included.
    int gathers() const
    {
        const float across = footprint.minified() ? std::ceil(footprint.across()) : 1.0f;
        return (reads + footprint.length) / 2 * ((reads + static_cast<int>(across)) / 2);
    }
    /// How often the estimate is made for one receiver. PCF over a footprint is as many of 15 x 15 as it gathers.
    double decisions() const
    {
        constexpr double kGathers15 = 64.0;
        if (estimate == "PCF whole window" && footprint.minified())
            return gathers() / kGathers15;
        const int times = reading == Reading::Decoded ? 4 : 1;
        return taps() * times * (reading == Reading::Bilinear || reading == Reading::Window ? 1 : samples);
    }
    /// Its row in tests/cost/estimates.def, where it has one.
    std::string estimateName() const
    {
        if (estimate == "PCF whole window" && footprint.minified())
            return estimate + " 15";
        return estimate == "PCF whole window" ? estimate + " " + std::to_string(reads) : estimate;
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

/// What everybody is measured with.
struct Terms
{
    Window window;
    Footprint footprint = {};
    Rounding rounding = Rounding::Once;
    bool variants = true; ///< all, not one tap at full resolution alone
};

/// Errors of one technique in its variants in each light that is reported. The setting of each light is the best in the
/// other lights together, a light that is alone is judged with its own best, and what filters by itself with what its
/// documents say. shown is called with each of them.
using Shown = std::function<void(const Measurement&, const StoredMap&, const LitScene&)>;
std::vector<Measurement> measure(const Technique& technique, const std::vector<LitScene>& lights, const Terms& terms,
                                 const Shown& shown = {});

/// What a technique does by itself.
Setting plainSetting(const Technique& technique);

/// Settings in the order in which they are tried: one member after the other, twice.
class Settings
{
public:
    explicit Settings(const Technique& technique);

    static constexpr std::size_t kMembers = 5;
    using Index = std::array<std::size_t, kMembers>;
    Setting at(const Index& index) const;
    Index plain() const;
    /// How many values a member has.
    std::size_t count(std::size_t member) const { return m_values[member].size(); }

    /// What judge says of the settings that are tried, where its member cost is least. members: so many of the first are
    /// tried, and the rest stays as it is by itself.
    template <typename Judge>
    auto best(std::size_t members, Judge judge) const
    {
        Index index = plain();
        auto least = judge(index);
        for (int round = 0; round < kRounds; ++round)
        {
            for (std::size_t member = 0; member < members; ++member)
            {
                for (std::size_t value = 0; value < count(member); ++value)
                {
                    Index other = index;
                    other[member] = value;
                    auto found = judge(other);
                    if (found.cost < least.cost)
                    {
                        least = found;
                        index = other;
                    }
                }
            }
        }
        return least;
    }

private:
    static constexpr int kRounds = 2;
    std::array<std::vector<float>, kMembers> m_values;
};

/// The estimate that counts: with light bleeding reduced.
float estimateOf(const StoredMap& map, const Technique& technique, const Receiver& receiver, const Setting& setting);

} // namespace lvsm::quality

#endif
