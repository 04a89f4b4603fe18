#include <algorithm>

#include <lvsm/bracket.hpp>

#include "layer_splits.hpp"
#include "techniques.hpp"

namespace lvsm::quality {
namespace {

/// Two moments a layer.
class Layers : public Estimator {
 public:
  Layers(Splits splits, bool compact) : splits_(std::move(splits)), compact_(compact) {}

  void store(const Surface& nearest, float* texel) const override {
    for (int i = 0; i < splits_.count(); ++i) {
      const glm::vec2 slope = ownSlope(nearest) / splits_.length(i);
      const float warped = layerWarp(nearest.depth, splits_.interval(i));
      const bool inside = warped > 0.0f && warped < 1.0f;
      const glm::vec2 moments = inside ? depthMomentsSloped(warped, slope.x, slope.y) : depthMoments(warped);
      const glm::vec2 kept = compact_ ? compactMoments(moments) : moments;
      texel[2 * i] = kept.x;
      texel[2 * i + 1] = kept.y;
    }
  }

 protected:
  glm::vec2 moments(const Query& q, int layer) const {
    const glm::vec2 kept(q.texel[2 * layer], q.texel[2 * layer + 1]);
    return compact_ ? expandMoments(kept) : kept;
  }
  glm::vec2 inFront(const Query& q, int layer) const { return layer > 0 ? moments(q, layer - 1) : glm::vec2(1.0f); }
  glm::vec2 behind(const Query& q, int layer) const {
    return layer + 1 < splits_.count() ? moments(q, layer + 1) : glm::vec2(0.0f);
  }
  float minVariance(const Query& q, int layer) const {
    const float length = splits_.length(layer);
    return std::max(q.slopeVariance, q.storedVariance * length * length);
  }

  Splits splits_;

 private:
  bool compact_;
};

class PaperLayers : public Layers {
 public:
  using Layers::Layers;
  float visibility(const Query& q) const override {
    const int layer = splits_.layerOf(q.depth);
    return layeredVisibility(moments(q, layer), q.depth, splits_.interval(layer), minVariance(q, layer));
  }
};

class BracketedLayers : public Layers {
 public:
  using Layers::Layers;
  float visibility(const Query& q) const override {
    const int layer = splits_.layerOf(q.depth);
    return bracketedVisibility(inFront(q, layer), moments(q, layer), behind(q, layer), q.depth,
                               splits_.interval(layer), minVariance(q, layer));
  }
};

class BoundedLayers : public Layers {
 public:
  using Layers::Layers;
  float visibility(const Query& q) const override {
    const int layer = splits_.layerOf(q.depth);
    return bracketedBoundedVisibility(inFront(q, layer), moments(q, layer), behind(q, layer), q.depth,
                                      splits_.interval(layer), minVariance(q, layer));
  }
};

template <typename E>
Technique layered(const std::string& estimate, int count, Format format, Placement placement, bool compact = false) {
  const std::string name = "LVSM-" + std::to_string(count) + " " + nameOf(format) + " " + estimate + ", " + nameOf(placement);
  return {name, false, 2 * count * bitsOf(format), 2 * count, format, true, [=](const Map& map) {
            return std::make_unique<E>(Splits(map, count, placement), compact);
          }};
}

}  // namespace

std::vector<Technique> layeredTechniques() {
  std::vector<Technique> all;
  for (const int count : {2, 4, 8}) {
    all.push_back(layered<PaperLayers>("paper", count, Format::Unorm16, Placement::Uniform));
    for (const Placement placement : {Placement::Uniform, Placement::Optimal}) {
      all.push_back(layered<BracketedLayers>("bracketed", count, Format::Unorm16, placement));
      all.push_back(layered<BoundedLayers>("bounded", count, Format::Unorm16, placement));
    }
  }
  for (const int count : {2, 4, 8, 16}) {
    all.push_back(layered<BracketedLayers>("bracketed compact", count, Format::Unorm8, Placement::Uniform, true));
  }
  return all;
}

}  // namespace lvsm::quality
