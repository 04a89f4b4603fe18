#ifndef LVSM_GALLERY_TECHNIQUES_HPP
#define LVSM_GALLERY_TECHNIQUES_HPP

#include <array>
#include <string>
#include <vector>

#include <glm/vec4.hpp>
#include <vulkan/vulkan.hpp>

namespace lvsm::gallery
{

/// What a texel of a map is.
struct Storage
{
    vk::Format format;
    /// The same as a GLSL layout qualifier.
    const char* qualifier;
    const char* words;
    int bits;
    /// Of a depth that is stored, in depth.
    float depthError;
    /// The largest value, as GLSL.
    const char* largest;
};

/// Which of the library's passes make a map from a depth buffer.
enum class Making
{
    /// Store alone: what is read is filtered when it is judged, or not at all.
    Stored,
    /// Store and blur, fused.
    Blurred,
    /// The same, and beside the map the unblurred one.
    BlurredBeside,
    /// The same, and the greatest depths under the blur.
    BlurredWithGreatest,
    /// Mixtures, whose window is their blur.
    Mixed
};

/// Where the splits of layers come from: the last three from the placement passes, on the device.
enum class Placing
{
    None,
    Uniform,
    /// At the points that the scene names.
    Manual,
    Relaxed,
    /// By what the camera sees.
    InView,
    Optimal
};

struct Layers
{
    int count = 1;
    Placing placing = Placing::None;
    float overlap = 0.0f;
    float transition = 0.0f;
};

/// The filter that a technique approximates, for the truth: see shaders/exact.comp.
struct Window
{
    std::string id;
    int reach;
    float extent;
    float deviation;
    std::vector<float> taps;
};

struct Technique
{
    std::string id;
    std::string title;
    /// One sentence for the reader of the page.
    std::string explanation;
    const Storage* texel;
    /// Array layers of the map.
    int slices;
    Making making;
    /// What slice number `slice` holds for a `depth`, as LVSM_STORE has it; empty for the library's layers.
    std::string store;
    /// The call of a wrapper; see shaders/shade.comp for what it may use.
    std::string visibility;
    const Window* window;
    /// What an empty texel of each slice holds; one for all where they are alike.
    std::vector<glm::vec4> border;
    Layers layers;
    /// Shown without --full.
    bool quick;

    // Filled in from the rest.
    int layerCount = 1;
    /// The storage format in words, and what it takes.
    std::string storage{};
    int bits = 0;
};

/// The window of the blur that most maps have.
const Window& blurWindow();

/// All techniques, one row each.
const std::vector<Technique>& techniques();

} // namespace lvsm::gallery

#endif
