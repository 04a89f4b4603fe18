#include "stored_map.hpp"

#include <cmath>

#include <lvsm/receiver.hpp>

#include "filter.hpp"

namespace lvsm::quality
{
namespace
{

constexpr std::size_t kMostChannels = 64;
constexpr int kMostTapsAcross = 5;

/// Width of the filter that leaves the rest of the window to the taps, and to what a bilinear sample between texels, or
/// a texel for 2 x 2, filters by itself.
int blurWidth(int width, const Variant& variant)
{
    const int across = variant.tapsAcross;
    const int left = across % 2 == 1 ? width - across + 1 : width - across;
    return std::max(1, variant.half ? left - 2 : left);
}

} // namespace

std::string Variant::suffix() const
{
    const std::string taps = tapsAcross == 1 ? "" : ", " + std::to_string(tapsAcross * tapsAcross) + " taps";
    return taps + (half ? ", half" : "");
}

std::vector<Variant> variantsOf(const Technique& technique, int width)
{
    std::vector<Variant> variants{{1, false}};
    if (!technique.variants)
        return variants;
    for (int across = 1; across <= std::min(width, kMostTapsAcross); ++across)
    {
        if (across > 1)
            variants.push_back({across, false});
        variants.push_back({across, true});
    }
    return variants;
}

MapMaker::MapMaker(const Technique& technique, const Scene& scene, int width, Rounding rounding)
    : m_technique(technique), m_scene(scene), m_kernel(binomialKernel(width)), m_rounding(rounding),
      m_estimator(technique.prepare({scene.peel, m_kernel}))
{
}

Image MapMaker::make(int width, bool half)
{
    const bool isFiltered = m_technique.reading != Reading::Window;
    const Format between = m_rounding == Rounding::Once ? Format::Fp32 : m_technique.format;
    auto found = m_blurred.find(width);
    if (found == m_blurred.end())
    {
        Image image(m_scene.peel.size(), m_technique.channels);
        for (int y = 0; y < image.size(); ++y)
        {
            for (int x = 0; x < image.size(); ++x)
            {
                float* texel = image.texel(x, y);
                m_estimator->store(m_scene.peel.nearest(x, y), texel);
                for (int c = 0; c < m_technique.channels; ++c)
                    texel[c] = stored(texel[c], between);
            }
        }
        if (isFiltered && width > 1)
            blur(image, binomialKernel(width), between);
        found = m_blurred.emplace(width, std::move(image)).first;
    }
    Image image = half ? halved(found->second) : found->second;
    for (int y = 0; isFiltered && y < image.size(); ++y)
    {
        for (int x = 0; x < image.size(); ++x)
        {
            float* texel = image.texel(x, y);
            for (int c = 0; c < m_technique.channels; ++c)
                texel[c] = stored(texel[c], m_technique.format);
            m_estimator->code(texel);
        }
    }
    return image;
}

StoredMap::StoredMap(MapMaker& maker, const Variant& variant)
    : m_technique(maker.m_technique), m_variant(variant), m_scale(variant.half ? 2.0f : 1.0f),
      m_roundings(maker.m_rounding == Rounding::Once ? 1.0f : 3.0f), m_taps(binomialKernel(variant.tapsAcross)),
      m_estimator(*maker.m_estimator), m_image(1, 1)
{
    const int width = blurWidth(static_cast<int>(maker.m_kernel.size()), variant);
    const double blurred = deviationOf(binomialKernel(width));
    m_deviation = static_cast<float>(std::sqrt(blurred * blurred + (variant.half ? 0.25 : 0.0)));
    m_image = maker.make(width, variant.half);
}

float StoredMap::at(glm::vec2 place, glm::ivec2 texel, const float* channels, const Receiver& receiver,
                    const Setting& setting, float depth) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float reach = 0.5f * std::sqrt(setting.slopeFloor) * m_deviation; // the floor is of 4 deviations^2
    return m_estimator.visibility({m_image, channels, texel.x, texel.y, place - glm::vec2(texel), depth,
                                   m_scale * gradient, m_deviation / m_scale,
                                   receiverMinVariance(0.0f, gradient, reach),
                                   setting.storedFloor * m_roundings * depthErrorOf(m_technique.format), setting.bias,
                                   m_technique.contact ? setting.bleeding : 0.0f});
}

float StoredMap::tap(const Receiver& receiver, const Setting& setting, float depth, glm::vec2 away) const
{
    // The centre of the first texel of what is stored is at 0.5 where it stands for 2 x 2.
    const glm::vec2 full = glm::vec2(receiver.x, receiver.y) + receiver.offset + away;
    const glm::vec2 place = m_variant.half ? 0.5f * (full - 0.5f) : full;
    const glm::ivec2 nearest(glm::floor(place + 0.5f));
    if (m_technique.reading == Reading::Window)
        return at(place, nearest, m_image.texel(nearest.x, nearest.y), receiver, setting, depth);

    const glm::ivec2 low(glm::floor(place));
    const glm::vec2 f = place - glm::vec2(low);
    const float weights[] = {(1.0f - f.x) * (1.0f - f.y), f.x * (1.0f - f.y), (1.0f - f.x) * f.y, f.x * f.y};
    std::array<float, kMostChannels> sample{};
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i)
    {
        const float weight = weights[i];
        const glm::ivec2 texel = low + glm::ivec2(i % 2, i / 2);
        const float* channels = m_image.texel(texel.x, texel.y);
        if (m_technique.reading == Reading::Bilinear)
        {
            for (int c = 0; c < m_technique.channels; ++c)
                sample[static_cast<std::size_t>(c)] += weight * channels[c];
        }
        else if (weight > 0.0f)
        {
            const glm::vec2 away4 = m_scale * (glm::vec2(texel) - place);
            const float there = planeDepth(depth, receiver.surface.gradient, away4);
            sum += weight * at(glm::vec2(texel), texel, channels, receiver, setting, there);
        }
    }
    if (m_technique.reading == Reading::Decoded)
        return sum;
    return at(place, nearest, sample.data(), receiver, setting, depth);
}

float StoredMap::estimate(const Receiver& receiver, const Setting& setting) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float depth = shiftReceiver(receiver.depth(), gradient, setting.shift);
    if (m_variant.tapsAcross == 1)
        return tap(receiver, setting, depth, glm::vec2(0.0f));
    const int across = m_variant.tapsAcross;
    const float middle = 0.5f * static_cast<float>(across - 1);
    double sum = 0.0;
    for (int i = 0; i < across * across; ++i)
    {
        const int x = i % across, y = i / across;
        const glm::vec2 away = glm::vec2(x, y) - middle;
        const double weight = m_taps[static_cast<std::size_t>(x)] * m_taps[static_cast<std::size_t>(y)];
        sum += weight * static_cast<double>(tap(receiver, setting, planeDepth(depth, gradient, away), away));
    }
    return static_cast<float>(sum);
}

} // namespace lvsm::quality
