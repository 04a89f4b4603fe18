#ifndef LVSM_GALLERY_GPU_HPP
#define LVSM_GALLERY_GPU_HPP

#include <cstring>
#include <string>
#include <variant>
#include <vector>

#include "shader_compiler.hpp"
#include "vulkan_context.hpp"

namespace lvsm::gallery
{

using support::Buffer;
using support::VulkanContext;

/// A two-dimensional array image with one mip level, always in the general layout.
struct Image
{
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Image image{nullptr};
    vk::raii::ImageView view{nullptr};
    vk::Format format = vk::Format::eUndefined;
    vk::Extent2D extent;
    std::uint32_t layers = 1;
};

Image makeImage(const VulkanContext& gpu, vk::Format format, vk::Extent2D extent, std::uint32_t layers,
                vk::ImageUsageFlags usage);

/// The first array layer's texels, row by row from the top.
std::vector<std::byte> readBytes(const VulkanContext& gpu, const Image& image, std::size_t texelBytes);

template <typename Texel>
std::vector<Texel> readImage(const VulkanContext& gpu, const Image& image)
{
    const std::vector<std::byte> bytes = readBytes(gpu, image, sizeof(Texel));
    std::vector<Texel> texels(bytes.size() / sizeof(Texel));
    std::memcpy(texels.data(), bytes.data(), bytes.size());
    return texels;
}

template <typename T>
Buffer makeUniform(const VulkanContext& gpu, const T& block)
{
    Buffer buffer = support::makeBuffer(gpu, sizeof block, vk::BufferUsageFlagBits::eUniformBuffer);
    std::memcpy(buffer.data, &block, sizeof block);
    return buffer;
}

/// Compiles a file of the gallery's shader folder; throws with the compiler's log.
std::vector<std::uint32_t> compile(const std::string& file, support::ShaderStage stage,
                                   const std::string& preamble = "");
/// Compiles text that includes the gallery's files; throws with the compiler's log.
std::vector<std::uint32_t> compileText(const std::string& text, support::ShaderStage stage,
                                       const std::string& preamble);

struct Uniform
{
    const Buffer& buffer;
};
struct Sampled
{
    const Image& image;
};
struct Storage
{
    const Image& image;
};
using Resource = std::variant<Uniform, Sampled, Storage>;

/// A compute shader with its pipeline. Resources are bound in order: binding 0, 1, 2, ...
class Kernel
{
public:
    Kernel(const VulkanContext& gpu, const std::vector<std::uint32_t>& spirv, std::vector<vk::DescriptorType> bindings,
           std::uint32_t pushBytes = 0);

    /// One invocation for each texel of `extent` in each of `layers`.
    void run(const std::vector<Resource>& resources, vk::Extent2D extent, std::uint32_t layers = 1,
             const void* push = nullptr) const;

private:
    const VulkanContext& m_gpu;
    std::vector<vk::DescriptorType> m_bindings;
    std::uint32_t m_pushBytes;
    vk::raii::Sampler m_sampler;
    vk::raii::DescriptorSetLayout m_setLayout;
    vk::raii::PipelineLayout m_layout;
    vk::raii::Pipeline m_pipeline;
};

} // namespace lvsm::gallery

#endif
