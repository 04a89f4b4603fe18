#include "measure.hpp"

#include <algorithm>
#include <cmath>

#include <lvsm/receiver.hpp>

#include "filter.hpp"

namespace lvsm::quality {
namespace {

constexpr std::size_t kChoiceStride = 16;  // the best setting is chosen on every 16th receiver
constexpr int kRoundings = 3;              // storing, and two passes of the filter

class Sum {
 public:
  void add(double weight, double error) {
    weight_ += weight;
    squares_ += weight * error * error;
    bleed_ += weight * std::max(error, 0.0);
    dark_ += weight * std::max(-error, 0.0);
  }
  Errors errors() const {
    if (!(weight_ > 0.0)) return {};
    return {weight_, std::sqrt(squares_ / weight_), bleed_ / weight_, dark_ / weight_};
  }

 private:
  double weight_ = 0.0, squares_ = 0.0, bleed_ = 0.0, dark_ = 0.0;
};

class Percentile {
 public:
  void add(double weight, double error) {
    const double bin = std::min(std::abs(error), 1.0) * (kBins - 1);
    bins_[static_cast<std::size_t>(bin + 0.5)] += weight;
    total_ += weight;
  }
  double at(double share) const {
    double below = 0.0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      below += bins_[i];
      if (below >= share * total_) return static_cast<double>(i) / (kBins - 1);
    }
    return 1.0;
  }

 private:
  static constexpr int kBins = 4097;
  std::vector<double> bins_ = std::vector<double>(kBins);
  double total_ = 0.0;
};

Group lightGroup(const Receiver& r) {
  return r.visibility >= 1.0f - 1e-6f ? Group::Lit : r.visibility > 1e-6f ? Group::Penumbra : Group::Shadow;
}

Group distanceGroup(const Receiver& r) {
  return r.occluderDistance < 0.02f   ? Group::NearOccluder
         : r.occluderDistance < 0.15f ? Group::MiddleOccluder
                                      : Group::FarOccluder;
}

Group slopeGroup(const Receiver& r) {
  const float slope = glm::length(r.surface.gradient);
  return slope < 0.001f ? Group::Flat : slope < 0.005f ? Group::Sloped : Group::Steep;
}

Image storedImage(const Technique& technique, const Estimator& estimator, const Map& map) {
  Image image(map.peel.size(), technique.channels);
  for (int y = 0; y < image.size(); ++y) {
    for (int x = 0; x < image.size(); ++x) {
      float* texel = image.texel(x, y);
      estimator.store(map.peel.nearest(x, y), texel);
      for (int c = 0; c < technique.channels; ++c) texel[c] = stored(texel[c], technique.format);
    }
  }
  if (technique.bits > 0) blur(image, map.kernel, technique.format);
  return image;
}

}  // namespace

const std::vector<Setting>& allSettings() {
  static const std::vector<Setting> settings = [] {
    std::vector<Setting> all;
    for (const float shift : {0.0f, 0.3f, 1.0f, 3.0f}) {
      for (const float slopeFloor : {0.0f, 1.0f, 4.0f}) {
        for (const float storedFloor : {0.01f, 0.1f, 0.5f}) all.push_back({shift, slopeFloor, storedFloor});
      }
    }
    return all;
  }();
  return settings;
}

Judge::Judge(const Technique& technique, const Scene& scene, const std::vector<Receiver>& receivers,
             const std::vector<double>& kernel)
    : technique_(technique),
      scene_(scene),
      receivers_(receivers),
      deviation_(deviationOf(kernel)),
      estimator_(technique.prepare({scene.peel, kernel})),
      image_(storedImage(technique, *estimator_, {scene.peel, kernel})) {}

float Judge::estimate(const Receiver& receiver, const Setting& setting) const {
  const glm::vec2 gradient = receiver.surface.gradient;
  const float reach = 0.5f * std::sqrt(setting.slopeFloor) * static_cast<float>(deviation_);  // it takes 4 deviations^2
  const float rounding = kRoundings * depthErrorOf(technique_.format);
  return estimator_->visibility({image_, image_.texel(receiver.x, receiver.y), receiver.x, receiver.y,
                                 shiftReceiver(receiver.surface.depth, gradient, setting.shift), gradient,
                                 receiverMinVariance(0.0f, gradient, reach),
                                 recommendedMinVariance(rounding, setting.storedFloor)});
}

double Judge::rmse(const Setting& setting, std::size_t stride) const {
  Sum sum;
  for (std::size_t i = 0; i < receivers_.size(); i += stride) {
    const Receiver& r = receivers_[i];
    sum.add(static_cast<double>(r.surface.facing), static_cast<double>(estimate(r, setting) - r.visibility));
  }
  return sum.errors().rmse;
}

Setting Judge::bestSetting() const {
  const std::size_t stride = receivers_.size() > 1000 * kChoiceStride ? kChoiceStride : 1;
  Setting best = kPlainSetting;
  double least = rmse(best, stride);
  for (const Setting& setting : allSettings()) {
    const bool floored = setting.slopeFloor != kPlainSetting.slopeFloor || setting.storedFloor != kPlainSetting.storedFloor;
    if (floored && !technique_.floors) continue;
    const double error = rmse(setting, stride);
    if (error < least) {
      least = error;
      best = setting;
    }
  }
  return best;
}

Measurement Judge::measure() const {
  Measurement result{technique_.name, technique_.peer, technique_.bits, scene_.name, scene_.mesh, bestSetting(), {}, {}, 0.0, 0.0, {}};
  Sum all;
  Sum unweighted;
  Percentile percentile;
  std::array<Sum, kGroupNames.size()> groups;
  for (const Receiver& r : receivers_) {
    const double error = static_cast<double>(estimate(r, result.setting) - r.visibility);
    const double weight = static_cast<double>(r.surface.facing);
    all.add(weight, error);
    unweighted.add(1.0, error);
    percentile.add(weight, error);
    groups[static_cast<std::size_t>(lightGroup(r))].add(weight, error);
    if (r.occluderDistance > 0.0f) groups[static_cast<std::size_t>(distanceGroup(r))].add(weight, error);
    groups[static_cast<std::size_t>(slopeGroup(r))].add(weight, error);
  }
  result.all = all.errors();
  result.unweighted = unweighted.errors();
  result.p99 = percentile.at(0.99);
  result.plainRmse = rmse(kPlainSetting, 1);
  std::transform(groups.begin(), groups.end(), result.groups.begin(), [](const Sum& sum) { return sum.errors(); });
  return result;
}

}  // namespace lvsm::quality
