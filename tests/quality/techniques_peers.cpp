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
    explicit Esm(float exponent) : exponent_(exponent) {}
    void store(const Surface& nearest, float* texel) const override
    {
        texel[0] = occluderTerm(nearest.depth, exponent_);
    }
    float visibility(const Query& q) const override { return exponentialShadow(q.texel[0], q.depth, exponent_); }

private:
    float exponent_;
};

/// Eight bits a term, four sines and then four cosines at a time.
class Csm : public Estimator
{
public:
    Csm(int order, float strength, bool offset)
        : order_(order), strength_(strength), offset_(offset ? fourierOffset<float>(order) : 0.0f),
          scale_(offset ? 1.0f : 2.0f)
    {
    }

    void store(const Surface& nearest, float* texel) const override
    {
        for (int first = 1; first <= order_; first += 4, texel += 8)
        {
            const glm::vec4 sines = encodeFourier(fourierSines(nearest.depth, first, order_));
            const glm::vec4 cosines = encodeFourier(fourierCosines(nearest.depth, first, order_));
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
        for (int first = 1; first <= order_; first += 4)
        {
            const float* terms = q.texel + 2 * (first - 1);
            sum += fourierSum(decoded(terms), decoded(terms + 4), q.depth, offset_, first, order_, strength_);
        }
        return fourierVisibility(sum, scale_);
    }

private:
    int order_;
    float strength_;
    float offset_;
    float scale_;
};

} // namespace

std::vector<Technique> otherPeers()
{
    std::vector<Technique> all{{"ESM r32f 80", true, 32, 1, Format::Fp32, false, fixed<Esm>(80.0f)}};
    for (const int order : {4, 8, 16})
    {
        for (const bool offset : {true, false})
        {
            const std::string name = "CSM-" + std::to_string(order) + " unorm8 " + (offset ? "offset" : "scale");
            all.push_back({name, true, 16 * order, 2 * order, Format::Unorm8, false, fixed<Csm>(order, 1.0f, offset)});
        }
    }
    return all;
}

} // namespace lvsm::quality
