#include "stored_map.hpp"

#include <cmath>

#include <lvsm/receiver.hpp>

namespace lvsm::quality
{
namespace
{

constexpr std::size_t kMostChannels = 64;
constexpr int kMostTapsAcross = 5;

/// How often a map is halved for a footprint: as long as it is wide, no level in between.
int levelOf(const Footprint& footprint)
{
    int level = 0;
    while (static_cast<float>(2 << level) <= footprint.across())
        ++level;
    return level;
}

} // namespace

std::string Variant::suffix() const
{
    const std::string taps = tapsAcross == 1 ? "" : ", " + std::to_string(tapsAcross * tapsAcross) + " taps";
    return taps + (half ? ", half" : "") + (decoded ? ", four decodes" : "");
}

std::vector<Variant> variantsOf(const Technique& technique, const Window& window)
{
    std::vector<Variant> variants{{1, false}};
    if (technique.own)
        return {{1, false}, {1, true}, {1, false, true}, {1, true, true}};
    const int most = !technique.variants ? 0 : window.tree ? 1 : kMostTapsAcross;
    for (int across = 1; across <= std::min(window.width, most); ++across)
    {
        if (across > 1)
            variants.push_back({across, false});
        variants.push_back({across, true});
    }
    return variants;
}

MapMaker::MapMaker(const Technique& technique, const Scene& scene, const Window& window, Rounding rounding,
                   const Footprint& footprint)
    : m_technique(technique), m_scene(scene), m_window(window), m_rounding(rounding), m_footprint(footprint)
{
    if (!technique.own)
        m_estimator = technique.prepare({scene.peel, window, footprint});
}

std::shared_ptr<const Estimator> MapMaker::estimator(int level, bool decoded)
{
    if (!m_technique.own)
        return m_estimator;
    // At full resolution a window is the filter's own, however it is read.
    std::shared_ptr<const Estimator>& found = m_own[{level, decoded && level > 0}];
    if (found == nullptr)
        found = m_technique.prepare({m_scene.peel, m_window, m_footprint, level, decoded});
    return found;
}

Image MapMaker::make(const std::vector<double>& kernel, int level)
{
    const bool isFiltered = m_technique.channels > 0 && m_technique.reading != Reading::Window;
    const Format between = m_rounding == Rounding::Once ? Format::Fp32 : m_technique.format;
    auto found = m_blurred.find(kernel);
    if (found == m_blurred.end())
    {
        Image image(m_scene.peel.size(), m_technique.channels);
        for (int y = 0; m_technique.channels > 0 && y < image.size(); ++y)
        {
            for (int x = 0; x < image.size(); ++x)
            {
                float* texel = image.texel(x, y);
                m_estimator->store(m_scene.peel.nearest(x, y), texel);
                for (int c = 0; c < m_technique.channels; ++c)
                    texel[c] = stored(texel[c], between);
            }
        }
        if (isFiltered && kernel.size() > 1)
            blur(image, kernel, between);
        found = m_blurred.emplace(kernel, std::move(image)).first;
    }
    Image image = found->second;
    for (int i = 0; i < level && m_technique.reading != Reading::Window; ++i)
        image = halved(image);
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
    : m_technique(maker.m_technique), m_variant(variant),
      m_reading(variant.decoded ? Reading::Decoded : m_technique.reading), m_footprint(maker.m_footprint),
      m_level(m_reading == Reading::Window ? 0 : std::max(levelOf(m_footprint), variant.half ? 1 : 0)),
      m_scale(static_cast<float>(1 << m_level)), m_roundings(maker.m_rounding == Rounding::Once ? 1.0f : 3.0f),
      m_taps(binomialKernel(variant.tapsAcross)), m_estimator(maker.estimator(m_level, variant.decoded)), m_image(1, 1)
{
    // The footprint's own level is no filter that the window has to do without.
    const std::vector<double> kernel = maker.m_window.before(variant.tapsAcross, variant.half);
    const double blurred = deviationOf(kernel);
    const double box = (static_cast<double>(m_scale * m_scale) - 1.0) / 12.0;
    m_deviation = static_cast<float>(std::sqrt(blurred * blurred + box));
    m_image = maker.make(kernel, m_level);
}

int StoredMap::samples() const
{
    return std::max(1, m_footprint.length >> m_level);
}

float StoredMap::at(glm::vec2 place, glm::ivec2 texel, const float* channels, const Receiver& receiver,
                    const Setting& setting, float depth, int samples) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float reach = 0.5f * std::sqrt(setting.slopeFloor) * m_deviation; // the floor is of 4 deviations^2
    return m_estimator->visibility(
        {m_image, channels, texel.x, texel.y, place - glm::vec2(texel), depth, m_scale * gradient,
         m_deviation / m_scale, receiverMinVariance(0.0f, gradient, reach),
         setting.storedFloor * m_roundings * depthErrorOf(m_technique.format), setting.bias,
         m_technique.contact ? setting.bleeding : 0.0f, stride(receiver), samples, receiver.direction});
}

glm::vec2 StoredMap::stride(const Receiver& receiver) const
{
    const float length = static_cast<float>(m_footprint.length);
    return length / (static_cast<float>(samples()) * m_scale) * receiver.direction;
}

float StoredMap::tap(const Receiver& receiver, const Setting& setting, float depth, glm::vec2 away, int samples) const
{
    // The centre of the first texel of what is stored is in the middle of those that it stands for.
    const glm::vec2 full = glm::vec2(receiver.x, receiver.y) + receiver.offset + away;
    const glm::vec2 place = (full - 0.5f * (m_scale - 1.0f)) / m_scale;
    const glm::ivec2 nearest(glm::floor(place + 0.5f));
    if (m_reading == Reading::Window || m_reading == Reading::Nearest)
        return at(place, nearest, m_image.texel(nearest.x, nearest.y), receiver, setting, depth, 1);

    if (m_reading == Reading::Bilinear)
    {
        std::array<float, kMostChannels> sample{};
        for (int i = 0; i < samples; ++i)
        {
            const float along = static_cast<float>(i) - 0.5f * static_cast<float>(samples - 1);
            for (int c = 0; c < m_technique.channels; ++c)
                sample[static_cast<std::size_t>(c)] +=
                    m_image.bilinear(place + along * stride(receiver), c) / static_cast<float>(samples);
        }
        return at(place, nearest, sample.data(), receiver, setting, depth, samples);
    }

    const glm::ivec2 low(glm::floor(place));
    const glm::vec2 f = place - glm::vec2(low);
    const float weights[] = {(1.0f - f.x) * (1.0f - f.y), f.x * (1.0f - f.y), (1.0f - f.x) * f.y, f.x * f.y};
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i)
    {
        const glm::ivec2 texel = low + glm::ivec2(i % 2, i / 2);
        const float there = planeDepth(depth, receiver.surface.gradient, m_scale * (glm::vec2(texel) - place));
        if (weights[i] > 0.0f)
            sum +=
                weights[i] * at(glm::vec2(texel), texel, m_image.texel(texel.x, texel.y), receiver, setting, there, 1);
    }
    return sum;
}

float StoredMap::estimate(const Receiver& receiver, const Setting& setting) const
{
    const glm::vec2 gradient = receiver.surface.gradient;
    const float depth = shiftReceiver(receiver.depth(), gradient, setting.shift);
    if (m_reading == Reading::Window || (m_variant.tapsAcross == 1 && samples() == 1))
        return tap(receiver, setting, depth, glm::vec2(0.0f));
    if (m_reading == Reading::Bilinear && samples() > 1)
        return tap(receiver, setting, depth, glm::vec2(0.0f), samples());

    double sum = 0.0;
    if (samples() > 1)
    {
        for (int i = 0; i < samples(); ++i)
        {
            const float along = static_cast<float>(i) - 0.5f * static_cast<float>(samples() - 1);
            const glm::vec2 away = along * m_scale * stride(receiver);
            sum += static_cast<double>(tap(receiver, setting, planeDepth(depth, gradient, away), away)) / samples();
        }
        return static_cast<float>(sum);
    }
    const int across = m_variant.tapsAcross;
    const float middle = 0.5f * static_cast<float>(across - 1);
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
