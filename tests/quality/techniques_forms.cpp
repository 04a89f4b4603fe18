// What each part of the estimates from layers is worth: the estimates again, less one part each, or in fewer operations.
// lvsm_cost tells what the same saves, by the same names in tests/cost/forms.cpp.
#include <cmath>
#include <stdexcept>

#include <lvsm/plane.hpp>

#include "techniques.hpp"

namespace lvsm::quality
{
namespace
{

enum class Part
{
    None,
    FrontDeparture,
    BehindDeparture,
    OwnDeparture,
    PlaneVariance,
    Front,
    Behind,
    Parabolas,
    Bleeding,
    PlaneFloor,
    Sums,         ///< nothing is divided by the share that is left, and the interval's length once for all
    SumsAndFront, ///< that, without the departure in front
    NeighbourFloor,
    Room
};

/// boundedUpperBound of a mass.
float boundedMass(float mass, float m1, float m2, float t, float floor)
{
    const float tail = detail::chebyshevMass(mass, m1, m2, t, floor);
    const float inverse = 1.0f / std::max(t, kTiny<float>);
    const float parabolas = (std::min(m1, m1 * t + (m1 - m2)) + 2.25f * floor * inverse) * inverse;
    return t > 0.0f ? std::min(tail, parabolas) : mass;
}

template <Part kWithout>
float planeLess(const glm::vec2& front, const glm::vec2& moments, const glm::vec2& behind, const glm::vec3& covariances,
                float depth, const glm::vec2& interval, float variance, float minVariance, float amount)
{
    constexpr bool kSums = kWithout == Part::Sums || kWithout == Part::SumsAndFront;
    const auto kept = [](Part part, float value)
    {
        return part == kWithout ? 0.0f : value;
    };
    const float spread = glm::clamp(variance, 0.0f, 1.0f);
    const float scale = 1.0f / glm::clamp(interval.y - interval.x, 0.0009765625f, 1.0f);
    const float least = std::max(minVariance, kept(Part::PlaneFloor, 0.1f * spread));
    const float floor = kSums ? std::min(least * (scale * scale), 0.25f) : layerMinVariance(least, interval);
    const glm::vec4 left = bracketMoments(kWithout == Part::Front ? glm::vec2(1.0f) : front, moments,
                                          kWithout == Part::Behind ? glm::vec2(0.0f) : behind, floor);
    const glm::vec3 departures = scale * glm::clamp(covariances, -1.0f, 1.0f);
    const float shareInFront = std::max(1.0f - left.x - left.y, 0.0f);
    float inFront = kept(Part::FrontDeparture, departures.x * shareInFront / glm::clamp(1.0f - front.x, 0.001f, 1.0f));
    inFront = kept(Part::SumsAndFront, inFront);
    const float beyond = kept(Part::BehindDeparture, departures.z * left.x / glm::clamp(behind.x, 0.001f, 1.0f));
    const float own = kept(Part::OwnDeparture, departures.y);
    const float m1 = left.z + (beyond - inFront);
    const float m2 = left.w - 2.0f * (own - beyond) + kept(Part::PlaneVariance, left.y * (spread * (scale * scale)));
    const float less = kept(Part::Bleeding, amount);
    if (kSums)
    {
        const float t = glm::clamp((depth - interval.x) * scale, 0.0f, 1.0f);
        const float share = boundedMass(left.y, glm::clamp(m1, 0.0f, left.y), glm::clamp(m2, 0.0f, left.y), t, floor);
        const float most = glm::clamp(less, 0.0f, 0.999f);
        return glm::clamp(left.x + glm::clamp((share - most * left.y) * (1.0f / (1.0f - most)), 0.0f, left.y), 0.0f,
                          1.0f);
    }
    const float t = layerWarp(depth, interval);
    const float inverse = 1.0f / std::max(left.y, 0.001f);
    const glm::vec2 means(m1 * inverse, m2 * inverse);
    const float bound = kWithout == Part::Parabolas ? chebyshevUpperBound(means, t, floor * inverse)
                                                    : boundedUpperBound(means, t, floor * inverse);
    return glm::clamp(left.x + left.y * reduceLightBleeding(bound, less), 0.0f, 1.0f);
}

template <Part kWithout>
float boundedLess(const glm::vec2& front, const glm::vec2& moments, const glm::vec2& behind, float depth,
                  const glm::vec2& interval, float minVariance)
{
    const float floor = layerMinVariance(minVariance, interval);
    const float neighbours = kWithout == Part::NeighbourFloor ? floor : std::max(kNeighbourMinVariance<float>, floor);
    const glm::vec4 left = bracketMoments(kWithout == Part::Front ? glm::vec2(1.0f) : front, moments,
                                          kWithout == Part::Behind ? glm::vec2(0.0f) : behind, neighbours);
    const float t = layerWarp(depth, interval);
    const float tail = detail::chebyshevMass(left.y, left.z, left.w, t, floor);
    if (kWithout == Part::Parabolas)
        return glm::clamp(left.x + tail, 0.0f, 1.0f);
    const float inverse = 1.0f / std::max(t, kTiny<float>);
    const float room = kWithout == Part::Room ? 0.0f : 2.25f * floor * inverse;
    const float parabolas = (std::min(left.z, left.z * t + (left.z - left.w)) + room) * inverse;
    return glm::clamp(left.x + (t > 0.0f ? std::min(tail, parabolas) : left.y), 0.0f, 1.0f);
}

// The forms are written anew here: with all parts they have to be what the library has.
void checkWhole()
{
    for (int i = 0; i < 1000; ++i)
    {
        const auto at = [i](int k)
        {
            return glm::fract(0.6180339f * static_cast<float>(i + 1) * static_cast<float>(k));
        };
        const glm::vec2 front(1.0f - 0.5f * at(1), 1.0f - 0.5f * at(1) * (1.0f + at(2))), behind(at(3), at(3) * at(4));
        const glm::vec2 moments(at(5), at(5) * at(6)), interval(0.5f * at(7), 0.5f + 0.5f * at(8));
        const glm::vec3 covariances(0.01f * (at(9) - 0.5f), 0.01f * (at(10) - 0.5f), 0.01f * (at(11) - 0.5f));
        const float depth = interval.x + at(12) * (interval.y - interval.x), variance = 0.01f * at(13);
        const float plane =
            planeBracketedVisibility(front, moments, behind, covariances, depth, interval, variance, 1e-5f, 0.15f);
        const float bounded = bracketedBoundedVisibility(front, moments, behind, depth, interval, 1e-5f);
        if (std::abs(plane - planeLess<Part::None>(front, moments, behind, covariances, depth, interval, variance,
                                                   1e-5f, 0.15f)) > 1e-5f ||
            std::abs(bounded - boundedLess<Part::None>(front, moments, behind, depth, interval, 1e-5f)) > 1e-5f)
            throw std::logic_error("techniques_forms.cpp does not know how the library judges layers now");
    }
}

} // namespace

std::vector<Technique> layeredForms()
{
    checkWhole();
    return {planeForm("plane", &planeBracketedVisibility),
            planeForm("plane: departure in front", &planeLess<Part::FrontDeparture>),
            planeForm("plane: departure behind", &planeLess<Part::BehindDeparture>),
            planeForm("plane: own departure", &planeLess<Part::OwnDeparture>),
            planeForm("plane: the plane's variance", &planeLess<Part::PlaneVariance>),
            planeForm("plane: share in front", &planeLess<Part::Front>),
            planeForm("plane: share behind", &planeLess<Part::Behind>),
            planeForm("plane: parabolas", &planeLess<Part::Parabolas>),
            planeForm("plane: bleeding reduced", &planeLess<Part::Bleeding>),
            planeForm("plane: a tenth as a floor", &planeLess<Part::PlaneFloor>),
            planeForm("plane in sums", &planeLess<Part::Sums>),
            planeForm("plane in sums: departure in front", &planeLess<Part::SumsAndFront>),
            boundedForm("bounded", &bracketedBoundedVisibility),
            boundedForm("bounded: parabolas", &boundedLess<Part::Parabolas>),
            boundedForm("bounded: room for rounding", &boundedLess<Part::Room>),
            boundedForm("bounded: share in front", &boundedLess<Part::Front>),
            boundedForm("bounded: share behind", &boundedLess<Part::Behind>),
            boundedForm("bounded: floor of neighbours", &boundedLess<Part::NeighbourFloor>)};
}

} // namespace lvsm::quality
