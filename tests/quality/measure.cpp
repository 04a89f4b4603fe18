#include "measure.hpp"

#include <algorithm>
#include <cmath>

#include <lvsm/receiver.hpp>

#include "filter.hpp"

namespace lvsm::quality
{
namespace
{

constexpr std::size_t kChoiceReceivers = 3000; // the best setting is chosen on about as many, evenly spread
constexpr std::size_t kMostChannels = 64;
constexpr int kRoundings = 3; // storing, and two passes of the filter

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

Image storedImage(const Technique& technique, const Estimator& estimator, const Map& map)
{
    Image image(map.peel.size(), technique.channels);
    for (int y = 0; y < image.size(); ++y)
    {
        for (int x = 0; x < image.size(); ++x)
        {
            float* texel = image.texel(x, y);
            estimator.store(map.peel.nearest(x, y), texel);
            for (int c = 0; c < technique.channels; ++c)
                texel[c] = stored(texel[c], technique.format);
        }
    }
    if (technique.bits > 0)
        blur(image, map.kernel, technique.format);
    return image;
}

} // namespace

const std::vector<Setting>& allSettings()
{
    static const std::vector<Setting> settings = []
    {
        std::vector<Setting> all;
        for (const float shift : {0.0f, 0.15f, 0.3f, 0.6f, 1.0f, 3.0f})
        {
            for (const float slopeFloor : {0.0f, 1.0f, 4.0f})
            {
                for (const float storedFloor : {0.003f, 0.03f, 0.3f, 3.0f, 10.0f})
                {
                    all.push_back({shift, slopeFloor, storedFloor});
                }
            }
        }
        return all;
    }();
    return settings;
}

Judge::Judge(const Technique& technique, const Scene& scene, const std::vector<Receiver>& receivers,
             const std::vector<double>& kernel)
    : m_technique(technique), m_scene(scene), m_receivers(receivers),
      m_kernel(technique.taps == 1 ? kernel : binomialKernel(static_cast<int>(kernel.size()) - 2)),
      m_deviation(static_cast<float>(deviationOf(m_kernel))),
      m_estimator(technique.prepare({scene.peel, m_kernel, m_deviation})),
      m_image(storedImage(technique, *m_estimator, {scene.peel, m_kernel, m_deviation}))
{
}

float Judge::atTexel(const Receiver& receiver, float depth, const Setting& setting, const float* texel) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float reach = 0.5f * std::sqrt(setting.slopeFloor) * m_deviation; // the floor is of 4 deviations^2
    return m_estimator->visibility({m_image, texel, receiver.x, receiver.y, depth, gradient,
                                    receiverMinVariance(0.0f, gradient, reach),
                                    setting.storedFloor * kRoundings * depthErrorOf(m_technique.format)});
}

float Judge::estimate(const Receiver& receiver, const Setting& setting) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float depth = shiftReceiver(receiver.surface.depth, gradient, setting.shift);
    if (m_technique.taps == 1)
        return atTexel(receiver, depth, setting, m_image.texel(receiver.x, receiver.y));

    std::array<float, kMostChannels> sample;
    float sum = 0.0f;
    for (const glm::ivec2 low : {glm::ivec2(-1, -1), glm::ivec2(0, -1), glm::ivec2(-1, 0), glm::ivec2(0, 0)})
    {
        const int x = receiver.x + low.x;
        const int y = receiver.y + low.y;
        for (int c = 0; c < m_technique.channels; ++c)
        {
            sample[static_cast<std::size_t>(c)] = 0.25f * (m_image.texel(x, y)[c] + m_image.texel(x + 1, y)[c] +
                                                           m_image.texel(x, y + 1)[c] + m_image.texel(x + 1, y + 1)[c]);
        }
        sum += atTexel(receiver, planeDepth(depth, gradient, glm::vec2(low) + 0.5f), setting, sample.data());
    }
    return 0.25f * sum;
}

double Judge::rmse(const Setting& setting, std::size_t stride) const
{
    Sum sum;
    for (std::size_t i = 0; i < m_receivers.size(); i += stride)
    {
        const Receiver& r = m_receivers[i];
        sum.add(static_cast<double>(r.surface.facing), static_cast<double>(estimate(r, setting) - r.visibility));
    }
    return sum.errors().rmse;
}

Setting Judge::bestSetting() const
{
    const std::size_t stride = std::max<std::size_t>(1, m_receivers.size() / kChoiceReceivers);
    Setting best = kPlainSetting;
    double least = rmse(best, stride);
    for (const Setting& setting : allSettings())
    {
        const Setting& first = allSettings().front();
        const bool otherFloor = setting.slopeFloor != first.slopeFloor || setting.storedFloor != first.storedFloor;
        if (otherFloor && !m_technique.floors)
            continue;
        const double error = rmse(setting, stride);
        if (error < least)
        {
            least = error;
            best = setting;
        }
    }
    return best;
}

Measurement Judge::measure() const
{
    Measurement result;
    result.technique = m_technique.name;
    result.peer = m_technique.peer;
    result.bits = m_technique.bits;
    result.taps = m_technique.taps;
    result.scene = m_scene.name;
    result.mesh = m_scene.mesh;
    result.setting = bestSetting();
    Sum all;
    Sum unweighted;
    Percentile percentile;
    std::array<Sum, kGroupNames.size()> groups;
    for (const Receiver& r : m_receivers)
    {
        const double error = static_cast<double>(estimate(r, result.setting) - r.visibility);
        const double weight = static_cast<double>(r.surface.facing);
        all.add(weight, error);
        unweighted.add(1.0, error);
        percentile.add(weight, error);
        groups[static_cast<std::size_t>(lightGroup(r))].add(weight, error);
        if (r.occluderDistance > 0.0f)
            groups[static_cast<std::size_t>(distanceGroup(r))].add(weight, error);
        groups[static_cast<std::size_t>(slopeGroup(r))].add(weight, error);
    }
    result.all = all.errors();
    result.unweighted = unweighted.errors();
    result.p99 = percentile.at(0.99);
    result.plainRmse = rmse(kPlainSetting, 1);
    std::transform(groups.begin(), groups.end(), result.groups.begin(), [](const Sum& sum) { return sum.errors(); });
    return result;
}

} // namespace lvsm::quality
