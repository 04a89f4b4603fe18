#include <algorithm>

#include <lvsm/quantised.hpp>
#include <lvsm/trigonometric.hpp>

#include "layer_splits.hpp"
#include "techniques.hpp"

namespace lvsm::quality
{
namespace
{

void keep(const glm::vec4& moments, bool encoded, float* texel)
{
    const glm::vec4 kept = encoded ? encodeMoments4(moments) : moments;
    for (int i = 0; i < 4; ++i)
        texel[i] = kept[i];
}

glm::vec4 kept(const float* texel, bool encoded)
{
    const glm::vec4 moments(texel[0], texel[1], texel[2], texel[3]);
    return encoded ? decodeMoments4(moments) : moments;
}

class Msm4 : public Estimator
{
public:
    Msm4(bool encoded, float bias) : m_encoded(encoded), m_bias(bias) {}
    void store(const Surface& nearest, float* texel) const override
    {
        keep(depthMoments4(nearest.depth), m_encoded, texel);
    }
    float visibility(const Query& q) const override
    {
        return momentVisibility4(kept(q.texel, m_encoded), q.depth, q.bias * m_bias);
    }
    float least(const Query& q) const override
    {
        const glm::vec4 mirrored = kept(q.texel, m_encoded) * glm::vec4(-1.0f, 1.0f, -1.0f, 1.0f);
        return 1.0f - momentVisibility4(mirrored, 1.0f - q.depth, q.bias * m_bias);
    }

private:
    bool m_encoded;
    float m_bias;
};

/// Four moments coded after the filter, in 64 or 32 bits.
class Quantised : public Estimator
{
public:
    explicit Quantised(bool packed) : m_packed(packed) {}
    void store(const Surface& nearest, float* texel) const override
    {
        keep(depthMoments4(nearest.depth), false, texel);
    }
    void code(float* texel) const override
    {
        glm::vec4 quantised = quantiseMoments4(kept(texel, false), kMoment4BiasFp32<float>);
        if (m_packed)
            quantised = unpackQuantised4<float>(packQuantised4(quantised));
        for (int i = 0; i < 4; ++i)
            texel[i] = m_packed ? quantised[i] : stored(quantised[i], Format::Unorm16);
    }
    float visibility(const Query& q) const override
    {
        return quantisedVisibility4(kept(q.texel, false), q.depth,
                                    m_packed ? kDepthErrorQuantised32<float> : kDepthErrorQuantised64<float>);
    }

private:
    bool m_packed;
};

class Trigonometric : public Estimator
{
public:
    explicit Trigonometric(float bias) : m_bias(bias) {}
    void store(const Surface& nearest, float* texel) const override
    {
        const glm::vec4 moments = trigonometricMoments(nearest.depth);
        for (int i = 0; i < 4; ++i)
            texel[i] = moments[i];
    }
    float visibility(const Query& q) const override
    {
        return trigonometricVisibility(kept(q.texel, false), q.depth, q.bias * m_bias);
    }

private:
    float m_bias;
};

/// Four moments a layer, 16 bits each.
class LayeredMsm4 : public Estimator
{
public:
    explicit LayeredMsm4(Splits splits) : m_splits(std::move(splits)) {}

    void store(const Surface& nearest, float* texel) const override
    {
        for (int i = 0; i < m_splits.count(); ++i)
        {
            keep(layerMoments4(nearest.depth, m_splits.interval(i)), true, texel + 4 * i);
        }
    }

    float visibility(const Query& q) const override
    {
        const int layer = m_splits.layerOf(q.depth);
        const auto moments = [&](int i)
        {
            return kept(q.texel + 4 * i, true);
        };
        const glm::vec4 front = layer > 0 ? moments(layer - 1) : glm::vec4(1.0f);
        const glm::vec4 behind =
            layer + 1 < m_splits.count() ? moments(layer + 1) : glm::vec4(-1.0f, 1.0f, -1.0f, 1.0f);
        return bracketedVisibility4(front, moments(layer), behind, q.depth, m_splits.interval(layer),
                                    q.bias * kMoment4BiasUnorm16<float>);
    }

private:
    Splits m_splits;
};

} // namespace

std::vector<Technique> momentTechniques()
{
    constexpr float kBias8 = 6.0e-5f * 256.0f; // rounding is 257 times that of 16 bits
    const auto biased = [](Technique technique, bool variants)
    {
        technique.bias = true;
        technique.variants = variants;
        return technique;
    };
    const auto quantised = [](const std::string& name, int bits)
    {
        Technique technique{name, true, bits, 4, Format::Fp32, false, fixed<Quantised>(bits == 32), name};
        technique.reading = Reading::Decoded;
        technique.variants = true;
        return technique;
    };
    const float rounding = recommendedTrigonometricBias(kDepthErrorUnorm16<float>);
    std::vector<Technique> all{
        biased({"MSM4 unorm8", true, 32, 4, Format::Unorm8, false, fixed<Msm4>(true, kBias8), "MSM4 16-bit"}, false),
        biased({"MSM4 unorm16", true, 64, 4, Format::Unorm16, false, fixed<Msm4>(true, kMoment4BiasUnorm16<float>),
                "MSM4 16-bit"},
               true),
        biased({"MSM4 rgba32f", true, 128, 4, Format::Fp32, false, fixed<Msm4>(false, kMoment4BiasFp32<float>), "MSM4"},
               true),
        quantised("MSM4 quantised 32-bit", 32),
        quantised("MSM4 quantised 64-bit", 64),
        biased({"trigonometric unorm16", false, 64, 4, Format::Unorm16, false, fixed<Trigonometric>(rounding),
                "trigonometric 16-bit"},
               true)};
    for (const int count : {2, 4})
    {
        for (const Placement placement : {Placement::Uniform, Placement::Optimal})
        {
            const std::string name = "MSM4 x " + std::to_string(count) + " layers unorm16, " + nameOf(placement);
            all.push_back(
                biased({name, false, 64 * count, 4 * count, Format::Unorm16, false,
                        [=](const Map& map) { return std::make_unique<LayeredMsm4>(Splits(map, count, placement)); },
                        count == 2 ? "MSM4 x 2 16-bit" : "MSM4 x N 16-bit"},
                       false));
        }
    }
    return all;
}

} // namespace lvsm::quality
