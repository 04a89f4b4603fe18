#include <algorithm>

#include <lvsm/exponential.hpp>
#include <lvsm/moments.hpp>

#include "techniques.hpp"

namespace lvsm::quality
{
namespace
{

class Vsm : public Estimator
{
public:
    void store(const Surface& nearest, float* texel) const override
    {
        const glm::vec2 slope = ownSlope(nearest);
        const glm::vec2 moments = depthMomentsSloped(nearest.depth, slope.x, slope.y);
        texel[0] = moments.x;
        texel[1] = moments.y;
    }
    float visibility(const Query& q) const override
    {
        return chebyshevUpperBound(glm::vec2(q.texel[0], q.texel[1]), q.depth,
                                   std::max(q.slopeVariance, q.storedVariance));
    }
};

class Evsm2 : public Estimator
{
public:
    explicit Evsm2(float exponent) : m_exponent(exponent) {}
    void store(const Surface& nearest, float* texel) const override
    {
        const glm::vec4 moments = exponentialMoments(nearest.depth, glm::vec2(m_exponent, 0.0f));
        texel[0] = moments.x;
        texel[1] = moments.y;
    }
    float visibility(const Query& q) const override
    {
        return exponentialVisibility2(glm::vec2(q.texel[0], q.texel[1]), q.depth, m_exponent,
                                      std::max(q.slopeVariance, q.storedVariance));
    }

private:
    float m_exponent;
};

class Evsm4 : public Estimator
{
public:
    Evsm4(float positive, float negative) : m_exponents(positive, negative) {}
    void store(const Surface& nearest, float* texel) const override
    {
        const glm::vec4 moments = exponentialMoments(nearest.depth, m_exponents);
        for (int i = 0; i < 4; ++i)
            texel[i] = moments[i];
    }
    float visibility(const Query& q) const override
    {
        return exponentialVisibility4(glm::vec4(q.texel[0], q.texel[1], q.texel[2], q.texel[3]), q.depth, m_exponents,
                                      std::max(q.slopeVariance, q.storedVariance));
    }
    float least(const Query& q) const override
    {
        const glm::vec2 warped = exponentialWarp(q.depth, m_exponents);
        const glm::vec2 floors =
            exponentialMinVariance(std::max(q.slopeVariance, q.storedVariance), q.depth, m_exponents);
        return std::max(chebyshevLowerBound(glm::vec2(q.texel[0], q.texel[1]), warped.x, floors.x),
                        chebyshevLowerBound(glm::vec2(q.texel[2], q.texel[3]), warped.y, floors.y));
    }

private:
    glm::vec2 m_exponents;
};

} // namespace

std::vector<Technique> varianceTechniques()
{
    // 5.54: the most that fp16 bears. 42 for fp32 likewise, with head room; 10 and 5 for the negative warp are what
    // public implementations ship with.
    constexpr float kFp16 = 5.54f;
    const auto evsm4 = [](const std::string& name, int bits, Format format, float positive, float negative)
    {
        return Technique{name, true, bits, 4, format, true, fixed<Evsm4>(positive, negative), "EVSM4"};
    };
    std::vector<Technique> all{{"VSM rg16", true, 32, 2, Format::Unorm16, true, fixed<Vsm>(), "VSM"},
                               {"EVSM2 rg16f 5.54", true, 32, 2, Format::Fp16, true, fixed<Evsm2>(kFp16), "EVSM2"},
                               {"VSM rg32f", true, 64, 2, Format::Fp32, true, fixed<Vsm>(), "VSM"},
                               {"EVSM2 rg32f 42", true, 64, 2, Format::Fp32, true, fixed<Evsm2>(42.0f), "EVSM2"},
                               evsm4("EVSM4 rgba16f 5.54", 64, Format::Fp16, kFp16, kFp16),
                               evsm4("EVSM4 rgba32f 40/5", 128, Format::Fp32, 40.0f, 5.0f),
                               evsm4("EVSM4 rgba32f 42/10", 128, Format::Fp32, 42.0f, 10.0f),
                               evsm4("EVSM4 rgba32f 42/42", 128, Format::Fp32, 42.0f, 42.0f)};
    all[0].variants = true;
    // The same with exponents that are chosen.
    const auto chosen = [&](Technique technique, const std::string& name, const std::vector<Prepare>& warps)
    {
        technique.name = name + " chosen";
        technique.prepare = warps.front();
        technique.warps = warps;
        all.push_back(std::move(technique));
    };
    const auto both = [](const std::vector<float>& positive, const std::vector<float>& negative)
    {
        std::vector<Prepare> warps;
        for (const float p : positive)
        {
            for (const float n : negative)
                warps.push_back(fixed<Evsm4>(p, n));
        }
        return warps;
    };
    const std::vector<float> ofFp16{1.4f, 2.8f, kFp16};
    chosen(all[1], "EVSM2 rg16f", {fixed<Evsm2>(1.4f), fixed<Evsm2>(2.8f), fixed<Evsm2>(kFp16)});
    chosen(all[3], "EVSM2 rg32f",
           {fixed<Evsm2>(2.5f), fixed<Evsm2>(5.0f), fixed<Evsm2>(10.0f), fixed<Evsm2>(20.0f), fixed<Evsm2>(42.0f)});
    chosen(all[4], "EVSM4 rgba16f", both(ofFp16, ofFp16));
    chosen(all[6], "EVSM4 rgba32f", both({5.0f, 10.0f, 20.0f, 42.0f}, {2.5f, 5.0f, 10.0f, 20.0f}));
    all.back().variants = true;
    return all;
}

} // namespace lvsm::quality
