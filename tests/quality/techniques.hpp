#ifndef LVSM_TESTS_QUALITY_TECHNIQUES_HPP
#define LVSM_TESTS_QUALITY_TECHNIQUES_HPP

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filter.hpp"
#include "truth.hpp"

namespace lvsm::quality
{

/// A tap as a technique sees it: one decision from what is stored around one place.
struct Query
{
    const Image& image;   ///< what is stored, filtered and coded
    const float* texel;   ///< a sample of it there; the texel itself for what is not filterable
    int x, y;             ///< the texel whose centre is nearest
    glm::vec2 offset;     ///< from that centre, in texels
    float depth;          ///< the receiver's, moved towards the light
    glm::vec2 gradient;   ///< the receiver's, over a texel of the image
    float deviation;      ///< of the image's filter, in texels of the image
    float slopeVariance;  ///< floor that its slope asks for, in depth squared
    float storedVariance; ///< floor that the format's rounding asks for, in the square of what is stored in [0,1]
    float bias;           ///< times the bias that rounding asks for
    float contact;        ///< light bleeding reduction inside the estimate, for what has it
    glm::vec2 stride;     ///< between the samples of an anisotropic look-up, in texels of the image
    int samples;          ///< of an anisotropic look-up; 1 is a bilinear sample
    glm::vec2 direction;  ///< of the receiver's footprint

    /// A sample of one channel, so many texels away.
    float sample(int dx, int dy, int channel) const
    {
        float sum = 0.0f;
        const glm::vec2 centre = glm::vec2(x, y) + offset + glm::vec2(dx, dy);
        for (int i = 0; i < samples; ++i)
            sum += image.bilinear(centre + (static_cast<float>(i) - 0.5f * static_cast<float>(samples - 1)) * stride,
                                  channel);
        return sum / static_cast<float>(samples);
    }
};

/// What one technique stores for a texel and makes of it afterwards, for one scene.
class Estimator
{
public:
    virtual ~Estimator() = default;
    virtual void store(const Surface& nearest, float* texel) const = 0;
    /// For what is coded after the filter: what is read back of a filtered texel, in place.
    virtual void code(float*) const {}
    virtual float visibility(const Query& query) const = 0;
    /// What is lit at least, where visibility says how much at most; the same where that is no bound.
    virtual float least(const Query& query) const { return visibility(query); }
};

/// What a technique may look at before it stores anything: the shadow map's depths, and the filter.
struct Map
{
    const Peel& peel;
    Window window;
    Footprint footprint = {};
    int level = 0;        ///< a texel for 1, 2 x 2, 4 x 4, ... of the shadow map; for what filters by itself
    bool decoded = false; ///< whether four decisions are mixed; likewise
};

/// How what is stored is read between texels.
enum class Reading
{
    Bilinear, ///< by hardware, or four fetches and a mix
    Decoded,  ///< four decisions, mixed
    Nearest,  ///< one decision from the nearest texel, which moves it to the receiver's place
    Window    ///< of depths as they are: the estimate reads the whole window itself, and nothing is filtered
};

/// What a technique that filters by itself is judged with, which its documents derive; nothing is chosen for it.
struct Own
{
    float shift; ///< of the receiver
};

using Prepare = std::function<std::unique_ptr<Estimator>(const Map&)>;

/// A technique. To add one: an Estimator in techniques_KIND.cpp, and its rows in allTechniques().
struct Technique
{
    std::string name;
    bool peer; ///< somebody else's, with published constants
    int bits;  ///< a texel; 0 for a limit, which no storage reaches
    int channels;
    Format format; ///< what each channel is rounded to after the filter; Fp32 for what code() rounds itself
    bool floors;   ///< whether a variance floor means anything to it
    Prepare prepare;
    std::string estimate = {}; ///< its row in tests/cost/estimates.def; none, and its cost is unknown
    Reading reading = Reading::Bilinear;
    bool bias = false;     ///< whether the bias against rounding may be chosen, as a floor is
    bool contact = false;  ///< whether light bleeding is reduced inside the estimate, not afterwards
    bool variants = false; ///< also with 4, 9, 16 and 25 taps, and at half resolution
    double cut = 0.0;      ///< deviations of the window to each side that it reads; 0 for all of it
    std::vector<Prepare> warps =
        {};                      ///< in place of prepare: that warp of depth is chosen which errs least in other lights
    std::optional<Own> own = {}; ///< filters by itself: prepared anew for each variant, of which it has half resolution

    /// The estimate's row where its map is read so.
    std::string estimateBy(Reading how) const { return estimate + (how == Reading::Nearest ? " moved" : ""); }
};

/// Everything that is measured, limits last.
std::vector<Technique> allTechniques();

/// The one of allTechniques with this name; throws std::out_of_range where there is none.
Technique techniqueNamed(const std::string& name);

// Its parts.
std::vector<Technique> varianceTechniques(); // VSM, EVSM2, EVSM4
std::vector<Technique> otherPeers();         // ESM, CSM
std::vector<Technique> pcfPeers();           // PCF
std::vector<Technique> momentTechniques();   // MSM4, quantised and in layers; trigonometric
std::vector<Technique> layeredTechniques();  // LVSM, as in the paper and bracketed
std::vector<Technique> mixtureTechniques();  // planes, merged
std::vector<Technique> limits();

/// What planeBracketedVisibility and bracketedBoundedVisibility would be without a part of theirs, or in fewer operations;
/// LVSM-8 in unorm8 judged by each.
using PlaneForm = float (*)(const glm::vec2&, const glm::vec2&, const glm::vec2&, const glm::vec3&, float,
                            const glm::vec2&, float, float, float);
using BoundedForm = float (*)(const glm::vec2&, const glm::vec2&, const glm::vec2&, float, const glm::vec2&, float);
Technique planeForm(const std::string& name, PlaneForm form);
Technique boundedForm(const std::string& name, BoundedForm form);
std::vector<Technique> layeredForms();

/// A convolution shadow map of so many terms, with their attenuation; offset, or scaled to full light.
Technique csm(int order, float strength, bool offset);

/// A technique whose estimator needs nothing from the scene but what its constructor is given here.
template <typename E, typename... Arguments>
Prepare fixed(Arguments... arguments)
{
    return [arguments...](const Map&)
    {
        return std::make_unique<E>(arguments...);
    };
}

/// Change of depth over a texel as far as it counts as the texel's own slope, not as an edge.
inline glm::vec2 ownSlope(const Surface& nearest)
{
    constexpr float kEdge = 0.01f;
    const glm::vec2 g = nearest.gradient;
    return {std::abs(g.x) < kEdge ? g.x : 0.0f, std::abs(g.y) < kEdge ? g.y : 0.0f};
}

} // namespace lvsm::quality

#endif
