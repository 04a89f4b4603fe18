// What the benchmark measures with must itself be right.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

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

Technique techniqueNamed(const std::string& name)
{
    for (const Technique& technique : allTechniques())
    {
        if (technique.name == name)
            return technique;
    }
    FAIL("no technique " << name);
    return {};
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

TEST_CASE("truth in the layered scenes is brute force over the window")
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
            double lit = 0.0;
            for (int dy = -2; dy <= 2; ++dy)
            {
                for (int dx = -2; dx <= 2; ++dx)
                {
                    const float plane = r.surface.depth + r.surface.gradient.y * static_cast<float>(dy);
                    const double weight =
                        kernel[static_cast<std::size_t>(dx + 2)] * kernel[static_cast<std::size_t>(dy + 2)];
                    if (scene.peel.begin(r.x + dx, r.y + dy)->depth >= plane - 1e-6f)
                        lit += weight;
                }
            }
            CHECK(static_cast<double>(r.visibility) == doctest::Approx(lit).epsilon(1e-6));
        }
    }
}

TEST_CASE("exact depths judge flat receivers without error")
{
    const std::vector<double> kernel = binomialKernel(kKernel);
    const Technique exact = techniqueNamed("limit: exact distribution");
    for (const char* name : {"foliage", "fence", "stack"})
    {
        const Scene scene = layeredScene(name, kSize, 5);
        const std::vector<Receiver> receivers = receiversOf(scene, kernel);
        CHECK(Judge(exact, scene, receivers, kernel).measure().all.rmse < 1e-6);
    }
}

TEST_CASE("each technique is given its best shift and floor")
{
    const std::vector<double> kernel = binomialKernel(kKernel);
    const Scene scene = layeredScene("slanted", kSize, 2);
    const std::vector<Receiver> receivers = receiversOf(scene, kernel);
    // Without a shift the slope is its own shadow, with one of the filter's radius it is not, whatever is stored.
    const Measurement exact = Judge(techniqueNamed("limit: exact distribution"), scene, receivers, kernel).measure();
    CHECK(exact.plainRmse > 0.01);
    CHECK(exact.all.rmse < 1e-6);
    CHECK(exact.setting.shift == 3.0f);

    std::vector<Receiver> few(receivers.begin(), receivers.begin() + 200);
    for (const char* name : {"VSM rg32f", "MSM4 rgba32f", "LVSM-8 unorm8 plane, uniform"})
    {
        const Technique technique = techniqueNamed(name);
        const Judge judge(technique, scene, few, kernel);
        const auto rmse = [&](const Setting& setting)
        {
            double sum = 0.0;
            for (const Receiver& r : few)
            {
                const double error = static_cast<double>(judge.estimate(r, setting) - r.visibility);
                sum += error * error;
            }
            return std::sqrt(sum / 200.0);
        };
        double least = rmse(kPlainSetting);
        for (const Setting& setting : allSettings())
            least = std::min(least, rmse(setting));
        CHECK(judge.measure().all.rmse == doctest::Approx(least).epsilon(1e-9));
    }
}

TEST_CASE("every estimate is a visibility, whatever the setting")
{
    const std::vector<double> kernel = binomialKernel(kKernel);
    const Mesh mesh = twoPlates();
    const Scene scenes[] = {layeredScene("slanted", kSize, 2), meshScene("plates", mesh, "grazing", kSize)};
    for (const Scene& scene : scenes)
    {
        const std::vector<Receiver> receivers = receiversOf(scene, kernel);
        for (const Technique& technique : allTechniques())
        {
            const Judge judge(technique, scene, receivers, kernel);
            for (std::size_t i = 0; i < receivers.size(); i += 61)
            {
                for (const Setting& setting : allSettings())
                {
                    const float v = judge.estimate(receivers[i], setting);
                    // The weights of a window of exact depths sum to 1 but for rounding.
                    REQUIRE_MESSAGE((v >= 0.0f && v <= 1.0f + 1e-6f), technique.name << " gives " << v);
                }
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

namespace
{

// Stores the depth as it is and gives what a function makes of the filtered depth and the receiver's.
class Linear : public Estimator
{
public:
    explicit Linear(float (*visibility)(float mean, float depth)) : m_visibility(visibility) {}

    void store(const Surface& nearest, float* texel) const override { texel[0] = nearest.depth; }
    float visibility(const Query& q) const override { return m_visibility(q.texel[0], q.depth); }

private:
    float (*m_visibility)(float mean, float depth);
};

Technique linear(float (*visibility)(float mean, float depth))
{
    return {"linear", false, 32, 1, Format::Fp32, false, fixed<Linear>(visibility)};
}

} // namespace

TEST_CASE("four taps see the same window with the same weights as one, and the plane where each of them is")
{
    const std::vector<double> kernel = binomialKernel(7);
    const Scene scene = layeredScene("slanted", kSize, 2);
    const std::vector<Receiver> receivers = receiversOf(scene, kernel);
    const auto mean = [](float filtered, float)
    {
        return filtered;
    };
    const auto square = [](float, float depth)
    {
        return depth * depth;
    };
    const Technique means = linear(mean), squares = linear(square);
    const Judge one(means, scene, receivers, kernel);
    const Judge four(fourTaps(means), scene, receivers, kernel);
    const Judge planes(fourTaps(squares), scene, receivers, kernel);
    Setting plain = kPlainSetting;
    plain.shift = 0.0f;
    REQUIRE(!receivers.empty());
    for (const Receiver& r : receivers)
    {
        CHECK(four.estimate(r, plain) == doctest::Approx(one.estimate(r, plain)).epsilon(1e-5));
        // The mean of the squared depths half a texel away to either side along both axes.
        const glm::vec2 g = r.surface.gradient;
        const float expected = r.surface.depth * r.surface.depth + 0.25f * (g.x * g.x + g.y * g.y);
        CHECK(planes.estimate(r, plain) == doctest::Approx(expected).epsilon(1e-6));
    }
}

TEST_CASE("layers relative to the plane count 0.15 of what is left in the layer as no light, and all that is behind")
{
    const Scene scene = layeredScene("stack", kSize, 2);
    const std::vector<double> kernel = binomialKernel(kKernel);
    const auto estimator = techniqueNamed("LVSM-2 unorm8 plane, uniform")
                               .prepare({scene.peel, kernel, static_cast<float>(deviationOf(kernel))});
    // A quarter of the window at 0.1, a half at the receiver's depth, 0.4, and a quarter in the layer behind.
    Image image(3, 4);
    const float depths[] = {0.1f, 0.4f, 0.4f, 0.9f};
    for (int y = 0; y < 3; ++y)
    {
        for (int x = 0; x < 3; ++x)
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
    const float seen = estimator->visibility({image, image.texel(1, 1), 1, 1, 0.4f, glm::vec2(0.0f), 0.0f, 0.0f});
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
