#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <lvsm/moments.hpp>

namespace lvsm::quality
{
namespace
{

// The settings are chosen on so many receivers of each light, and on fewer the more taps they have.
constexpr std::size_t kChoiceReceivers = 2400;
constexpr std::size_t kLeastReceivers = 150;
constexpr std::size_t kBleeding = 4; // member of a setting

class Sum
{
public:
    void add(double weight, double error)
    {
        m_weight += weight;
        m_squares += weight * error * error;
        m_bleed += weight * std::max(error, 0.0);
        m_dark += weight * std::max(-error, 0.0);
    }
    Errors errors() const
    {
        if (!(m_weight > 0.0))
            return {};
        return {m_weight, std::sqrt(m_squares / m_weight), m_bleed / m_weight, m_dark / m_weight};
    }

private:
    double m_weight = 0.0, m_squares = 0.0, m_bleed = 0.0, m_dark = 0.0;
};

class Percentile
{
public:
    void add(double weight, double error)
    {
        const double bin = std::min(std::abs(error), 1.0) * (kBins - 1);
        m_bins[static_cast<std::size_t>(bin + 0.5)] += weight;
        m_total += weight;
    }
    double at(double share) const
    {
        double below = 0.0;
        for (std::size_t i = 0; i < m_bins.size(); ++i)
        {
            below += m_bins[i];
            if (below >= share * m_total)
                return static_cast<double>(i) / (kBins - 1);
        }
        return 1.0;
    }

private:
    static constexpr int kBins = 4097;
    std::vector<double> m_bins = std::vector<double>(kBins);
    double m_total = 0.0;
};

Group lightGroup(const Receiver& r)
{
    return r.visibility >= 1.0f - 1e-6f ? Group::Lit : r.visibility > 1e-6f ? Group::Penumbra : Group::Shadow;
}

Group distanceGroup(const Receiver& r)
{
    return r.occluderDistance < 0.02f   ? Group::NearOccluder
           : r.occluderDistance < 0.15f ? Group::MiddleOccluder
                                        : Group::FarOccluder;
}

Group slopeGroup(const Receiver& r)
{
    const float slope = glm::length(r.surface.gradient);
    return slope < 0.001f ? Group::Flat : slope < 0.005f ? Group::Sloped : Group::Steep;
}

/// The errors of one variant in all lights for any setting, worked out when first asked for.
class Trials
{
public:
    Trials(const Technique& technique, const Variant& variant, const std::vector<StoredMap>& maps,
           const std::vector<LitScene>& lights)
        : m_technique(technique), m_settings(technique), m_maps(maps), m_lights(lights),
          m_most(std::max(kLeastReceivers,
                          kChoiceReceivers / static_cast<std::size_t>(variant.tapsAcross * variant.tapsAcross)))
    {
    }

    /// A setting with its squared errors in the other lights.
    struct Chosen
    {
        Setting setting;
        double cost;
    };

    /// The best for one light, by the others.
    Chosen best(std::size_t light)
    {
        return m_settings.best(Settings::kMembers,
                               [&](const Settings::Index& index) {
                                   return Chosen{m_settings.at(index), error(index, light)};
                               });
    }

private:
    double error(const Settings::Index& index, std::size_t leftOut)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < m_lights.size(); ++i)
        {
            if (i != leftOut || m_lights.size() == 1)
                sum += errorIn(index, i);
        }
        return sum;
    }

    /// Light bleeding is reduced afterwards, for all amounts at once, where it is not part of the estimate.
    double errorIn(Settings::Index index, std::size_t light)
    {
        const std::size_t amount = index[kBleeding];
        if (!m_technique.contact)
            index[kBleeding] = 0;
        const auto [found, isNew] = m_errors.try_emplace({index, light});
        if (isNew)
            found->second = errorsIn(index, light);
        return found->second[m_technique.contact ? 0 : amount];
    }

    std::vector<double> errorsIn(const Settings::Index& index, std::size_t light)
    {
        const std::vector<Receiver>& receivers = m_lights[light].receivers;
        const Setting setting = m_settings.at(index);
        std::vector<Sum> sums(m_technique.contact ? 1 : m_settings.count(kBleeding));
        for (std::size_t i = 0; i < std::min(receivers.size(), m_most); ++i)
        {
            const Receiver& r = receivers[i];
            const float estimate = m_maps[light].estimate(r, setting);
            for (std::size_t amount = 0; amount < sums.size(); ++amount)
            {
                Settings::Index other = index;
                other[kBleeding] = amount;
                const float reduced =
                    m_technique.contact ? estimate : reduceLightBleeding(estimate, m_settings.at(other).bleeding);
                sums[amount].add(static_cast<double>(r.surface.facing), static_cast<double>(reduced - r.visibility));
            }
        }
        std::vector<double> errors;
        for (const Sum& sum : sums)
            errors.push_back(sum.errors().rmse * sum.errors().rmse);
        return errors;
    }

    const Technique& m_technique;
    Settings m_settings;
    const std::vector<StoredMap>& m_maps;
    const std::vector<LitScene>& m_lights;
    std::size_t m_most;
    std::map<std::pair<Settings::Index, std::size_t>, std::vector<double>> m_errors;
};

double calmOf(const StoredMap& map, const Technique& technique, const std::vector<Receiver>& pairs,
              const Setting& setting)
{
    Sum sum;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
    {
        const auto errorAt = [&](const Receiver& r)
        {
            return static_cast<double>(estimateOf(map, technique, r, setting) - r.visibility);
        };
        sum.add(static_cast<double>(pairs[i].surface.facing), errorAt(pairs[i + 1]) - errorAt(pairs[i]));
    }
    return sum.errors().rmse;
}

/// best: the setting that is chosen.
void addErrors(const StoredMap& map, const Technique& technique, const LitScene& light, const Setting& best,
               Measurement& result)
{
    result.setting = technique.own ? plainSetting(technique) : best;
    Sum all, unweighted, plain, chosen;
    Percentile percentile;
    std::array<Sum, kGroupNames.size()> groups;
    for (const Receiver& r : light.receivers)
    {
        const double error = static_cast<double>(estimateOf(map, technique, r, result.setting) - r.visibility);
        const double weight = static_cast<double>(r.surface.facing);
        all.add(weight, error);
        unweighted.add(1.0, error);
        plain.add(weight, static_cast<double>(estimateOf(map, technique, r, plainSetting(technique)) - r.visibility));
        if (technique.own)
            chosen.add(weight, static_cast<double>(estimateOf(map, technique, r, best) - r.visibility));
        percentile.add(weight, error);
        groups[static_cast<std::size_t>(lightGroup(r))].add(weight, error);
        if (r.occluderDistance > 0.0f)
            groups[static_cast<std::size_t>(distanceGroup(r))].add(weight, error);
        groups[static_cast<std::size_t>(slopeGroup(r))].add(weight, error);
    }
    result.all = all.errors();
    result.unweighted = unweighted.errors();
    result.p99 = percentile.at(0.99);
    result.plainRmse = plain.errors().rmse;
    result.chosenRmse = (technique.own ? chosen : all).errors().rmse;
    std::transform(groups.begin(), groups.end(), result.groups.begin(), [](const Sum& sum) { return sum.errors(); });
    result.calm = calmOf(map, technique, light.pairs, result.setting);
}

} // namespace

Settings::Settings(const Technique& technique)
{
    m_values[0] = {0.0f, 0.15f, 0.3f, 0.6f, 1.0f, 3.0f};
    if (technique.own)
        m_values[0].insert(m_values[0].begin(), technique.own->shift);
    m_values[1] = technique.floors ? std::vector<float>{0.0f, 1.0f, 4.0f} : std::vector<float>{0.0f};
    m_values[2] =
        technique.floors ? std::vector<float>{0.003f, 0.03f, 0.3f, 1.0f, 3.0f, 10.0f, 30.0f} : std::vector<float>{1.0f};
    m_values[3] = technique.bias ? std::vector<float>{0.25f, 0.5f, 1.0f, 2.0f, 4.0f} : std::vector<float>{1.0f};
    m_values[4] = {0.0f, 0.05f, 0.1f, 0.15f, 0.2f, 0.3f};
}

Setting Settings::at(const Index& index) const
{
    return {m_values[0][index[0]], m_values[1][index[1]], m_values[2][index[2]], m_values[3][index[3]],
            m_values[4][index[4]]};
}

Settings::Index Settings::plain() const
{
    const auto one = [&](std::size_t member)
    {
        const std::vector<float>& values = m_values[member];
        return static_cast<std::size_t>(std::find(values.begin(), values.end(), 1.0f) - values.begin());
    };
    return {0, 0, one(2), one(3), 0};
}

Setting plainSetting(const Technique& technique)
{
    Setting setting = kPlainSetting;
    if (technique.own)
        setting.shift = technique.own->shift;
    return setting;
}

float estimateOf(const StoredMap& map, const Technique& technique, const Receiver& receiver, const Setting& setting)
{
    const float visibility = map.estimate(receiver, setting);
    return technique.contact ? visibility : reduceLightBleeding(visibility, setting.bleeding);
}

namespace
{

std::vector<MapMaker> makersOf(const Technique& technique, const std::vector<LitScene>& lights, const Terms& terms)
{
    std::vector<MapMaker> makers;
    for (const LitScene& light : lights)
        makers.emplace_back(technique, light.scene, terms.window, terms.rounding, terms.footprint);
    return makers;
}

/// For each light the warp that is best in the others, judged once at full resolution.
std::vector<std::size_t> bestWarps(const Technique& technique, const std::vector<LitScene>& lights, const Terms& terms)
{
    std::vector<std::size_t> best(lights.size());
    std::vector<double> least(lights.size(), std::numeric_limits<double>::infinity());
    for (std::size_t warp = 0; warp < technique.warps.size(); ++warp)
    {
        Technique warped = technique;
        warped.prepare = technique.warps[warp];
        std::vector<StoredMap> maps;
        for (MapMaker& maker : makersOf(warped, lights, terms))
            maps.emplace_back(maker, Variant{});
        Trials trials(warped, {}, maps, lights);
        for (std::size_t i = 0; i < lights.size(); ++i)
        {
            const double error = lights[i].isReported ? trials.best(i).cost : 0.0;
            if (error < least[i])
            {
                least[i] = error;
                best[i] = warp;
            }
        }
    }
    return best;
}

/// In the lights that are wanted.
std::vector<Measurement> measureIn(const Technique& technique, const std::vector<LitScene>& lights,
                                   const std::vector<bool>& wanted, const Terms& terms, const Shown& shown)
{
    std::vector<MapMaker> makers = makersOf(technique, lights, terms);
    std::vector<Measurement> results;
    for (const Variant& variant : terms.variants ? variantsOf(technique, terms.window) : std::vector<Variant>(1))
    {
        std::vector<StoredMap> maps;
        for (MapMaker& maker : makers)
            maps.emplace_back(maker, variant);
        Trials trials(technique, variant, maps, lights);
        for (std::size_t i = 0; i < lights.size(); ++i)
        {
            if (!wanted[i])
                continue;
            Measurement result;
            result.technique = technique.name + variant.suffix();
            result.peer = technique.peer;
            result.bits = technique.bits;
            result.reading = variant.decoded ? Reading::Decoded : technique.reading;
            result.variant = variant;
            result.window = terms.window;
            result.reads =
                technique.cut > 0.0 ? static_cast<int>(terms.window.cut(technique.cut).size()) : terms.window.width;
            result.footprint = terms.footprint;
            result.samples = maps[i].samples();
            result.estimate = technique.estimateBy(result.reading);
            result.scene = lights[i].scene.name;
            result.mesh = lights[i].scene.mesh;
            addErrors(maps[i], technique, lights[i], trials.best(i).setting, result);
            if (shown)
                shown(result, maps[i], lights[i]);
            results.push_back(std::move(result));
        }
    }
    return results;
}

} // namespace

std::vector<Measurement> measure(const Technique& technique, const std::vector<LitScene>& lights, const Terms& terms,
                                 const Shown& shown)
{
    std::vector<bool> reported;
    for (const LitScene& light : lights)
        reported.push_back(light.isReported);
    if (technique.warps.empty())
        return measureIn(technique, lights, reported, terms, shown);

    const std::vector<std::size_t> best = bestWarps(technique, lights, terms);
    std::vector<Measurement> results;
    for (std::size_t warp = 0; warp < technique.warps.size(); ++warp)
    {
        std::vector<bool> wanted;
        for (std::size_t i = 0; i < lights.size(); ++i)
            wanted.push_back(reported[i] && best[i] == warp);
        if (std::find(wanted.begin(), wanted.end(), true) == wanted.end())
            continue;
        Technique warped = technique;
        warped.prepare = technique.warps[warp];
        const std::vector<Measurement> found = measureIn(warped, lights, wanted, terms, shown);
        results.insert(results.end(), found.begin(), found.end());
    }
    return results;
}

} // namespace lvsm::quality
