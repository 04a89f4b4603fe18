// What the benchmark measures with must itself be right.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <lvsm/components.hpp>

#include "certain.hpp"
#include "filter.hpp"
#include "measure.hpp"
#include "scenes_layered.hpp"
#include "scenes_mesh.hpp"

namespace lvsm::quality
{
namespace
{

constexpr int kSize = 64;
constexpr int kKernel = 5;

/// A scene alone, whose settings are its own best, with as many receivers as they are chosen on.
std::vector<LitScene> lightsOf(Scene scene)
{
    const std::vector<double> kernel = binomialKernel(kKernel);
    std::vector<Receiver> receivers = receiversOf(scene, kernel, {false, 600});
    std::vector<LitScene> lights;
    lights.push_back({std::move(scene), true, std::move(receivers), {}});
    return lights;
}

Mesh twoPlates()
{
    Mesh mesh;
    addGround(mesh, {-1.0f, -1.0f}, {1.0f, 1.0f});
    addBox(mesh, {-0.4f, 0.5f, -0.3f}, {0.3f, 0.6f, 0.4f});
    return mesh;
}

} // namespace

TEST_CASE("binomial kernels sum to one and have the deviation sqrt(n - 1) / 2")
{
    for (const int width : {3, 5, 7, 9})
    {
        const std::vector<double> kernel = binomialKernel(width);
        double sum = 0.0;
        for (const double weight : kernel)
            sum += weight;
        CHECK(sum == doctest::Approx(1.0).epsilon(1e-15));
        CHECK(deviationOf(kernel) == doctest::Approx(0.5 * std::sqrt(width - 1.0)).epsilon(1e-14));
    }
}

TEST_CASE("rounds of the tree make the windows that mixtures have, and binomial ones of single steps")
{
    for (const int width : {3, 7, 15, 25})
    {
        const std::vector<double> kernel = binomialKernel(width);
        std::vector<double> made{1.0};
        for (const Round& round : Window{width}.rounds())
        {
            CHECK(round.step == 1);
            std::vector<double> wider(made.size() + 2);
            for (std::size_t i = 0; i < made.size(); ++i)
            {
                wider[i] += round.share * made[i];
                wider[i + 1] += (1.0 - 2.0 * round.share) * made[i];
                wider[i + 2] += round.share * made[i];
            }
            made = wider;
        }
        REQUIRE(made.size() == kernel.size());
        for (std::size_t i = 0; i < made.size(); ++i)
            CHECK(made[i] == doctest::Approx(kernel[i]).epsilon(1e-12));
    }
    for (int rounds = 1; rounds <= 3; ++rounds)
    {
        const Window window{(2 << rounds) - 1, true};
        CHECK(window.kernel().size() == static_cast<std::size_t>(window.width));
        CHECK(deviationOf(window.kernel()) == doctest::Approx(mixtureDeviation<double>(rounds)).epsilon(1e-12));
        // Half resolution adds half a texel's variance by its own.
        const double less = deviationOf(window.before(1, true));
        CHECK(less * less + 0.5 == doctest::Approx(std::pow(deviationOf(window.kernel()), 2.0)).epsilon(1e-12));
    }
}

TEST_CASE("a cut window is the middle of the whole one, so many deviations to each side")
{
    for (const int width : {3, 7, 15, 25})
    {
        const std::vector<double> whole = binomialKernel(width);
        const std::vector<double> cut = Window{width}.cut(2.0);
        const std::size_t left = (whole.size() - cut.size()) / 2;
        CHECK(cut.size() == 2 * static_cast<std::size_t>(std::sqrt(width - 1.0)) + 1);
        double sum = 0.0;
        for (std::size_t i = 0; i < cut.size(); ++i)
        {
            CHECK(cut[i] / cut[0] == doctest::Approx(whole[i + left] / whole[left]).epsilon(1e-12));
            sum += cut[i];
        }
        CHECK(sum == doctest::Approx(1.0).epsilon(1e-12));
        CHECK(Window{width}.cut(9.0) == whole);
    }
}

TEST_CASE("a window with a footprint weighs what lies along and across it")
{
    const glm::vec2 offset(0.3f, -0.2f);
    for (const Footprint& footprint :
         {Footprint{}, Footprint{4, 1}, Footprint{16, 1}, Footprint{4, 8}, Footprint{16, 8}})
    {
        const float angle = 0.7f;
        const glm::vec2 direction(std::cos(angle), std::sin(angle));
        const PlacedWindow window(binomialKernel(7), offset, footprint, direction);
        double sum = 0.0, along = 0.0, across = 0.0;
        glm::dvec2 centre(0.0);
        for (int y = window.first(); y <= window.last(); ++y)
        {
            for (int x = window.first(); x <= window.last(); ++x)
            {
                const double w = window.weight(x, y);
                const glm::vec2 p = glm::vec2(x, y) - offset;
                sum += w;
                centre += w * glm::dvec2(x, y);
                along += w * std::pow(static_cast<double>(glm::dot(p, direction)), 2.0);
                across += w * std::pow(static_cast<double>(glm::dot(p, glm::vec2(-direction.y, direction.x))), 2.0);
            }
        }
        CHECK(sum == doctest::Approx(1.0).epsilon(1e-12));
        CHECK(centre.x == doctest::Approx(static_cast<double>(offset.x)).epsilon(1e-5));
        CHECK(centre.y == doctest::Approx(static_cast<double>(offset.y)).epsilon(1e-5));
        // Binomial, and up to a quarter by the bilinear move; then the footprint's own, of places a texel apart.
        const auto least = [](double breadth)
        {
            return 1.5 + (breadth * breadth - 1.0) / 12.0;
        };
        const double length = footprint.length;
        const double breadth = std::max(1.0, static_cast<double>(footprint.across()));
        CHECK(along >= least(length) - 1e-4);
        CHECK(along <= least(length) + 0.25);
        CHECK(across >= least(breadth) - 1e-4);
        CHECK(across <= least(breadth) + 0.25);
    }
}

TEST_CASE("mixtures leave a plane lit and a step in its share, in each variant and footprint")
{
    // A wall in front of one half of a slope, wide enough that no footprint sees past it.
    constexpr float kStep = 1.0f / 512.0f;
    std::vector<std::vector<Surface>> texels(static_cast<std::size_t>(kSize * kSize));
    for (int y = 0; y < kSize; ++y)
    {
        for (int x = 0; x < kSize; ++x)
        {
            std::vector<Surface>& texel = texels[texelIndex(x, y, kSize)];
            texel.push_back({0.6f + kStep * static_cast<float>(x), {kStep, 0.0f}, 1.0f});
            if (x >= kSize / 2)
                texel.push_back({0.2f, {0.0f, 0.0f}, 1.0f});
        }
    }
    const Scene scene{"step", Peel(kSize, std::move(texels)), true};
    for (const char* name : {"mixture K=2 64-bit", "mixture K=4 128-bit", "limit: mixture K=4, not coded"})
    {
        const Technique technique = techniqueNamed(name);
        for (const Footprint& footprint : {Footprint{}, Footprint{4, 1}, Footprint{4, 8}, Footprint{8, 8}})
        {
            MapMaker maker(technique, scene, {7}, Rounding::Once, footprint);
            for (const Variant& variant : variantsOf(technique, {7}))
            {
                const StoredMap map(maker, variant);
                for (int x = 12; x < kSize - 12; ++x)
                {
                    Receiver r{x, 30, {0.25f, -0.4f}, *(scene.peel.end(x, 30) - 1), 0.0f, 0.0f};
                    std::vector<Receiver> alone{r};
                    judgeAll(scene, binomialKernel(7), alone, footprint);
                    r = alone.front();
                    const float v = map.estimate(r, plainSetting(technique));
                    const bool isFar =
                        std::abs(x - kSize / 2) > 12; // half of what a fetch from 4 x 4 texels would err by unmoved
                    CHECK_MESSAGE(std::abs(v - r.visibility) < (isFar ? 0.001f : 0.2f),
                                  std::string(name)
                                      << variant.suffix() << ", " << footprint.length << " by " << footprint.stretch
                                      << " at " << x << ": " << v << ", " << r.visibility);
                }
            }
        }
    }
}

TEST_CASE("formats keep what they can hold and err by half a step at most")
{
    for (const Format format : {Format::Unorm8, Format::Unorm16, Format::Fp16, Format::Fp32})
    {
        CHECK(stored(0.0f, format) == 0.0f);
        CHECK(stored(1.0f, format) == 1.0f);
        for (int i = 0; i <= 1000; ++i)
        {
            const float value = static_cast<float>(i) / 1000.0f;
            // The rounding of the arithmetic itself, on values up to 65535, comes on top.
            CHECK(std::abs(stored(value, format) - value) <= 1.001f * depthErrorOf(format) + 6e-8f);
        }
    }
}

TEST_CASE("the filter is the weighted mean of its window")
{
    Image image(16, 2);
    for (int y = 0; y < 16; ++y)
    {
        for (int x = 0; x < 16; ++x)
        {
            image.texel(x, y)[0] = static_cast<float>((7 * x + 3 * y * y) % 11);
            image.texel(x, y)[1] = 1.0f;
        }
    }
    const Image before = image;
    const std::vector<double> kernel = binomialKernel(5);
    blur(image, kernel, Format::Fp32);
    double mean = 0.0;
    for (int dy = 0; dy < 5; ++dy)
    {
        for (int dx = 0; dx < 5; ++dx)
        {
            mean += kernel[static_cast<std::size_t>(dx)] * kernel[static_cast<std::size_t>(dy)] *
                    static_cast<double>(before.texel(5 + dx, 6 + dy)[0]);
        }
    }
    CHECK(static_cast<double>(image.texel(7, 8)[0]) == doctest::Approx(mean).epsilon(1e-6));
    CHECK(image.texel(0, 0)[1] == 1.0f);
}

TEST_CASE("a kernel between texels is the mix of the two beside it")
{
    const std::vector<double> kernel = binomialKernel(5);
    const ShiftedKernel shifted(kernel, -0.25f);
    CHECK(shifted.first() == -3);
    CHECK(shifted.last() == 2);
    double sum = 0.0, centre = 0.0;
    for (int i = shifted.first(); i <= shifted.last(); ++i)
    {
        sum += shifted.weight(i);
        centre += i * shifted.weight(i);
        const auto at = [&](int k)
        {
            return k < 0 || k > 4 ? 0.0 : kernel[static_cast<std::size_t>(k)];
        };
        CHECK(shifted.weight(i) == doctest::Approx(0.25 * at(i + 3) + 0.75 * at(i + 2)).epsilon(1e-14));
    }
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(centre == doctest::Approx(-0.25).epsilon(1e-14));
}

TEST_CASE("truth in the layered scenes is brute force over the bilinearly weighted window")
{
    for (const std::string& name : layeredSceneNames())
    {
        const Scene scene = layeredScene(name, kSize, 3);
        const std::vector<double> kernel = binomialKernel(kKernel);
        const std::vector<Receiver> receivers = receiversOf(scene, kernel);
        REQUIRE(!receivers.empty());
        for (std::size_t i = 0; i < receivers.size(); i += 7)
        {
            const Receiver& r = receivers[i];
            const glm::ivec2 low(glm::floor(r.offset));
            const glm::vec2 f = r.offset - glm::vec2(low);
            double lit = 0.0;
            for (int corner = 0; corner < 4; ++corner)
            {
                const glm::ivec2 at = low + glm::ivec2(corner % 2, corner / 2);
                const double share =
                    static_cast<double>((corner % 2 == 1 ? f.x : 1.0f - f.x) * (corner / 2 == 1 ? f.y : 1.0f - f.y));
                for (int k = 0; k < 25; ++k)
                {
                    const glm::ivec2 tap = at + glm::ivec2(k % 5 - 2, k / 5 - 2);
                    const float plane = r.surface.depth + r.surface.gradient.y * static_cast<float>(tap.y);
                    const double weight =
                        kernel[static_cast<std::size_t>(k % 5)] * kernel[static_cast<std::size_t>(k / 5)];
                    if (scene.peel.begin(r.x + tap.x, r.y + tap.y)->depth >= plane - 1e-6f)
                        lit += share * weight;
                }
            }
            CHECK(static_cast<double>(r.visibility) == doctest::Approx(lit).epsilon(1e-5));
        }
    }
}

TEST_CASE("exact depths judge flat receivers without error, and so does PCF over the whole window")
{
    for (const char* name : {"foliage", "fence", "stack"})
    {
        const std::vector<LitScene> lights = lightsOf(layeredScene(name, kSize, 5));
        for (const char* exact : {"limit: exact distribution", "limit: exact, receiver's plane", "PCF, whole window"})
            CHECK(measure(techniqueNamed(exact), lights, {{kKernel}}).front().all.rmse < 1e-5);
    }
}

TEST_CASE("flat receivers are lit as much as the least that techniques say, or more, and as the most, or less")
{
    const std::vector<LitScene> lights = lightsOf(layeredScene("foliage", kSize, 5));
    for (const std::string name : {"EVSM4 rgba32f 42/10", "MSM4 rgba32f", "LVSM-4 unorm16 bounded, uniform",
                                   "LVSM-8 unorm8 plane, uniform", "LVSM-4 unorm8 bounded, uniform"})
    {
        CAPTURE(name);
        const Technique mostBy = techniqueNamed(name), leastBy = leastOf(mostBy);
        MapMaker mostMaker(mostBy, lights[0].scene, {kKernel}, Rounding::Once);
        MapMaker leastMaker(leastBy, lights[0].scene, {kKernel}, Rounding::Once);
        const StoredMap most(mostMaker, {}), least(leastMaker, {});
        float between = 0.0f, outside = 0.0f;
        for (const Receiver& r : lights[0].receivers)
        {
            const float low = least.estimate(r, kPlainSetting), high = most.estimate(r, kPlainSetting);
            between += high - low;
            outside += std::max(0.0f, low - r.visibility) + std::max(0.0f, r.visibility - high);
        }
        // Rounding, which few codes multiply where a layer is nearly empty, is all that lies outside.
        CHECK(outside < 0.0005f * static_cast<float>(lights[0].receivers.size()));
        CHECK(between < 0.5f * static_cast<float>(lights[0].receivers.size()));
    }
}

TEST_CASE("of exponents those are chosen that err least in the other lights")
{
    std::vector<LitScene> lights;
    for (const unsigned seed : {2u, 3u})
        lights.push_back(lightsOf(layeredScene("fence", kSize, seed)).front());
    lights.back().isReported = false;
    const Technique chosen = techniqueNamed("EVSM2 rg32f chosen");
    const double error = measure(chosen, lights, {{kKernel}}).front().all.rmse;

    // The other light alone is judged with its own best.
    std::vector<LitScene> other{lights.back()};
    other.front().isReported = true;
    std::size_t best = 0;
    double least = 1.0;
    std::vector<double> here;
    for (std::size_t i = 0; i < chosen.warps.size(); ++i)
    {
        Technique one = chosen;
        one.warps.clear();
        one.prepare = chosen.warps[i];
        here.push_back(measure(one, lights, {{kKernel}}).front().all.rmse);
        const double there = measure(one, other, {{kKernel}}).front().all.rmse;
        if (there < least)
        {
            least = there;
            best = i;
        }
    }
    CHECK(error == here[best]);
    CHECK(*std::max_element(here.begin(), here.end()) > 1.1 * error);
}

TEST_CASE("least and greatest depths of the window are certain of nothing that is not so, and of much that is")
{
    // Where a box stands on the ground, its shadow begins within the depths of the window's slope.
    Mesh standing;
    addGround(standing, {-1.0f, -1.0f}, {1.0f, 1.0f});
    addBox(standing, {-0.4f, 0.0f, -0.3f}, {0.3f, 0.2f, 0.4f});
    const std::vector<Scene> scenes{layeredScene("foliage", kSize, 5), layeredScene("slanted", kSize, 5),
                                    meshScene("plates", twoPlates(), "oblique", kSize),
                                    meshScene("standing", standing, "grazing", kSize)};
    for (const Scene& scene : scenes)
    {
        const std::vector<LitScene> lights = lightsOf(scene);
        std::vector<Technique> all = widenedRanges({25});
        const std::vector<Technique> pyramids = pyramidRanges({25});
        all.insert(all.end(), pyramids.begin(), pyramids.end());
        for (const Technique& mostBy : all)
        {
            // The window of 5 and the texel on which a receiver is off its centre.
            if (mostBy.name.find("reach 3") == std::string::npos)
                continue;
            CAPTURE(mostBy.name);
            const Technique leastBy = leastOf(mostBy);
            MapMaker mostMaker(mostBy, lights[0].scene, {kKernel}, Rounding::Once);
            MapMaker leastMaker(leastBy, lights[0].scene, {kKernel}, Rounding::Once);
            const StoredMap most(mostMaker, {}), least(leastMaker, {});
            std::size_t certain = 0;
            for (const Receiver& r : lights[0].receivers)
            {
                const bool isLit = least.estimate(r, kPlainSetting) > 0.5f;
                const bool isDark = most.estimate(r, kPlainSetting) < 0.5f;
                CHECK(!(isLit && isDark));
                CHECK((!isLit || r.visibility > 1.0f - 1e-6f));
                CHECK((!isDark || r.visibility < 1e-6f));
                certain += isLit || isDark;
            }
            // A slope is deeper and less deep than itself.
            CHECK(certain > (scene.mesh ? 0 : lights[0].receivers.size() / 8));
        }
    }
}

TEST_CASE("settings are the best of the other lights, one member after the other")
{
    std::vector<LitScene> lights;
    for (const unsigned seed : {2u, 3u})
    {
        std::vector<LitScene> one = lightsOf(layeredScene("slanted", 3 * kSize, seed));
        lights.push_back(std::move(one.front()));
    }
    lights.back().isReported = false;
    // Without a shift the slope is its own shadow, with one of the filter's radius it is not, whatever is stored.
    const Measurement exact = measure(techniqueNamed("limit: exact distribution"), lights, {{kKernel}}).front();
    CHECK(exact.plainRmse > 0.01);
    CHECK(exact.all.rmse < 0.5 * exact.plainRmse);
    CHECK(exact.setting.shift == 3.0f);

    for (const char* name : {"VSM rg32f", "MSM4 rgba32f", "LVSM-8 unorm8 plane, uniform"})
    {
        const Technique technique = techniqueNamed(name);
        MapMaker maker(technique, lights[1].scene, {kKernel}, Rounding::Once);
        const StoredMap map(maker, {});
        const auto errorOf = [&](const Setting& setting)
        {
            double sum = 0.0, weight = 0.0;
            for (const Receiver& r : lights[1].receivers)
            {
                const double error = static_cast<double>(estimateOf(map, technique, r, setting) - r.visibility);
                sum += static_cast<double>(r.surface.facing) * error * error;
                weight += static_cast<double>(r.surface.facing);
            }
            return sum / weight;
        };
        const Setting chosen = measure(technique, lights, {{kKernel}}).front().setting;
        const double least = errorOf(chosen);
        CHECK(least <= errorOf(kPlainSetting));
        // Each member of the setting alone, as it was tried last.
        const Settings settings(technique);
        for (std::size_t value = 0; value < settings.count(4); ++value)
        {
            Setting other = chosen;
            other.bleeding = settings.at({0, 0, 0, 0, value}).bleeding;
            CHECK(least <= errorOf(other) + 1e-12);
        }
    }
}

TEST_CASE("every estimate is a visibility, whatever the setting and the variant")
{
    const Mesh mesh = twoPlates();
    const Scene scenes[] = {layeredScene("slanted", kSize, 2), meshScene("plates", mesh, "grazing", kSize)};
    for (const Scene& scene : scenes)
    {
        const std::vector<Receiver> receivers = receiversOf(scene, binomialKernel(kKernel));
        for (const Technique& technique : allTechniques())
        {
            MapMaker maker(technique, scene, {kKernel}, Rounding::EachPass);
            const Settings settings(technique);
            for (const Variant& variant : variantsOf(technique, {kKernel}))
            {
                const StoredMap map(maker, variant);
                for (std::size_t i = 0; i < receivers.size(); i += 61)
                {
                    for (std::size_t value = 0; value < 6; ++value)
                    {
                        Settings::Index index{};
                        for (std::size_t member = 0; member < index.size(); ++member)
                            index[member] = (value + member) % settings.count(member);
                        const float v = estimateOf(map, technique, receivers[i], settings.at(index));
                        // The weights of a window of exact depths sum to 1 but for rounding.
                        REQUIRE_MESSAGE((v >= 0.0f && v <= 1.0f + 1e-6f), technique.name << " gives " << v);
                    }
                }
            }
        }
    }
}

TEST_CASE("taps and half resolution see the same window")
{
    // A map that holds x alone, filtered and read anywhere, is x: taps and texels for 2 x 2 are where they should be.
    // And of x^2 it is x^2 and the variance of the window, which no variant changes by more than a texel's.
    class Place : public Estimator
    {
    public:
        void store(const Surface& nearest, float* texel) const override
        {
            texel[0] = nearest.depth;
            texel[1] = nearest.depth * nearest.depth;
        }
        float visibility(const Query& q) const override { return q.texel[m_channel]; }
        explicit Place(int channel) : m_channel(channel) {}

    private:
        int m_channel;
    };
    constexpr float kStep = 1.0f / 128.0f;
    std::vector<std::vector<Surface>> ramp(static_cast<std::size_t>(kSize * kSize));
    for (int y = 0; y < kSize; ++y)
    {
        for (int x = 0; x < kSize; ++x)
            ramp[texelIndex(x, y, kSize)].push_back({kStep * static_cast<float>(x), {kStep, 0.0f}, 1.0f});
    }
    const Scene scene{"ramp", Peel(kSize, std::move(ramp)), false};
    for (const int width : {7, 15})
    {
        for (int channel = 0; channel < 2; ++channel)
        {
            Technique technique{"place", false, 64, 2, Format::Fp32, false, fixed<Place>(channel)};
            technique.variants = true;
            MapMaker maker(technique, scene, {width}, Rounding::Once);
            for (const Footprint& footprint : {Footprint{4, 1}, Footprint{8, 1}, Footprint{4, 8}, Footprint{8, 8}})
            {
                MapMaker minified(technique, scene, {width}, Rounding::Once, footprint);
                const Receiver receiver{30, 31, {0.3f, -0.2f}, {0.0f, {0.0f, 0.0f}, 1.0f}, 0.0f, 0.0f};
                const StoredMap map(minified, {});
                CHECK(map.samples() == std::min(footprint.length, footprint.stretch));
                const double value = static_cast<double>(map.estimate(receiver, kPlainSetting));
                const double place = 30.3 * static_cast<double>(kStep);
                if (channel == 0)
                {
                    CHECK(value == doctest::Approx(place).epsilon(1e-5));
                    continue;
                }
                // The length is along x. The bilinear sample of a level is up to a quarter of its texel squared wide.
                const double window = 0.25 * (width - 1) + (footprint.length * footprint.length - 1.0) / 12.0;
                const double texel = std::max(1.0, static_cast<double>(footprint.across()));
                const double variance = (value - place * place) / static_cast<double>(kStep * kStep);
                CHECK(variance > window - 0.3);
                CHECK(variance < window + 0.3 + 0.25 * texel * texel);
            }
            for (const Variant& variant : variantsOf(technique, {width}))
            {
                const StoredMap map(maker, variant);
                const Receiver receiver{30, 31, {0.3f, -0.2f}, {0.0f, {0.0f, 0.0f}, 1.0f}, 0.0f, 0.0f};
                const double value = static_cast<double>(map.estimate(receiver, kPlainSetting));
                const double place = 30.3 * static_cast<double>(kStep);
                if (channel == 0)
                {
                    CHECK(value == doctest::Approx(place).epsilon(1e-5));
                    continue;
                }
                const double window = 0.25 * (width - 1) + 0.3 * 0.7; // binomial, and the bilinear sample
                const double variance = (value - place * place) / static_cast<double>(kStep * kStep);
                CHECK(variance > window - 0.5);
                CHECK(variance < window + 0.5);
            }
        }
    }
}

TEST_CASE("a depth peel holds each plate once, with the depth, slope and cosine of its plane")
{
    const Mesh mesh = twoPlates();
    int stacks = 0;
    for (const std::string& name : lightNames())
    {
        const Scene scene = meshScene("plates", mesh, name, kSize);
        int grounds = 0;
        for (int y = 0; y < kSize; ++y)
        {
            for (int x = 0; x < kSize; ++x)
            {
                const auto count = scene.peel.end(x, y) - scene.peel.begin(x, y);
                CHECK((count == 0 || count == 1 || count == 2 || count == 3)); // ground, two sides of the box
                grounds += count == 1;
                stacks += count == 3;
                for (const Surface* s = scene.peel.begin(x, y); s != scene.peel.end(x, y); ++s)
                {
                    CHECK(s->depth >= 0.0f);
                    CHECK(s->depth <= 1.0f);
                }
            }
        }
        CHECK(grounds > 0);
    }
    CHECK(stacks > 0);

    // The ground alone: depths of a directional light are linear, and the slope is their difference.
    Mesh ground;
    addGround(ground, {-1.0f, -1.0f}, {1.0f, 1.0f});
    const Light light = Light::directional(ground, 38.0f, 20.0f, kSize);
    const Peel peel = depthPeel(ground, light, kSize);
    const Surface& here = *peel.begin(kSize / 2, kSize / 2);
    const Surface& right = *peel.begin(kSize / 2 + 1, kSize / 2);
    CHECK(right.depth - here.depth == doctest::Approx(here.gradient.x).epsilon(1e-4));
    CHECK(here.facing == doctest::Approx(std::sin(glm::radians(38.0f))).epsilon(1e-5));
}

TEST_CASE("a slope is not its own shadow, a bent surface neither, and what is behind a plate is dark")
{
    const std::vector<double> kernel = binomialKernel(kKernel);
    for (const float middle : {-0.3f, 0.0f, 0.3f})
    { // a valley, a plain and a ridge, all of them lit
        Mesh mesh;
        addQuad(mesh, {-1, 0, 1}, {0, middle, 1}, {0, middle, -1}, {-1, 0, -1}, false);
        addQuad(mesh, {0, middle, 1}, {1, 0, 1}, {1, 0, -1}, {0, middle, -1}, false);
        const Scene scene = meshScene("roof", mesh, "steep", kSize);
        const std::vector<Receiver> receivers = receiversOf(scene, kernel);
        REQUIRE(!receivers.empty());
        for (const Receiver& r : receivers)
            CHECK(r.visibility == doctest::Approx(1.0f).epsilon(1e-6));
    }

    const Scene plates = meshScene("plates", twoPlates(), "steep", kSize);
    int dark = 0;
    for (const Receiver& r : receiversOf(plates, kernel))
    {
        dark += r.visibility == 0.0f;
        if (r.visibility == 0.0f)
            CHECK(r.occluderDistance > 0.0f);
    }
    CHECK(dark > 0);
}

TEST_CASE("each tap is judged with the receiver's plane where it is")
{
    // What does not look at the map but squares the depth that it is told.
    class Square : public Estimator
    {
    public:
        void store(const Surface&, float* texel) const override { texel[0] = 0.0f; }
        float visibility(const Query& q) const override { return q.depth * q.depth; }
    };
    const Scene scene = layeredScene("slanted", kSize, 2);
    Technique squares{"square", false, 32, 1, Format::Fp32, false, fixed<Square>()};
    squares.variants = true;
    MapMaker maker(squares, scene, {7}, Rounding::Once);
    const StoredMap four(maker, {2, false});
    const std::vector<Receiver> receivers = receiversOf(scene, binomialKernel(7));
    REQUIRE(!receivers.empty());
    for (const Receiver& r : receivers)
    {
        // The mean of the squared depths half a texel away to either side along both axes.
        const glm::vec2 g = r.surface.gradient;
        const float expected = r.depth() * r.depth() + 0.25f * (g.x * g.x + g.y * g.y);
        CHECK(four.estimate(r, kPlainSetting) == doctest::Approx(expected).epsilon(1e-5));
    }
}

TEST_CASE("layers relative to the plane count a share of what is left in the layer as no light, and all that is behind")
{
    const Scene scene = layeredScene("stack", kSize, 2);
    const std::vector<double> kernel = binomialKernel(kKernel);
    const auto estimator = techniqueNamed("LVSM-2 unorm8 plane, uniform").prepare({scene.peel, {kKernel}});
    // A quarter of the window at 0.1, a half at the receiver's depth, 0.4, and a quarter in the layer behind.
    Image image(5, 4);
    const float depths[] = {0.1f, 0.4f, 0.4f, 0.9f};
    for (int y = 0; y < 5; ++y)
    {
        for (int x = 0; x < 5; ++x)
        {
            for (const float depth : depths)
            {
                float texel[4];
                estimator->store({depth, glm::vec2(0.0f), 1.0f}, texel);
                for (int c = 0; c < 4; ++c)
                    image.texel(x, y)[c] += 0.25f * texel[c];
            }
        }
    }
    const glm::vec2 flat(0.0f);
    const float seen = estimator->visibility(
        {image, image.texel(2, 2), 2, 2, flat, 0.4f, flat, 1.0f, 0.0f, 0.0f, 1.0f, 0.15f, flat, 1, flat});
    const double lit = 2.0 / 3.0;
    CHECK(seen == doctest::Approx(0.25 + 0.75 * (lit - 0.15) / 0.85).epsilon(1e-4));
}

TEST_CASE("a model that is missing or holds nothing is named")
{
    const auto missing = loadModel("/nowhere/model.obj");
    REQUIRE(!missing);
    CHECK(missing.error().find("/nowhere/model.obj") != std::string::npos);

    const std::filesystem::path path = std::filesystem::temp_directory_path() / "lvsm_no_faces.obj";
    std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto empty = loadModel(path.string());
    std::filesystem::remove(path);
    REQUIRE(!empty);
    CHECK(empty.error().find(path.string()) != std::string::npos);
}

} // namespace lvsm::quality
