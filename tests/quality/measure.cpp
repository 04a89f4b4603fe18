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
        weight_ += weight;
        squares_ += weight * error * error;
        bleed_ += weight * std::max(error, 0.0);
        dark_ += weight * std::max(-error, 0.0);
    }
    Errors errors() const
    {
        if (!(weight_ > 0.0))
            return {};
        return {weight_, std::sqrt(squares_ / weight_), bleed_ / weight_, dark_ / weight_};
    }

private:
    double weight_ = 0.0, squares_ = 0.0, bleed_ = 0.0, dark_ = 0.0;
};

class Percentile
{
public:
    void add(double weight, double error)
    {
        const double bin = std::min(std::abs(error), 1.0) * (kBins - 1);
        bins_[static_cast<std::size_t>(bin + 0.5)] += weight;
        total_ += weight;
    }
    double at(double share) const
    {
        double below = 0.0;
        for (std::size_t i = 0; i < bins_.size(); ++i)
        {
            below += bins_[i];
            if (below >= share * total_)
                return static_cast<double>(i) / (kBins - 1);
        }
        return 1.0;
    }

private:
    static constexpr int kBins = 4097;
    std::vector<double> bins_ = std::vector<double>(kBins);
    double total_ = 0.0;
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
    : technique_(technique), scene_(scene), receivers_(receivers),
      kernel_(technique.taps == 1 ? kernel : binomialKernel(static_cast<int>(kernel.size()) - 2)),
      deviation_(static_cast<float>(deviationOf(kernel_))),
      estimator_(technique.prepare({scene.peel, kernel_, deviation_})),
      image_(storedImage(technique, *estimator_, {scene.peel, kernel_, deviation_}))
{
}

float Judge::atTexel(const Receiver& receiver, float depth, const Setting& setting, const float* texel) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float reach = 0.5f * std::sqrt(setting.slopeFloor) * deviation_; // the floor is of 4 deviations^2
    return estimator_->visibility({image_, texel, receiver.x, receiver.y, depth, gradient,
                                   receiverMinVariance(0.0f, gradient, reach),
                                   setting.storedFloor * kRoundings * depthErrorOf(technique_.format)});
}

float Judge::estimate(const Receiver& receiver, const Setting& setting) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float depth = shiftReceiver(receiver.surface.depth, gradient, setting.shift);
    if (technique_.taps == 1)
        return atTexel(receiver, depth, setting, image_.texel(receiver.x, receiver.y));

    std::array<float, kMostChannels> sample;
    float sum = 0.0f;
    for (const glm::ivec2 low : {glm::ivec2(-1, -1), glm::ivec2(0, -1), glm::ivec2(-1, 0), glm::ivec2(0, 0)})
    {
        const int x = receiver.x + low.x;
        const int y = receiver.y + low.y;
        for (int c = 0; c < technique_.channels; ++c)
        {
            sample[static_cast<std::size_t>(c)] = 0.25f * (image_.texel(x, y)[c] + image_.texel(x + 1, y)[c] +
                                                           image_.texel(x, y + 1)[c] + image_.texel(x + 1, y + 1)[c]);
        }
        sum += atTexel(receiver, planeDepth(depth, gradient, glm::vec2(low) + 0.5f), setting, sample.data());
    }
    return 0.25f * sum;
}

double Judge::rmse(const Setting& setting, std::size_t stride) const
{
    Sum sum;
    for (std::size_t i = 0; i < receivers_.size(); i += stride)
    {
        const Receiver& r = receivers_[i];
        sum.add(static_cast<double>(r.surface.facing), static_cast<double>(estimate(r, setting) - r.visibility));
    }
    return sum.errors().rmse;
}

Setting Judge::bestSetting() const
{
    const std::size_t stride = std::max<std::size_t>(1, receivers_.size() / kChoiceReceivers);
    Setting best = kPlainSetting;
    double least = rmse(best, stride);
    for (const Setting& setting : allSettings())
    {
        const Setting& first = allSettings().front();
        const bool otherFloor = setting.slopeFloor != first.slopeFloor || setting.storedFloor != first.storedFloor;
        if (otherFloor && !technique_.floors)
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
    result.technique = technique_.name;
    result.peer = technique_.peer;
    result.bits = technique_.bits;
    result.taps = technique_.taps;
    result.scene = scene_.name;
    result.mesh = scene_.mesh;
    result.setting = bestSetting();
    Sum all;
    Sum unweighted;
    Percentile percentile;
    std::array<Sum, kGroupNames.size()> groups;
    for (const Receiver& r : receivers_)
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
