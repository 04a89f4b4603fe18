#include "frame.hpp"

#include <memory>
#include <stdexcept>

#include <lvsm/lvsm.hpp>

#include "shader_compiler.hpp"

namespace lvsm::papers
{
namespace
{

using namespace support;

const std::string kPasses = LVSM_GLSL "/lvsm/passes/";
const std::string kKernels = LVSM_PAPERS_KERNELS "/";

support::Shader compile(const std::string& path, const std::string& macros)
{
    support::ShaderOptions options;
    options.preamble = macros;
    options.includeFolders = {LVSM_GLSL};
    options.name = path;
    const auto spirv = support::compileShaderFile(path, options);
    if (!spirv)
        throw std::runtime_error(spirv.error());
    return {*spirv, "main"};
}

vk::raii::Sampler samplerOf(const VulkanContext& context, const FrameOptions& options, bool linear, bool anisotropic)
{
    const auto filter = linear ? vk::Filter::eLinear : vk::Filter::eNearest;
    const auto clamp = vk::SamplerAddressMode::eClampToEdge;
    vk::SamplerCreateInfo info({}, filter, filter,
                               linear ? vk::SamplerMipmapMode::eLinear : vk::SamplerMipmapMode::eNearest, clamp, clamp,
                               clamp);
    info.maxLod = options.levels ? VK_LOD_CLAMP_NONE : 0.0f;
    info.anisotropyEnable = anisotropic;
    info.maxAnisotropy = 16.0f;
    return {context.device, info};
}

/// A slanted ground with squares of something in front of it.
std::vector<float> depthsOf(int size)
{
    std::vector<float> depths;
    for (int y = 0; y < size; ++y)
    {
        for (int x = 0; x < size; ++x)
        {
            const float ground = (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
            const bool covered = 16 * x / size % 3 == 0 && 16 * y / size % 2 == 0;
            depths.push_back(covered ? 0.6f * ground : ground);
        }
    }
    return depths;
}

std::string define(const std::string& name, const std::string& value)
{
    return "#define " + name + " " + value + "\n";
}

Rectangle whole(int size)
{
    return {0, 0, size, size};
}

} // namespace

Frame::Frame(const support::VulkanContext& context, const Way& way, const FrameOptions& options)
    : m_context(context), m_options(options), m_nearest(samplerOf(context, options, false, false)),
      m_linear(samplerOf(context, options, true, false)),
      m_shading(samplerOf(context, options, true, options.anisotropic))
{
    const auto depths = depthsOf(options.mapSize);
    m_depths = &m_textures.emplace_back(makeTexture(context, {options.mapSize, options.mapSize}, vk::Format::eR32Sfloat,
                                                    depths.data(), depths.size() * sizeof(float)));
    if (way.store == "-")
    {
        addShade(way, *m_depths, *m_depths, *m_depths);
        return;
    }
    const int levels = options.levels ? levelCount(whole(options.mapSize)) : 1;
    const Texture& map = texture(way.slices, levels, way.format);
    const Texture& unfiltered = way.keepsUnfiltered && options.blur > 1 ? texture(way.slices, 1, way.format) : map;
    const Texture* greatest = &map;
    addStore(way, unfiltered);
    if (options.blur > 1)
        addBlur(way.qualifier, unfiltered, texture(way.slices, 1, way.format), map, false);
    if (options.levels)
        addLevels(way.qualifier, map, false);
    if (way.keepsGreatest)
    {
        greatest = &texture(1, levels, vk::Format::eR32Sfloat);
        addBlur("r32f", *m_depths, texture(1, 1, vk::Format::eR32Sfloat), *greatest, true);
        if (options.levels)
            addLevels("r32f", *greatest, true);
    }
    addShade(way, map, unfiltered, *greatest);
}

void Frame::makeMap() const
{
    for (const Pass& pass : m_map)
        pass();
}

void Frame::shade() const
{
    for (const Pass& pass : m_shade)
        pass();
}

const support::Texture& Frame::texture(int slices, int levels, vk::Format format)
{
    return m_textures.emplace_back(
        makeTexture(m_context, support::Shape{m_options.mapSize, m_options.mapSize, slices, levels}, format));
}

void Frame::add(std::vector<Pass>& passes, const std::string& file, const std::string& macros,
                std::vector<Binding> bindings, glm::ivec3 groups)
{
    const support::Kernel& kernel = m_kernels.emplace_back(m_context, compile(file, macros), bindings);
    const auto count = glm::uvec3(groups);
    passes.push_back([&kernel, bindings, count] { kernel.run(bindings, count.x, count.y, count.z); });
}

template <typename Block>
Binding Frame::uniform(std::uint32_t index, const Block& block)
{
    return uniformAt(index, m_buffers.emplace_back(makeBufferOf(m_context, std::vector{block})));
}

void Frame::addStore(const Way& way, const Texture& target)
{
    std::vector<float> splits;
    for (int i = 0; i <= way.layers; ++i)
        splits.push_back(uniformSplit<float>(i, way.layers));
    const auto pass = storePass(splits.data(), way.layers, 0.01f, whole(m_options.mapSize));
    const std::string macros = way.store + define("LVSM_STORE_FORMAT", way.qualifier);
    m_views.push_back(makeLevelView(m_context, target, 0));
    add(m_map, kPasses + "store.comp", macros,
        {sampledAt(0, m_depths->flat, m_nearest), storageAt(1, m_views.back()), uniform(2, pass.block)},
        {pass.groups.x, pass.groups.y, way.slices});
}

void Frame::addBlur(const std::string& qualifier, const Texture& from, const Texture& between, const Texture& to,
                    bool maximum)
{
    const Rectangle map = whole(m_options.mapSize);
    const BlurKernel kernel = maximum ? boxKernel(static_cast<float>(m_options.blur), false)
                                      : gaussianKernel(m_options.blur, 2.0f, m_options.paired);
    const auto passes = blurPasses(kernel, map, map, glm::vec4(1.0f), 0, from.size.slices);
    const std::string macros = define("LVSM_BLUR_FORMAT", qualifier) +
                               define("LVSM_BLUR_FETCHES", std::to_string(kernel.fetchCount)) +
                               (maximum ? define("LVSM_BLUR_MAXIMUM", "") : "");
    const auto& sampler = m_options.paired && !maximum ? m_linear : m_nearest;
    const auto direction = [&](const Texture& source, const Texture& target, const auto& pass)
    {
        m_views.push_back(makeLevelView(m_context, target, 0));
        add(m_map, kPasses + "blur.comp", macros,
            {sampledAt(0, source.array, sampler), storageAt(1, m_views.back()), uniform(2, pass.block)},
            {pass.groups.x, pass.groups.y, pass.groups.z});
    };
    direction(from, between, passes.across);
    direction(between, to, passes.down);
}

void Frame::addLevels(const std::string& qualifier, const Texture& map, bool maximum)
{
    const std::string macros = define("LVSM_MIP_FORMAT", qualifier) + (maximum ? define("LVSM_MIP_MAXIMUM", "") : "");
    for (int level = 1; level < map.size.levels; ++level)
    {
        const auto pass = mipPass(whole(m_options.mapSize), level, 0, map.size.slices);
        m_views.push_back(makeLevelView(m_context, map, level - 1));
        const auto& before = m_views.back();
        m_views.push_back(makeLevelView(m_context, map, level));
        add(m_map, kPasses + "mip.comp", macros,
            {sampledAt(0, before, m_nearest), storageAt(1, m_views.back()), uniform(2, pass.block)},
            {pass.groups.x, pass.groups.y, pass.groups.z});
    }
}

void Frame::addShade(const Way& way, const Texture& map, const Texture& unfiltered, const Texture& greatest)
{
    const int layers = std::max(way.layers, 1);
    std::vector<float> splits;
    for (int i = 0; i <= layers; ++i)
        splits.push_back(uniformSplit<float>(i, layers));
    const auto width = static_cast<int>(m_options.view.width), height = static_cast<int>(m_options.view.height);
    const Texture& target =
        m_textures.emplace_back(makeTexture(m_context, support::Shape{width, height}, vk::Format::eR32Sfloat));
    const support::Buffer& buffer = m_buffers.emplace_back(makeBufferOf(m_context, splits));
    add(m_shade, kKernels + "shade.comp",
        define("LVSM_MAX_LAYERS", std::to_string(layers)) + define("VISIBILITY(at, depth)", way.visibility),
        {sampledAt(0, map.array, m_shading), sampledAt(1, unfiltered.array, m_nearest),
         sampledAt(2, greatest.array, m_nearest), storageAt(3, target.flat), bufferAt(4, buffer)},
        {(width + 7) / 8, (height + 7) / 8, 1});
}

std::function<void()> onePassBlur(const support::VulkanContext& context, int mapSize, int reach)
{
    struct Kept
    {
        support::Texture source, target;
        support::Buffer weights;
        vk::raii::Sampler sampler;
    };
    std::vector<float> weights;
    for (int i = 0; i <= 2 * reach; ++i)
        weights.push_back(gaussianWeight(i, 2 * reach + 1, 2.0f));
    const support::Shape shape{mapSize, mapSize};
    const auto kept = std::make_shared<Kept>(
        Kept{makeTexture(context, shape, support::kFormat), makeTexture(context, shape, support::kFormat),
             makeBufferOf(context, weights), support::makeSampler(context, vk::Filter::eNearest)});
    const std::vector<Binding> bindings{sampledAt(0, kept->source.array, kept->sampler),
                                        storageAt(1, kept->target.array), bufferAt(2, kept->weights)};
    const auto kernel = std::make_shared<support::Kernel>(
        context, compile(kKernels + "one_pass.comp", define("REACH", std::to_string(reach))), bindings);
    const auto groups = static_cast<std::uint32_t>(mapSize / 8);
    return [=]
    {
        kernel->run(bindings, groups, groups, 1);
        (void)kept;
    };
}

} // namespace lvsm::papers
