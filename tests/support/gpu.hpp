// Shaders with what they read and write: compute dispatches and drawing. One wrapper for the gallery and the tests.
#ifndef LVSM_TESTS_SUPPORT_GPU_HPP
#define LVSM_TESTS_SUPPORT_GPU_HPP

#include <algorithm>
#include <string>
#include <vector>

#include "texture.hpp"

namespace lvsm::support
{

template <typename T>
Buffer makeBufferOf(const VulkanContext& context, const std::vector<T>& values)
{
    using Usage = vk::BufferUsageFlagBits;
    Buffer buffer = makeBuffer(context, values.size() * sizeof(T),
                               Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eVertexBuffer |
                                   Usage::eTransferSrc | Usage::eTransferDst);
    std::copy(values.begin(), values.end(), reinterpret_cast<T*>(buffer.data));
    return buffer;
}

/// What a shader finds at a binding of set 0; for a layout alone, its index and type.
struct Binding
{
    std::uint32_t index;
    vk::DescriptorType type;
    vk::Buffer buffer = {};
    vk::ImageView view = {};
    vk::Sampler sampler = {};
};

Binding uniformAt(std::uint32_t index, const Buffer& buffer);
Binding bufferAt(std::uint32_t index, const Buffer& buffer);
/// A texture with its sampler.
Binding sampledAt(std::uint32_t index, const vk::raii::ImageView& view, const vk::raii::Sampler& sampler);
Binding storageAt(std::uint32_t index, const vk::raii::ImageView& view);

struct Shader
{
    std::vector<std::uint32_t> spirv;
    std::string entryPoint = "main";
};

/// The layout of a list of bindings.
class Layout
{
public:
    Layout(const VulkanContext& context, const std::vector<Binding>& bindings, vk::ShaderStageFlags stages);

    const vk::raii::PipelineLayout& pipeline() const { return m_pipeline; }

    /// Submits commands that find the bindings' resources bound, and waits.
    void submit(vk::PipelineBindPoint point, const std::vector<Binding>& bindings,
                const std::function<void(vk::raii::CommandBuffer&)>& record) const;

private:
    const VulkanContext& m_context;
    vk::raii::DescriptorSetLayout m_set;
    vk::raii::PipelineLayout m_pipeline;
};

/// A compute shader with its pipeline.
class Kernel
{
public:
    Kernel(const VulkanContext& context, const Shader& shader, const std::vector<Binding>& bindings);

    void run(const std::vector<Binding>& bindings, std::uint32_t groupsX, std::uint32_t groupsY,
             std::uint32_t groupsZ) const;

private:
    Layout m_layout;
    vk::raii::Pipeline m_pipeline;
};

/// Makes a Kernel and runs it once.
void dispatch(const VulkanContext& context, const Shader& shader, const std::vector<Binding>& bindings,
              std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ);

struct RasterOptions
{
    std::vector<vk::Format> colours;
    /// Undefined: no depth test.
    vk::Format depth = vk::Format::eUndefined;
    int samples = 1;
    /// Keeps what the targets hold, or clears them.
    bool keep = true;
    std::uint32_t vertexBytes = 0;
    std::vector<vk::VertexInputAttributeDescription> attributes;
};

/// A vertex and a fragment shader with their pipeline: triangles, seen from both sides.
class Raster
{
public:
    Raster(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
           const std::vector<Binding>& bindings, const RasterOptions& options);

    /// targets: the colours in the options' order, then the depth; likewise clears. vertices: none for shaders that
    /// need only their number.
    void draw(const std::vector<Binding>& bindings, const std::vector<vk::ImageView>& targets, vk::Extent2D extent,
              std::uint32_t vertexCount, const Buffer* vertices = nullptr,
              const std::vector<vk::ClearValue>& clears = {}) const;

private:
    const VulkanContext& m_context;
    Layout m_layout;
    vk::raii::RenderPass m_pass;
    vk::raii::Pipeline m_pipeline;
};

/// Draws over the whole of one slice of the target.
void draw(const VulkanContext& context, const Shader& vertex, const Shader& fragment,
          const std::vector<Binding>& bindings, const Texture& target, std::uint32_t slice);

} // namespace lvsm::support

#endif
