// lvsm_mixture_figures [SIZE] [WORLD]: error of mixtures and of moments for receivers anywhere between texels.
//
// Mixtures keep the defaults of the documentation in every scene: a shift of half a texel, kMixtureBias, one nearest
// fetch. Moments are given what suits them best in each scene of 5 shifts and 6 reductions of light bleeding; they are
// fetched by bilinear filtering, quantised ones decoded four times. Truth is plane PCF of the same window, moved as a
// bilinear fetch moves it. Rows of half resolution keep one value for 2 x 2 texels.
#include "../unit/windows.hpp"
#include "mixture_map.hpp"

#include "scenes_mesh.hpp"
#include "truth.hpp"

#include <lvsm/moments.hpp>
#include <lvsm/moments4.hpp>
#include <lvsm/quantised.hpp>
#include <lvsm/receiver.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>

namespace
{

using namespace lvsm;
using namespace lvsm::mixtures;
using quality::Image;
using quality::Peel;
using quality::Surface;

struct Receiver
{
    glm::vec2 place;
    float depth;
    glm::vec2 gradient;
    float facing;
    float visibility;
};

// A quarter of all light-facing surfaces, each somewhere within its texel.
std::vector<Receiver> receiversOf(const Peel& peel, const std::vector<float>& kernel)
{
    const int radius = static_cast<int>(kernel.size()) / 2;
    std::mt19937 engine(3);
    const auto unit = [&]
    {
        return static_cast<float>(engine() >> 8) / 16777216.0f;
    };
    const auto weight = [&](int tap, float moved)
    {
        const auto at = [&](int i)
        {
            return std::abs(i) > radius ? 0.0f : kernel[static_cast<std::size_t>(i + radius)];
        };
        const float place = static_cast<float>(tap) - moved;
        const int below = static_cast<int>(std::floor(place));
        const float part = place - static_cast<float>(below);
        return (1.0f - part) * at(below) + part * at(below + 1);
    };
    std::vector<Receiver> receivers;
    for (int y = radius + 2; y < peel.size() - radius - 2; ++y)
    {
        for (int x = radius + 2; x < peel.size() - radius - 2; ++x)
        {
            for (const Surface* s = peel.begin(x, y); s != peel.end(x, y); ++s)
            {
                if (s->facing <= 0.0f || unit() > 0.25f)
                    continue;
                const glm::vec2 f(unit() - 0.5f, unit() - 0.5f);
                float lit = 0.0f;
                for (int dy = -radius - 1; dy <= radius + 1; ++dy)
                {
                    for (int dx = -radius - 1; dx <= radius + 1; ++dx)
                    {
                        const float w = weight(dx, f.x) * weight(dy, f.y);
                        if (w > 0.0f && peel.nearest(x + dx, y + dy).depth >=
                                            quality::ownDepth(peel, *s, x, y, {dx, dy}) - quality::kSameDepth)
                            lit += w;
                    }
                }
                receivers.push_back(
                    {glm::vec2(x, y) + f, s->depth + glm::dot(s->gradient, f), s->gradient, s->facing, lit});
            }
        }
    }
    return receivers;
}

// Four moments, filtered; at half resolution the mean of 2 x 2.
class MomentMap
{
public:
    MomentMap(const Peel& peel, const std::vector<float>& kernel, bool isHalf)
        : m_image(peel.size() / (isHalf ? 2 : 1), 4), m_texel(isHalf ? 2 : 1)
    {
        const int size = peel.size();
        const int radius = static_cast<int>(kernel.size()) / 2;
        Image from(size, 4);
        Image to(size, 4);
        for (int y = 0; y < size; ++y)
        {
            for (int x = 0; x < size; ++x)
                keep(from, x, y, depthMoments4(peel.nearest(x, y).depth));
        }
        for (const bool alongX : {true, false})
        {
            for (int y = 0; y < size; ++y)
            {
                for (int x = 0; x < size; ++x)
                {
                    glm::vec4 sum(0.0f);
                    for (int k = -radius; k <= radius; ++k)
                        sum += kernel[static_cast<std::size_t>(k + radius)] *
                               texel(from, alongX ? x + k : x, alongX ? y : y + k);
                    keep(to, x, y, sum);
                }
            }
            std::swap(from, to);
        }
        for (int y = 0; y < m_image.size(); ++y)
        {
            for (int x = 0; x < m_image.size(); ++x)
            {
                glm::vec4 sum(0.0f);
                for (int k = 0; k < m_texel * m_texel; ++k)
                    sum += texel(from, m_texel * x + k % m_texel, m_texel * y + k / m_texel);
                keep(m_image, x, y, sum / static_cast<float>(m_texel * m_texel));
            }
        }
    }

    // The mean by bilinear weights of what decode makes of a texel.
    template <typename Decode>
    auto bilinear(const glm::vec2& place, const Decode& decode) const
    {
        const float scale = static_cast<float>(m_texel);
        const glm::vec2 at = (place - 0.5f * (scale - 1.0f)) / scale;
        const glm::vec2 low = glm::floor(at);
        const glm::vec2 f = at - low;
        const int x = static_cast<int>(low.x);
        const int y = static_cast<int>(low.y);
        return (1.0f - f.y) * ((1.0f - f.x) * decode(texel(m_image, x, y), centre(x, y)) +
                               f.x * decode(texel(m_image, x + 1, y), centre(x + 1, y))) +
               f.y * ((1.0f - f.x) * decode(texel(m_image, x, y + 1), centre(x, y + 1)) +
                      f.x * decode(texel(m_image, x + 1, y + 1), centre(x + 1, y + 1)));
    }

private:
    static void keep(Image& image, int x, int y, const glm::vec4& v)
    {
        for (int c = 0; c < 4; ++c)
            image.texel(x, y)[c] = v[c];
    }

    static glm::vec4 texel(const Image& image, int x, int y)
    {
        const int last = image.size() - 1;
        const float* t = image.texel(std::clamp(x, 0, last), std::clamp(y, 0, last));
        return {t[0], t[1], t[2], t[3]};
    }

    glm::vec2 centre(int x, int y) const
    {
        const float scale = static_cast<float>(m_texel);
        return scale * glm::vec2(x, y) + 0.5f * (scale - 1.0f);
    }

    Image m_image;
    int m_texel;
};

// Errors by technique and scene, in the order of the rows.
class Table
{
public:
    template <typename Estimate>
    double error(const std::vector<Receiver>& receivers, const Estimate& estimate) const
    {
        double squares = 0.0;
        double weights = 0.0;
        for (const Receiver& r : receivers)
        {
            const double e = static_cast<double>(estimate(r) - r.visibility);
            squares += static_cast<double>(r.facing) * e * e;
            weights += static_cast<double>(r.facing);
        }
        return std::sqrt(squares / weights);
    }

    void add(const std::string& name, double bits, double rmse)
    {
        if (m_rows.find(name) == m_rows.end())
            m_names.push_back(name);
        m_rows[name].push_back(rmse);
        m_bits[name] = bits;
    }

    void print(const std::vector<std::string>& scenes) const
    {
        std::printf("| | bits a texel |");
        for (const std::string& scene : scenes)
            std::printf(" %s |", scene.c_str());
        std::printf(" mean |\n|---|---|");
        for (std::size_t i = 0; i <= scenes.size(); ++i)
            std::printf("---|");
        std::printf("\n");
        for (const std::string& name : m_names)
        {
            double sum = 0.0;
            std::printf("| %s | %g |", name.c_str(), m_bits.at(name));
            for (const double e : m_rows.at(name))
            {
                std::printf(" %.4f |", e);
                sum += e;
            }
            std::printf(" %.4f |\n", sum / static_cast<double>(scenes.size()));
        }
    }

private:
    std::vector<std::string> m_names;
    std::map<std::string, std::vector<double>> m_rows;
    std::map<std::string, double> m_bits;
};

// The best of all shifts and reductions.
template <typename Estimate>
double bestError(const Table& table, const std::vector<Receiver>& receivers, const Estimate& estimate)
{
    double least = 1.0;
    for (const float shift : {0.0f, 0.15f, 0.3f, 0.6f, 1.0f})
    {
        std::vector<float> bounds;
        for (const Receiver& r : receivers)
            bounds.push_back(estimate(r, shift));
        for (const float amount : {0.0f, 0.05f, 0.1f, 0.15f, 0.2f, 0.3f})
        {
            std::size_t i = 0;
            least = std::min(least, table.error(receivers, [&](const Receiver&)
                                                { return reduceLightBleeding(bounds[i++], amount); }));
        }
    }
    return least;
}

void measure(const Peel& peel, int rounds, Table& table)
{
    const std::vector<double> weights = unit::treeKernel(rounds);
    const std::vector<float> kernel(weights.begin(), weights.end());
    const std::vector<Receiver> receivers = receiversOf(peel, kernel);
    const DepthAt depth = [&](int x, int y)
    {
        return peel.nearest(x, y).depth;
    };
    for (const bool isHalf : {false, true})
    {
        const std::string suffix = isHalf ? ", half resolution" : "";
        const double texels = isHalf ? 4.0 : 1.0;
        for (const int count : {4, 2})
        {
            const MixtureMap map(depth, peel.size(), isHalf ? rounds - 1 : rounds, count, isHalf);
            const double e =
                table.error(receivers, [&](const Receiver& r) { return map.visibility(r.place, r.depth, r.gradient); });
            table.add("**mixture K = " + std::to_string(count) + "**" + suffix, (count == 4 ? 128 : 64) / texels, e);
        }
        const MomentMap moments(peel, kernel, isHalf);
        table.add("MSM4 rgba32f, bilinear" + suffix, 128 / texels,
                  bestError(table, receivers,
                            [&](const Receiver& r, float shift)
                            {
                                const auto plain = [](const glm::vec4& m, const glm::vec2&)
                                {
                                    return m;
                                };
                                return momentVisibility4(moments.bilinear(r.place, plain),
                                                         shiftReceiver(r.depth, r.gradient, shift),
                                                         kMoment4BiasFp32<float>);
                            }));
        for (const int bits : {64, 32})
        {
            const float depthError = bits == 64 ? kDepthErrorQuantised64<float> : kDepthErrorQuantised32<float>;
            const auto decoded = [&](const Receiver& r, float shift)
            {
                const auto judge = [&](const glm::vec4& m, const glm::vec2& centre)
                {
                    const glm::vec4 fine = quantiseMoments4(m, kMoment4BiasFp32<float>);
                    const glm::vec4 read = bits == 64 ? glm::round(fine * 65535.0f) / 65535.0f
                                                      : unpackQuantised4<float>(packQuantised4(fine));
                    const float depth = planeDepth(r.depth, r.gradient, centre - r.place);
                    return quantisedVisibility4(read, shiftReceiver(depth, r.gradient, shift), depthError);
                };
                return moments.bilinear(r.place, judge);
            };
            table.add("quantised MSM4 " + std::to_string(bits) + ", four decodes" + suffix, bits / texels,
                      bestError(table, receivers, decoded));
        }
    }
}

} // namespace

int main(int argc, char** argv)
{
    const int size = argc > 1 ? std::atoi(argv[1]) : 384;
    const std::string only = argc > 2 ? argv[2] : "";
    if (size < 64)
    {
        std::fprintf(stderr, "usage: lvsm_mixture_figures [SIZE] [WORLD]\n");
        return 2;
    }
    for (const int rounds : {2, 3})
    {
        Table table;
        std::vector<std::string> scenes;
        int turn = 0;
        for (const std::string& world : quality::worldNames())
        {
            const std::string light = quality::lightNames()[static_cast<std::size_t>(turn++ % 4)];
            if (!only.empty() && world != only)
                continue;
            const auto mesh = quality::world(world, 1);
            if (!mesh)
            {
                std::fprintf(stderr, "lvsm_mixture_figures: %s\n", mesh.error().c_str());
                return 1;
            }
            scenes.push_back(world + ", " + light);
            measure(quality::meshScene(world, *mesh, light, size).peel, rounds, table);
        }
        std::printf("Width %d:\n\n", (2 << rounds) - 1);
        table.print(scenes);
        std::printf("\n");
    }
    return 0;
}
