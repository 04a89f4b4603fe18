#ifndef LVSM_GALLERY_LIGHT_DEPTHS_HPP
#define LVSM_GALLERY_LIGHT_DEPTHS_HPP

#include <vector>

#include "light.hpp"
#include "shaders.hpp"

namespace lvsm::gallery
{

/// A light's depth buffers, and what the library's passes need to read them.
struct LightDepths
{
    Texture buffer;
    std::vector<vk::raii::ImageView> faces;
    /// The block that converts them.
    Buffer block;
    /// The same as linear depths, a slice to a face.
    Texture linear;

    int faceCount() const { return buffer.size.slices; }
    Rectangle area() const { return {0, 0, buffer.size.width, buffer.size.height}; }
};

/// Where the depths' block is bound, and the macro that tells the passes.
constexpr std::uint32_t kDepthBlockBinding = 4;
std::string depthMacro();

/// The bindings of a pass that reads a face and writes to a texture: 0, 1 and the block of the depths.
std::vector<support::Binding> faceBindings(const LightDepths& depths, int face, const Texture& target,
                                           const vk::raii::Sampler& sampler);

/// A pass that stores, with what follows LVSM_STORE(depth, slice), or layers where that is empty.
Kernel makeStore(const VulkanContext& gpu, const std::string& file, const std::string& store, const std::string& format,
                 const std::string& largest);

/// Tells a buffer of StoreBlock with which slice the next pass begins; what it has of splits stays as it is.
void beginAtSlice(const Buffer& storeBlock, int slice);

class DepthReader
{
public:
    explicit DepthReader(const VulkanContext& gpu);

    LightDepths read(Texture buffer, const Light& light) const;

private:
    const VulkanContext& m_gpu;
    Kernel m_store;
    vk::raii::Sampler m_sampler;
};

} // namespace lvsm::gallery

#endif
