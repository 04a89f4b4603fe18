// The relaxation by fragment passes, drawn by Vulkan.
#include "steps_truth.hpp"

namespace sampling
{
namespace
{

using Type = vk::DescriptorType;

// The passes and what they keep from frame to frame.
class Steps
{
public:
    Steps(VulkanContext& context, const Form& form, int layerCount, int slices)
        : m_context(context), m_form(form), m_sampler(makeSampler(context, vk::Filter::eNearest)),
          m_sums(makeTexture(context, Shape{kMap.width, kMap.height, slices, lvsm::levelCount(kMap)}, kFormat)),
          m_states{stateOf(layerCount), stateOf(layerCount)},
          m_vertex(compile({"combined", form.glslFolder, form.hlslFolder, form.kernelFolder, {}},
                           form.kernelFolder + "/triangle.vert", vk::ShaderStageFlagBits::eVertex, "main", "")),
          m_sum(raster("step_sums", "step", "lvsm_stepSumsPixel", sumsAt({}, {}, {}))),
          m_mip(raster("mip", "mip", "lvsm_mipPixel", mipAt({}, {}))),
          m_move(raster("step_move", "step", "lvsm_stepMovePixel", moveAt({}, {}, {})))
    {
    }

    State draw(lvsm::PlaceStep step, const Depths& image)
    {
        const Texture depths = makeTexture(m_context, image.pixels);
        const int last = m_sums.size.levels - 1;
        for (int slice = 0; slice < step.slices; ++slice)
        {
            step.block.slice = slice;
            const Buffer block = makeBufferOf(m_context, std::vector{step.block});
            drawTo(m_sum, sumsAt(*depths.flat, *m_states[0].flat, *block.buffer), m_sums, slice, 0);
            for (int level = 1; level <= last; ++level)
            {
                auto pass = lvsm::mipPass(step.sums, level);
                pass.block.slice = slice;
                const Buffer mip = makeBufferOf(m_context, std::vector{pass.block});
                const auto before = makeLevelView(m_context, m_sums, level - 1);
                drawTo(m_mip, mipAt(*before, *mip.buffer), m_sums, slice, level);
            }
        }
        const Buffer block = makeBufferOf(m_context, std::vector{step.block});
        const auto means = makeLevelView(m_context, m_sums, last);
        drawTo(m_move, moveAt(*means, *m_states[0].flat, *block.buffer), m_states[1], 0, 0);
        std::swap(m_states[0], m_states[1]);
        State state;
        for (const glm::vec4& texel : readBack(m_context, m_states[0]).texels)
            state.insert(state.end(), {texel.x, texel.y, texel.z, texel.w});
        return state;
    }

private:
    Texture stateOf(int layerCount) const
    {
        Pixels pixels(kStateWidth, 2);
        const State state = startState(layerCount);
        for (std::size_t i = 0; i < state.size(); ++i)
            pixels.texels[i / 4][static_cast<int>(i % 4)] = state[i];
        return makeTexture(m_context, pixels);
    }

    Binding textureAt(std::uint32_t index, vk::ImageView view) const
    {
        if (m_form.isHlsl())
            return {index, Type::eSampledImage, {}, view};
        return {index, Type::eCombinedImageSampler, {}, view, *m_sampler};
    }

    std::vector<Binding> sumsAt(vk::ImageView depths, vk::ImageView state, vk::Buffer block) const
    {
        return {textureAt(0, depths), textureAt(1, state), {2, Type::eUniformBuffer, block}};
    }

    std::vector<Binding> mipAt(vk::ImageView source, vk::Buffer block) const
    {
        return {textureAt(0, source), {2, Type::eUniformBuffer, block}};
    }

    std::vector<Binding> moveAt(vk::ImageView sums, vk::ImageView state, vk::Buffer block) const
    {
        return {textureAt(m_form.isHlsl() ? 3 : 0, sums), textureAt(1, state), {2, Type::eUniformBuffer, block}};
    }

    Raster raster(const std::string& glsl, const std::string& hlsl, const std::string& entry,
                  const std::vector<Binding>& bindings) const
    {
        const bool isHlsl = m_form.isHlsl();
        const std::string path = isHlsl ? m_form.hlslFolder + "/lvsm/passes/" + hlsl + ".hlsl"
                                        : m_form.glslFolder + "/lvsm/passes/" + glsl + ".frag";
        RasterOptions options;
        options.colours = {kFormat};
        return {m_context, m_vertex,
                compile(m_form, path, vk::ShaderStageFlagBits::eFragment, isHlsl ? entry : "main", ""), bindings,
                options};
    }

    void drawTo(const Raster& raster, const std::vector<Binding>& bindings, const Texture& target, int slice,
                int level) const
    {
        const auto view = makeSliceView(m_context, target, slice, level);
        raster.draw(bindings, {*view},
                    {static_cast<std::uint32_t>(std::max(target.size.width >> level, 1)),
                     static_cast<std::uint32_t>(std::max(target.size.height >> level, 1))},
                    3);
    }

    VulkanContext& m_context;
    const Form& m_form;
    vk::raii::Sampler m_sampler;
    Texture m_sums;
    Texture m_states[2];
    Shader m_vertex;
    Raster m_sum;
    Raster m_mip;
    Raster m_move;
};

} // namespace

bool checkSteps(VulkanContext& context, const Form& form)
{
    const std::vector<Depths> images = stillImages();
    bool passed = true;
    for (const bool inPairs : {false, true})
    {
        Comparison steps(inPairs ? "steps of two splits" : "steps of all splits");
        Comparison ends("where steps of all come to rest");
        for (const int layerCount : {3, kMaxLayers})
        {
            for (std::size_t i = 0; i < images.size(); ++i)
            {
                Steps passes(context, form, layerCount, inPairs ? 1 : std::max(layerCount / 2, 1));
                const auto draw = [&](const lvsm::PlaceStep& step, const Depths& image)
                {
                    return passes.draw(step, image);
                };
                compareSteps({images[i], layerCount, inPairs, i == kNoise,
                              std::to_string(layerCount) + " layers, image " + std::to_string(i)},
                             draw, steps, ends);
            }
        }
        passed = steps.passed() && passed;
        passed = (inPairs || ends.passed()) && passed;
    }
    return passed;
}

} // namespace sampling
