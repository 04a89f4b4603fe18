// What certain.cpp chooses from: the answers of one technique's bounds on both sides, and what they cost and err.
#ifndef LVSM_TESTS_QUALITY_CERTAIN_TRIAL_HPP
#define LVSM_TESTS_QUALITY_CERTAIN_TRIAL_HPP

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <vector>

#include "measure.hpp"

namespace lvsm::quality
{

/// What may be lit at most to be dark, and dark at most to be lit.
constexpr std::array<float, 7> kRooms{0.0f, 0.005f, 0.015f, 0.04f, 0.08f, 0.15f, 0.25f};
constexpr std::size_t kPairs = kRooms.size() * kRooms.size();
using Pairs = std::array<double, kPairs>; ///< a value for each room to be dark, and to be lit

struct Answer
{
    std::size_t dark, lit; ///< the first room that it is with, or as many as there are

    bool isDark(std::size_t pair) const { return pair / kRooms.size() >= dark; }
    bool isLit(std::size_t pair) const { return pair % kRooms.size() >= lit; }
};

/// Both bounds of one technique in one light.
class Bounds
{
public:
    Bounds(const Technique& technique, const LitScene& light, const Window& window);

    Answer answer(const Receiver& r, const Setting& setting) const;

    /// The share of groups with one that is uncertain, of so many groups at most.
    Pairs groups(const Peel& peel, const std::vector<Receiver>& receivers, std::size_t most, float pixel,
                 const Setting& setting) const;

private:
    Technique m_mostBy, m_leastBy; // which the maps know
    StoredMap m_most, m_least;
};

struct Sums
{
    Pairs squares{}, uncertain{}; ///< means over the receivers, the first weighted by n.l
    double pcf = 0.0;
};

/// answers: of the first receivers. pcf: errors of each receiver.
Sums sumsOf(const std::vector<Receiver>& receivers, const std::vector<Answer>& answers, const std::vector<double>& pcf);

/// One technique in all lights, for any setting, worked out when first asked for.
class Trial
{
public:
    Trial(const Technique& technique, double units, const std::vector<LitScene>& lights, const Window& window);

    struct Choice
    {
        double cost = std::numeric_limits<double>::infinity(); ///< and a penalty for too much error
        Setting setting = kPlainSetting;
        std::size_t pair = 0;
    };

    /// The best for one light by the others. pcf: errors of each light.
    Choice best(std::size_t light, const std::vector<std::vector<double>>& pcf, double pcfUnits);

    const Bounds& bounds(std::size_t light) const { return *m_bounds[light]; }
    double units() const { return m_units; }

private:
    struct Answers
    {
        std::vector<Answer> receivers;
        Pairs groups;
    };

    const Answers& answers(const Settings::Index& index, std::size_t light);
    Choice choice(const Settings::Index& index, std::size_t light, const std::vector<std::vector<double>>& pcf,
                  double pcfUnits);

    Settings m_settings;
    double m_units;
    const std::vector<LitScene>& m_lights;
    std::vector<std::unique_ptr<Bounds>> m_bounds; // which stay where they are: their maps know their techniques
    std::map<std::pair<Settings::Index, std::size_t>, Answers> m_answers;
};

} // namespace lvsm::quality

#endif
