// Passes that read a light's depth buffer, of every projection, multisampled or not, with the neighbours' slopes.
#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace sampling
{
namespace
{

constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;
constexpr int kSamples = 4;
constexpr double kNear = 0.5;
constexpr double kFar = 20;
// The linear depths' range is not that of the planes.
constexpr double kRangeNear = 1;
constexpr double kRangeFar = 16;
// The map is a rectangle of its texture, not as wide as high.
const lvsm::Rectangle kMap{3, 5, 21, 13};
constexpr Shape kSize{32, 24};
const glm::dvec2 kTangents(0.75, 1.25);

// How the light projects: what the host says of it, and the distances by the library's functions for a texel.
struct Projection
{
    std::string name;
    lvsm::DepthBlock block;
    std::function<double(double, int, int)> depth;
};

double axisDistance(double z, bool reversed, double farPlane)
{
    if (std::isinf(farPlane))
        return kNear / std::max(z, 1e-18);
    const double linear =
        reversed ? lvsm::linearDepthReversed(z, kNear, farPlane) : lvsm::linearDepth(z, kNear, farPlane);
    return kNear + linear * (farPlane - kNear);
}

double toRange(double distance)
{
    return lvsm::linstep(distance, kRangeNear, kRangeFar);
}

double pointDepth(double along, int x, int y)
{
    const glm::dvec2 place((x - kMap.x + 0.5) / kMap.width, (y - kMap.y + 0.5) / kMap.height);
    const glm::dvec3 position(along * kTangents * (2.0 * place - 1.0), along);
    return lvsm::pointLightDepth(position, glm::dvec3(0), kRangeNear, kRangeFar);
}

std::vector<Projection> projections()
{
    const auto f = [](double value)
    {
        return static_cast<float>(value);
    };
    const float infinity = std::numeric_limits<float>::infinity();
    const glm::vec2 tangents(kTangents);
    const float n = f(kNear), r0 = f(kRangeNear), r1 = f(kRangeFar);
    std::vector<Projection> all;
    for (const bool reversed : {false, true})
    {
        const std::string name = reversed ? "reversed " : "";
        const auto orthographic = [=](double z, int, int)
        {
            return toRange(kNear + (reversed ? 1 - z : z) * (kFar - kNear));
        };
        const auto perspective = [=](double z, int, int)
        {
            return toRange(axisDistance(z, reversed, kFar));
        };
        const auto point = [=](double z, int x, int y)
        {
            return pointDepth(axisDistance(z, reversed, kFar), x, y);
        };
        all.push_back({name + "orthographic", lvsm::orthographicDepths(n, f(kFar), reversed, r0, r1), orthographic});
        all.push_back({name + "perspective", lvsm::perspectiveDepths(n, f(kFar), reversed, r0, r1), perspective});
        all.push_back({name + "point", lvsm::pointDepths(n, f(kFar), reversed, r0, r1, tangents, kMap), point});
    }
    all.push_back({"reversed infinite", lvsm::perspectiveDepths(n, infinity, true, r0, r1),
                   [](double z, int, int)
                   {
                       return toRange(axisDistance(z, true, HUGE_VAL));
                   }});
    return all;
}

// What a sample of the depth buffer holds.
float sampleOf(int x, int y, int index)
{
    return (static_cast<float>((x * 7 + y * 13 + index * 29) % 64) + 0.5f) / 64.0f;
}

class Buffers
{
public:
    Buffers(VulkanContext& context, const Form& form)
        : m_context(context), m_form(form), m_sampler(makeSampler(context, vk::Filter::eNearest))
    {
    }

    Texture depths(int samples) const
    {
        if (samples > 1)
            return multisampled();
        std::vector<float> values;
        for (int i = 0; i < kSize.width * kSize.height; ++i)
            values.push_back(sampleOf(i % kSize.width, i / kSize.width, 0));
        return makeTexture(m_context, kSize, kDepthFormat, values.data(), values.size() * sizeof(float));
    }

    Pixels store(const Texture& depths, const lvsm::DepthBlock& block, const std::string& macros, bool compute) const
    {
        const Texture target = makeTexture(m_context, Pixels(kSize.width, kSize.height));
        auto pass = lvsm::storePass(nullptr, 0, 0, kMap);
        const Buffer store = makeBufferOf(m_context, std::vector{pass.block});
        const Buffer source = makeBufferOf(m_context, std::vector{block});
        const bool hlsl = m_form.isHlsl();
        using Type = vk::DescriptorType;
        std::vector<Binding> bindings{uniformAt(2, store), uniformAt(4, source)};
        bindings.push_back({0,
                            hlsl ? Type::eSampledImage : Type::eCombinedImageSampler,
                            {},
                            *depths.flat,
                            hlsl ? vk::Sampler() : *m_sampler});
        if (compute)
        {
            bindings.push_back(storageAt(1, target.array));
            dispatch(m_context, shader("store", compute, macros), bindings, static_cast<std::uint32_t>(pass.groups.x),
                     static_cast<std::uint32_t>(pass.groups.y), 1);
        }
        else
            draw(m_context, kernel("triangle.vert", vk::ShaderStageFlagBits::eVertex), shader("store", compute, macros),
                 bindings, target, 0);
        return readBack(m_context, target);
    }

private:
    Texture multisampled() const
    {
        Shape shape = kSize;
        shape.samples = kSamples;
        Texture depths = makeTexture(m_context, shape, kDepthFormat);
        RasterOptions options;
        options.depth = kDepthFormat;
        options.samples = kSamples;
        options.keep = false;
        const Raster raster(m_context, kernel("triangle.vert", vk::ShaderStageFlagBits::eVertex),
                            kernel("sample_depths.frag", vk::ShaderStageFlagBits::eFragment), {}, options);
        raster.draw({}, {*depths.flat}, shape.extent(), 3, nullptr, {vk::ClearDepthStencilValue(1.0f, 0)});
        return depths;
    }

    Shader kernel(const std::string& file, vk::ShaderStageFlagBits stage) const
    {
        const Form glsl{"combined", m_form.glslFolder, m_form.hlslFolder, m_form.kernelFolder, {}};
        return compile(glsl, m_form.kernelFolder + "/" + file, stage, "main", "");
    }

    Shader shader(const std::string& name, bool compute, const std::string& macros) const
    {
        const std::string folder = (m_form.isHlsl() ? m_form.hlslFolder : m_form.glslFolder) + "/lvsm/passes/" + name;
        const std::string path = folder + (m_form.isHlsl() ? ".hlsl" : compute ? ".comp" : ".frag");
        const std::string entry = m_form.isHlsl() ? "lvsm_" + name + (compute ? "Compute" : "Pixel") : "main";
        const std::string source = m_form.isHlsl() ? "#define LVSM_DEPTH_SOURCE b4\n"
                                                   : "#define LVSM_DEPTH_SOURCE layout(binding = 4, std140)\n"
                                                     "#define LVSM_STORE_FORMAT rgba32f\n";
        return compile(m_form, path, compute ? vk::ShaderStageFlagBits::eCompute : vk::ShaderStageFlagBits::eFragment,
                       entry, source + macros);
    }

    VulkanContext& m_context;
    const Form& m_form;
    vk::raii::Sampler m_sampler;
};

// The lesser of the two changes to the neighbours, as long as there are two.
double lesserChange(double before, double depth, double behind, bool first, bool last)
{
    const double backward = depth - before;
    const double forward = behind - depth;
    return first ? forward : last ? backward : std::abs(backward) < std::abs(forward) ? backward : forward;
}

glm::dvec2 expectedMoments(const Projection& projection, int x, int y, int samples, bool sloped)
{
    const auto at = [&](int i, int j, int index)
    {
        return projection.depth(static_cast<double>(sampleOf(i, j, index)), i, j);
    };
    const int right = kMap.x + kMap.width - 1;
    const int bottom = kMap.y + kMap.height - 1;
    glm::dvec2 sum(0);
    for (int s = 0; s < samples; ++s)
    {
        const double depth = at(x, y, s);
        const double dx = lesserChange(at(x - 1, y, s), depth, at(x + 1, y, s), x == kMap.x, x == right);
        const double dy = lesserChange(at(x, y - 1, s), depth, at(x, y + 1, s), y == kMap.y, y == bottom);
        sum += sloped ? lvsm::depthMomentsSloped(depth, dx, dy) : lvsm::depthMoments(depth);
    }
    return sum / static_cast<double>(samples);
}

bool checkStored(const Buffers& buffers, const Form& form, int samples, bool sloped)
{
    const std::string vec4 = form.isHlsl() ? "float4" : "vec4";
    const std::string moments =
        sloped ? "lvsm_depthMomentsSloped(depth, slope.x, slope.y)" : "lvsm_depthMoments(depth)";
    std::string macros =
        std::string("#define LVSM_STORE") + (sloped ? "_SLOPED(depth, slope, slice) " : "(depth, slice) ");
    macros += vec4 + "(" + moments + ", 0.0, 0.0)\n";
    if (!sloped)
        macros += "#define LVSM_STORE_LARGEST 1.0\n";
    if (samples > 1)
        macros += "#define LVSM_DEPTH_SAMPLES " + std::to_string(samples) + "\n";
    const Texture depths = buffers.depths(samples);
    bool passed = true;
    for (const Projection& projection : projections())
    {
        Comparison comparison(projection.name + (samples > 1 ? ", multisampled" : "") + (sloped ? ", sloped" : ""));
        for (const bool compute : {true, false})
        {
            const Pixels stored = buffers.store(depths, projection.block, macros, compute);
            for (int i = 0; i < kMap.width * kMap.height; ++i)
            {
                const int x = kMap.x + i % kMap.width;
                const int y = kMap.y + i / kMap.width;
                const glm::dvec2 expected = expectedMoments(projection, x, y, samples, sloped);
                // Twenty units in the last place of a distance up to twice the range, whose square doubles them, and
                // whose slope does once more.
                const double tolerance = 2 * 20.0 / (1 << 23) * (sloped ? 4 : 2);
                const std::string where =
                    (compute ? "compute " : "fragment ") + std::to_string(x) + ' ' + std::to_string(y);
                for (int c = 0; c < 2; ++c)
                    comparison.expect(static_cast<double>(stored.at(x, y)[c]), expected[c], tolerance, where);
            }
        }
        passed = comparison.passed() && passed;
    }
    return passed;
}

} // namespace

bool checkDepths(VulkanContext& context, const Form& form)
{
    const Buffers buffers(context, form);
    bool passed = true;
    for (const int samples : {1, kSamples})
    {
        for (const bool sloped : {false, true})
            passed = checkStored(buffers, form, samples, sloped) && passed;
    }
    return passed;
}

} // namespace sampling
