#include <lvsm/convolution.hpp>
#include <lvsm/esm.hpp>

#include "techniques.hpp"

namespace lvsm::quality
{
namespace
{

class Esm : public Estimator
{
public:
    explicit Esm(float exponent) : m_exponent(exponent) {}
    void store(const Surface& nearest, float* texel) const override
    {
        texel[0] = occluderTerm(nearest.depth, m_exponent);
    }
    float visibility(const Query& q) const override { return exponentialShadow(q.texel[0], q.depth, m_exponent); }

private:
    float m_exponent;
};

/// Eight bits a term, four sines and then four cosines at a time.
class Csm : public Estimator
{
public:
    Csm(int order, float strength, bool offset)
        : m_order(order), m_strength(strength), m_offset(offset ? fourierOffset<float>(order) : 0.0f),
          m_scale(offset ? 1.0f : 2.0f)
    {
    }

    void store(const Surface& nearest, float* texel) const override
    {
        for (int first = 1; first <= m_order; first += 4, texel += 8)
        {
            const glm::vec4 sines = encodeFourier(fourierSines(nearest.depth, first, m_order));
            const glm::vec4 cosines = encodeFourier(fourierCosines(nearest.depth, first, m_order));
            for (int i = 0; i < 4; ++i)
            {
                texel[i] = sines[i];
                texel[i + 4] = cosines[i];
            }
        }
    }

    float visibility(const Query& q) const override
    {
        const auto decoded = [](const float* t)
        {
            return decodeFourier(glm::vec4(t[0], t[1], t[2], t[3]));
        };
        float sum = 0.0f;
        for (int first = 1; first <= m_order; first += 4)
        {
            const float* terms = q.texel + 2 * (first - 1);
            sum += fourierSum(decoded(terms), decoded(terms + 4), q.depth, m_offset, first, m_order, m_strength);
        }
        return fourierVisibility(sum, m_scale);
    }

private:
    int m_order;
    float m_strength;
    float m_offset;
    float m_scale;
};

} // namespace

Technique csm(int order, float strength, bool offset)
{
    const std::string name = "CSM-" + std::to_string(order) + " unorm8 " + (offset ? "offset" : "scale");
    return {name,
            true,
            16 * order,
            2 * order,
            Format::Unorm8,
            false,
            fixed<Csm>(order, strength, offset),
            "CSM " + std::to_string(order) + " terms"};
}

std::vector<Technique> otherPeers()
{
    std::vector<Technique> all{{"ESM r32f 80", true, 32, 1, Format::Fp32, false, fixed<Esm>(80.0f), "ESM"}};
    all.push_back(all[0]);
    all.back().name = "ESM r32f chosen";
    for (const float exponent : {10.0f, 20.0f, 40.0f, 80.0f})
        all.back().warps.push_back(fixed<Esm>(exponent));
    for (const int order : {4, 8, 16})
    {
        for (const bool offset : {true, false})
            all.push_back(csm(order, 1.0f, offset));
    }
    return all;
}

} // namespace lvsm::quality
