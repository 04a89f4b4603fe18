// The levels of a map by the mip pass, against means of cells worked out in double.
#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <algorithm>

namespace sampling
{
namespace
{

constexpr Shape kTexture{48, 32, 2, 6};

Pixels randomTexture()
{
    Pixels pixels(kTexture.width, kTexture.height, kTexture.slices, kTexture.levels);
    Random random;
    for (glm::vec4& texel : pixels.texels)
        texel = {random.next(), random.next(), 4 * random.next(), -random.next()};
    return pixels;
}

struct Levels
{
    std::string name;
    lvsm::Rectangle map;
    bool maximum;

    int count() const { return std::min(lvsm::levelCount(map), kTexture.levels); }
};

Shader shaderOf(const Form& form, bool compute, bool maximum)
{
    const std::string folder = (form.isHlsl() ? form.hlslFolder : form.glslFolder) + "/lvsm/passes/mip";
    const std::string macros = std::string(form.isHlsl() ? "" : "#define LVSM_MIP_FORMAT rgba32f\n") +
                               (maximum ? "#define LVSM_MIP_MAXIMUM\n" : "");
    return compile(form,
                   folder + (form.isHlsl() ? ".hlsl"
                             : compute     ? ".comp"
                                           : ".frag"),
                   compute ? vk::ShaderStageFlagBits::eCompute : vk::ShaderStageFlagBits::eFragment,
                   form.isHlsl() ? (compute ? "lvsm_mipCompute" : "lvsm_mipPixel") : "main", macros);
}

// Makes one level: by compute in all slices, or drawn over the whole of one slice's level.
void makeLevel(VulkanContext& context, const Form& form, bool compute, const Levels& levels, int level,
               const Texture& texture)
{
    auto pass = lvsm::mipPass(levels.map, level, 0, kTexture.slices);
    const auto before = makeLevelView(context, texture, level - 1);
    const auto sampler = makeSampler(context, vk::Filter::eNearest);
    using Type = vk::DescriptorType;
    const Binding source{0,
                         form.isHlsl() ? Type::eSampledImage : Type::eCombinedImageSampler,
                         {},
                         *before,
                         form.isHlsl() ? vk::Sampler() : *sampler};
    const Shader shader = shaderOf(form, compute, levels.maximum);
    if (compute)
    {
        const auto own = makeLevelView(context, texture, level);
        const Buffer block = makeBufferOf(context, std::vector{pass.block});
        dispatch(context, shader, {source, storageAt(1, own), uniformAt(2, block)},
                 static_cast<std::uint32_t>(pass.groups.x), static_cast<std::uint32_t>(pass.groups.y),
                 static_cast<std::uint32_t>(pass.groups.z));
        return;
    }
    const Form glsl{"combined", form.glslFolder, form.hlslFolder, form.kernelFolder, {}};
    const Shader vertex =
        compile(glsl, form.kernelFolder + "/triangle.vert", vk::ShaderStageFlagBits::eVertex, "main", "");
    RasterOptions options;
    options.colours = {texture.format};
    const vk::Extent2D extent(static_cast<std::uint32_t>(texture.size.width >> level),
                              static_cast<std::uint32_t>(texture.size.height >> level));
    for (int slice = 0; slice < kTexture.slices; ++slice)
    {
        pass.block.slice = slice;
        const Buffer block = makeBufferOf(context, std::vector{pass.block});
        const std::vector<Binding> bindings{source, uniformAt(2, block)};
        const auto target = makeSliceView(context, texture, slice, level);
        Raster(context, vertex, shader, bindings, options).draw(bindings, {*target}, extent, 3);
    }
}

// How much of texel j of n lies in cell i of m that divide them equally.
double shareOf(int j, int n, int i, int m)
{
    const double width = static_cast<double>(n) / m;
    return std::max(std::min(j + 1.0, (i + 1) * width) - std::max(double(j), i * width), 0.0) / width;
}

glm::dvec4 expectedTexel(const Pixels& pixels, const Levels& levels, int level, int x, int y, int slice)
{
    const lvsm::Rectangle before = lvsm::levelRectangle(levels.map, level - 1);
    const lvsm::Rectangle own = lvsm::levelRectangle(levels.map, level);
    glm::dvec4 mean(0);
    glm::dvec4 largest(-1e9);
    for (int i = 0; i < before.width * before.height; ++i)
    {
        const double weight = shareOf(i % before.width, before.width, x, own.width) *
                              shareOf(i / before.width, before.height, y, own.height);
        const glm::dvec4 texel(pixels.at(before.x + i % before.width, before.y + i / before.width, slice, level - 1));
        mean += weight * texel;
        if (weight > 1e-9)
            largest = glm::max(largest, texel);
    }
    return levels.maximum ? largest : mean;
}

// Every level from the one before as it is, which the test can read, and the last one's mean from level 0.
bool checkMap(VulkanContext& context, const Form& form, bool compute, const Levels& levels)
{
    const Pixels pixels = randomTexture();
    const Texture texture = makeTexture(context, pixels);
    for (int level = 1; level < levels.count(); ++level)
        makeLevel(context, form, compute, levels, level, texture);
    const Pixels made = readBack(context, texture);
    Comparison comparison(levels.name + (compute ? ", compute" : ", fragment"));
    for (int level = 1; level < levels.count(); ++level)
    {
        const lvsm::Rectangle own = lvsm::levelRectangle(levels.map, level);
        for (int i = 0; i < (kTexture.width >> level) * (kTexture.height >> level) * kTexture.slices; ++i)
        {
            const int x = i % (kTexture.width >> level);
            const int y = i / (kTexture.width >> level) % (kTexture.height >> level);
            const int slice = i / ((kTexture.width >> level) * (kTexture.height >> level));
            const bool inside = x >= own.x && x < own.x + own.width && y >= own.y && y < own.y + own.height;
            // Drawing covers all of the level, of which the rest is not the pass's.
            if (!inside && !compute)
                continue;
            const glm::dvec4 expected = inside ? expectedTexel(made, levels, level, x - own.x, y - own.y, slice)
                                               : glm::dvec4(pixels.at(x, y, slice, level));
            for (int c = 0; c < 4; ++c)
                // Nine texels of up to 4, each with the roundings of two quotients, two products and a sum.
                comparison.expect(static_cast<double>(made.at(x, y, slice, level)[c]), expected[c],
                                  inside ? 8 * 4.0 / (1 << 23) : 0,
                                  std::to_string(x) + ' ' + std::to_string(y) + " level " + std::to_string(level));
        }
    }
    return comparison.passed();
}

} // namespace

bool checkLevels(VulkanContext& context, const Form& form)
{
    bool passed = true;
    for (const bool compute : {true, false})
    {
        passed = checkMap(context, form, compute, {"levels of a whole map", {0, 0, 48, 32}, false}) && passed;
        passed =
            checkMap(context, form, compute, {"levels of odd sizes in an atlas", {16, 0, 23, 15}, false}) && passed;
        passed = checkMap(context, form, compute, {"levels of the largest", {16, 0, 23, 15}, true}) && passed;
    }
    return passed;
}

} // namespace sampling
