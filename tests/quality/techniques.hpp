#ifndef LVSM_TESTS_QUALITY_TECHNIQUES_HPP
#define LVSM_TESTS_QUALITY_TECHNIQUES_HPP

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "formats.hpp"
#include "image.hpp"
#include "peel.hpp"

namespace lvsm::quality
{

/// A receiver as a technique sees it.
struct Query
{
    const Image& image; ///< stored and filtered channels
    const float* texel; ///< those of the receiver's texel
    int x, y;
    float depth;          ///< the receiver's, moved towards the light
    glm::vec2 gradient;   ///< the receiver's
    float slopeVariance;  ///< floor that its slope asks for, in depth squared
    float storedVariance; ///< floor that the format's rounding asks for, in the square of what is stored in [0,1]
};

/// What one technique stores for a texel and makes of it afterwards, for one scene.
class Estimator
{
public:
    virtual ~Estimator() = default;
    virtual void store(const Surface& nearest, float* texel) const = 0;
    virtual float visibility(const Query& query) const = 0;
};

/// What a technique may look at before it stores anything: the shadow map's depths, and the filter.
struct Map
{
    const Peel& peel;
    const std::vector<double>& kernel;
    float deviation; ///< of the filter, in texels
};

struct Technique
{
    std::string name;
    bool peer; ///< somebody else's, with published constants
    int bits;  ///< a texel; 0 for a limit, which no storage reaches
    int channels;
    Format format;
    bool floors; ///< whether a variance floor means anything to it
    std::function<std::unique_ptr<Estimator>(const Map&)> prepare;
    int taps = 1; ///< 1, or 4: see fourTaps
};

/// The same technique judged four times, from samples half a texel away in x and in y. The filter is two taps narrower:
/// with the bilinear samples and the mean of the four it covers the same window with the same weights. Each sample is
/// compared with the receiver's plane there.
Technique fourTaps(Technique technique);

/// Everything that is measured, limits last.
std::vector<Technique> allTechniques();

// Its parts.
std::vector<Technique> varianceTechniques(); // VSM, EVSM2, EVSM4
std::vector<Technique> otherPeers();         // ESM, CSM
std::vector<Technique> momentTechniques();   // MSM4, and layers of it
std::vector<Technique> layeredTechniques();  // LVSM, as in the paper and bracketed
std::vector<Technique> limits();

/// A technique whose estimator needs nothing from the scene but what its constructor is given here.
template <typename E, typename... Arguments>
std::function<std::unique_ptr<Estimator>(const Map&)> fixed(Arguments... arguments)
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
