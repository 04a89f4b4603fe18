#include "techniques_of_papers.hpp"

#include <algorithm>
#include <cmath>

#include <lvsm/layers.hpp>
#include <lvsm/lloyd.hpp>

namespace lvsm::papers
{
namespace
{

using quality::Query;

class PaperLayers : public quality::Estimator
{
public:
    explicit PaperLayers(Layering layering) : m_layering(std::move(layering)) {}

    void store(const quality::Surface& nearest, float* texel) const override
    {
        for (int i = 0; i < m_layering.count(); ++i)
        {
            const glm::vec2 moments = layerMoments(nearest.depth, interval(i));
            texel[2 * i] = moments.x;
            texel[2 * i + 1] = moments.y;
        }
    }

    float visibility(const Query& q) const override
    {
        const int layer = layerIndex(q.depth, m_layering.splits.data(), m_layering.count());
        const auto split = [&](int i)
        {
            return m_layering.splits[static_cast<std::size_t>(i)];
        };
        const float weight = transitionWeight(q.depth, split(layer), split(layer + 1), m_layering.width);
        float own = inLayer(q, layer);
        for (int front = 0; m_layering.least && front < layer; ++front)
            own = std::min(own, inLayer(q, front));
        if (weight == 0.0f)
            return own;
        return blendTransition(own, inLayer(q, weight < 0.0f ? layer - 1 : layer + 1), weight);
    }

private:
    glm::vec2 interval(int layer) const
    {
        return layerInterval(m_layering.splits[static_cast<std::size_t>(layer)],
                             m_layering.splits[static_cast<std::size_t>(layer) + 1], m_layering.overlap);
    }

    float inLayer(const Query& q, int layer) const
    {
        const glm::vec2 range = interval(layer);
        const float length = range.y - range.x;
        return layeredVisibility(glm::vec2(q.texel[2 * layer], q.texel[2 * layer + 1]), q.depth, range,
                                 std::max(q.slopeVariance, q.storedVariance * length * length));
    }

    Layering m_layering;
};

double share(double sum, double weight)
{
    return weight > 0.0 ? sum / weight : 0.0;
}

} // namespace

quality::Technique layered(const Layering& layering)
{
    const int count = layering.count();
    return {"LVSM-" + std::to_string(count),
            false,
            2 * count * bitsOf(layering.format),
            2 * count,
            layering.format,
            true,
            quality::fixed<PaperLayers>(layering)};
}

std::vector<float> uniformSplits(int count)
{
    std::vector<float> splits;
    for (int i = 0; i <= count; ++i)
        splits.push_back(uniformSplit<float>(i, count));
    return splits;
}

std::vector<float> mapDepths(const quality::Scene& scene)
{
    std::vector<float> depths;
    for (int y = 0; y < scene.peel.size(); ++y)
    {
        for (int x = 0; x < scene.peel.size(); ++x)
            depths.push_back(scene.peel.nearest(x, y).depth);
    }
    return depths;
}

std::vector<float> relaxedSplits(const quality::Scene& scene, int count)
{
    std::vector<float> splits(static_cast<std::size_t>(count) + 1);
    const int size = scene.peel.size();
    lloydRelax(mapDepths(scene).data(), size, size, splits.data(), count);
    return splits;
}

std::vector<float> visibilities(const Lit& lit, const quality::Technique& technique)
{
    quality::MapMaker maker(technique, lit.scene, {lit.filterWidth}, quality::Rounding::EachPass);
    const quality::StoredMap map(maker, {});
    std::vector<float> found;
    for (const Receiver& r : lit.view.receivers)
        found.push_back(map.estimate(r, quality::kPlainSetting));
    return found;
}

std::vector<float> truths(const View& view)
{
    std::vector<float> found;
    for (const Receiver& r : view.receivers)
        found.push_back(r.visibility);
    return found;
}

ViewErrors errorsOf(const View& view, const std::vector<float>& visibility)
{
    constexpr float kNone = 1e-6f, kContact = 0.03f;
    ViewErrors errors;
    double inShadow = 0.0, inContact = 0.0, inLight = 0.0, between = 0.0;
    for (std::size_t i = 0; i < visibility.size(); ++i)
    {
        const float truth = view.receivers[i].visibility;
        const double error = static_cast<double>(visibility[i] - truth);
        errors.rmse += error * error;
        if (view.shielded[i])
            errors.shielded = std::max(errors.shielded, error);
        if (truth <= kNone)
        {
            ++inShadow;
            errors.bleed += std::max(error, 0.0);
            errors.worst = std::max(errors.worst, error);
            const bool isNear = view.receivers[i].occluderDistance < kContact;
            inContact += isNear ? 1.0 : 0.0;
            errors.contact += isNear ? error : 0.0;
        }
        else if (truth >= 1.0f - kNone)
        {
            ++inLight;
            errors.dark -= error;
            errors.darkest = std::max(errors.darkest, -error);
        }
        else
        {
            ++between;
            errors.penumbra += error * error;
        }
    }
    errors.rmse = std::sqrt(share(errors.rmse, static_cast<double>(visibility.size())));
    errors.bleed = share(errors.bleed, inShadow);
    errors.contact = share(errors.contact, inContact);
    errors.dark = share(errors.dark, inLight);
    errors.penumbra = std::sqrt(share(errors.penumbra, between));
    return errors;
}

Panels panelsOf(const View& view, int count)
{
    return {view.width, view.height, count};
}

void shade(Panels& panels, int panel, const View& view, const std::vector<float>& visibility,
           const std::vector<float>& splits)
{
    constexpr glm::vec3 kLayers[] = {
        {0.45f, 0.65f, 1.0f}, {1.0f, 0.85f, 0.35f}, {0.55f, 0.9f, 0.6f}, {1.0f, 0.6f, 0.45f}};
    for (int y = 0; y < view.height; ++y)
    {
        for (int x = 0; x < view.width; ++x)
        {
            const auto pixel = static_cast<std::size_t>(y * view.width + x);
            const int i = view.at[pixel];
            const std::size_t receiver = static_cast<std::size_t>(std::max(i, 0));
            const float light = i < 0 ? 0.0f : 0.9f * visibility[receiver] * view.facing[pixel];
            const glm::vec3 colour(view.facing[pixel] < 0.0f ? 1.0f : std::sqrt(0.06f + light));
            const bool tinted = i >= 0 && !splits.empty();
            const int layer = tinted ? layerIndex(view.receivers[receiver].depth(), splits.data(),
                                                  static_cast<int>(splits.size()) - 1)
                                     : 0;
            panels.at(panel, x, y) = tinted ? colour * kLayers[layer % 4] : colour;
        }
    }
}

} // namespace lvsm::papers
