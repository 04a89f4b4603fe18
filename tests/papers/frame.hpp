// What a technique does in a frame, with the library's own passes and wrappers on a Vulkan device: store, blur, levels,
// shade. For times; lvsm_papers has the errors.
#ifndef LVSM_TESTS_PAPERS_FRAME_HPP
#define LVSM_TESTS_PAPERS_FRAME_HPP

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "gpu.hpp"

namespace lvsm::papers
{

/// A technique as passes/store and the shading kernel are told of it.
struct Way
{
    vk::Format format;
    std::string qualifier; ///< the format's name in GLSL
    int slices;
    int layers;             ///< of LVSM; 0 for others
    std::string store;      ///< macros of passes/store; empty for layers, "-" where the depths are the map
    std::string visibility; ///< of (at, depth), for kernels/shade.comp
    bool keepsUnfiltered = false;
    bool keepsGreatest = false;
};

Way vsm();
Way lvsm(int layers, bool transitions);
Way evsm4();
Way csm(int terms);
Way esm(bool byZMax);
/// Of depths as they are: the call of a wrapper, or of the plain test.
Way ofDepths(const std::string& visibility);
Way vsmNineSamples();

struct FrameOptions
{
    int mapSize = 1024;
    int blur = 1; ///< taps of a Gaussian of deviation 2, across and down
    bool paired = false;
    bool levels = false;
    bool anisotropic = false;
    vk::Extent2D view{640, 400};
};

class Frame
{
public:
    Frame(const support::VulkanContext& context, const Way& way, const FrameOptions& options);

    /// The passes that make the map.
    void makeMap() const;
    void shade() const;

private:
    using Pass = std::function<void()>;
    using Texture = support::Texture;

    const Texture& texture(int slices, int levels, vk::Format format);
    void add(std::vector<Pass>& passes, const std::string& file, const std::string& macros,
             std::vector<support::Binding> bindings, glm::ivec3 groups);
    template <typename Block>
    support::Binding uniform(std::uint32_t index, const Block& block);
    void addStore(const Way& way, const Texture& target);
    void addBlur(const std::string& qualifier, const Texture& from, const Texture& between, const Texture& to,
                 bool maximum);
    void addLevels(const std::string& qualifier, const Texture& map, bool maximum);
    void addShade(const Way& way, const Texture& map, const Texture& unfiltered, const Texture& greatest);

    const support::VulkanContext& m_context;
    FrameOptions m_options;
    std::deque<Texture> m_textures;
    std::deque<support::Buffer> m_buffers;
    std::deque<vk::raii::ImageView> m_views;
    std::deque<support::Kernel> m_kernels;
    vk::raii::Sampler m_nearest, m_linear, m_shading;
    const Texture* m_depths = nullptr;
    std::vector<Pass> m_map, m_shade;
};

/// A Gaussian of so many texels to each side in one pass, over a map of four 32-bit floats.
std::function<void()> onePassBlur(const support::VulkanContext& context, int mapSize, int reach);

} // namespace lvsm::papers

#endif
