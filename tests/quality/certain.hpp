// Certain or not: bounds on both sides tell who is surely lit or dark, so that only the rest pays for PCF.
#ifndef LVSM_TESTS_QUALITY_CERTAIN_HPP
#define LVSM_TESTS_QUALITY_CERTAIN_HPP

#include "measure.hpp"
#include "report.hpp"

namespace lvsm::quality
{

/// What tells who is certain: one of some techniques, which is chosen as their settings are.
struct Judge
{
    std::string name;
    bool peer;
    std::vector<Technique> techniques;
};

std::vector<Judge> judges(const Window& window);

/// The technique that says what is lit at least, where this one says how much at most.
Technique leastOf(const Technique& technique);

// Judges that know the least and the greatest depth around a place, in a few parts: from a map where each texel has those
// of all that are so near, or from a pyramid. Such a bound is 0 or 1.
std::vector<Technique> widenedRanges(const Window& window);
std::vector<Technique> pyramidRanges(const Window& window);

/// How one judge does in one light.
struct Certainty
{
    std::string judge;
    bool peer;
    std::string technique; ///< that was chosen
    std::string scene;
    int width;
    double rmse;       ///< of what is certain as 0 or 1 and the rest by PCF
    double pcf;        ///< RMSE of PCF for all
    double uncertain;  ///< share of receivers that are
    double groups;     ///< share of groups of 8 x 8 pixels, each a texel of the map, with one that is
    double magnified;  ///< likewise where a pixel is a quarter of a texel wide
    double bound, all; ///< units of the bound, for its upper side alone, and of PCF
};

/// For each light that is reported. The technique, its setting, and from where on it counts as certain, are such that in
/// the other lights the bound and PCF for the groups cost least together, with at most 1.05 times PCF's error.
std::vector<Certainty> measureCertainty(const Judge& judge, const std::vector<LitScene>& lights, const Window& window,
                                        const Costs& costs);

/// Writes them as JSON, all or nothing; the reason if that fails.
std::optional<std::string> writeCertainty(const std::vector<Certainty>& found, const std::string& path);

} // namespace lvsm::quality

#endif
