#include "certain.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "whole_file.hpp"

namespace lvsm::quality
{
namespace
{

constexpr double kAllowed = 1.05;              // of PCF's RMSE, in the lights that settings are chosen on
constexpr std::size_t kChoiceReceivers = 1500; // of each light, to choose on
constexpr std::size_t kChoiceGroups = 100;     // likewise
constexpr std::size_t kGroups = 400;           // to report
constexpr const char* kPcf = "PCF, window cut at 2 deviations";

// What may be lit at most to be dark, and dark at most to be lit.
constexpr std::array<float, 7> kRooms{0.0f, 0.005f, 0.015f, 0.04f, 0.08f, 0.15f, 0.25f};
constexpr std::size_t kPairs = kRooms.size() * kRooms.size();
using Pairs = std::array<double, kPairs>; ///< a value for each room to be dark, and to be lit

struct Answer
{
    std::size_t dark, lit; ///< the first room that it is with, or as many as there are

    bool isDark(std::size_t pair) const { return pair / kRooms.size() >= dark; }
    bool isLit(std::size_t pair) const { return pair % kRooms.size() >= lit; }
};

Technique named(const std::string& name)
{
    const std::vector<Technique> all = allTechniques();
    return *std::find_if(all.begin(), all.end(), [&](const Technique& t) { return t.name == name; });
}

/// 8 x 8 pixels that see the surface of a receiver, or what is nearest to its plane where that ends.
std::vector<Receiver> groupAround(const Peel& peel, const Receiver& r, float pixel)
{
    std::vector<Receiver> group;
    for (int i = 0; i < 64; ++i)
    {
        const glm::vec2 place = r.offset + pixel * (glm::vec2(i % 8, i / 8) - 4.0f);
        const glm::ivec2 away(glm::floor(place + 0.5f));
        const float plane = r.surface.depth + glm::dot(r.surface.gradient, glm::vec2(away));
        const Surface* nearest = nullptr;
        for (const Surface* s = peel.begin(r.x + away.x, r.y + away.y); s != peel.end(r.x + away.x, r.y + away.y); ++s)
        {
            const bool isNearer = nearest == nullptr || std::abs(s->depth - plane) < std::abs(nearest->depth - plane);
            if (s->facing > 0.0f && isNearer)
                nearest = s;
        }
        if (nearest != nullptr)
            group.push_back({r.x + away.x, r.y + away.y, place - glm::vec2(away), *nearest, 0.0f, 0.0f});
    }
    return group;
}

/// Both bounds of one technique in one light.
class Bounds
{
public:
    Bounds(const Technique& technique, const LitScene& light, const Window& window)
        : m_mostBy(technique), m_leastBy(leastOf(technique)), m_most(mapOf(m_mostBy, light, window)),
          m_least(mapOf(m_leastBy, light, window))
    {
    }

    Answer answer(const Receiver& r, const Setting& setting) const
    {
        const auto first = [](float value)
        {
            return static_cast<std::size_t>(
                std::find_if(kRooms.begin(), kRooms.end(), [value](float room) { return value <= room + 1e-6f; }) -
                kRooms.begin());
        };
        return {first(m_most.estimate(r, setting)), first(1.0f - m_least.estimate(r, setting))};
    }

    /// The share of groups with one that is uncertain.
    Pairs groups(const Peel& peel, const std::vector<Receiver>& receivers, std::size_t most, float pixel,
                 const Setting& setting) const
    {
        Pairs share{};
        const std::size_t count = std::min(receivers.size(), most);
        for (std::size_t i = 0; i < count; ++i)
        {
            std::array<bool, kPairs> any{};
            for (const Receiver& r : groupAround(peel, receivers[i], pixel))
            {
                const Answer a = answer(r, setting);
                for (std::size_t pair = 0; pair < kPairs; ++pair)
                    any[pair] = any[pair] || (!a.isDark(pair) && !a.isLit(pair));
            }
            for (std::size_t pair = 0; pair < kPairs; ++pair)
                share[pair] += any[pair] ? 1.0 / static_cast<double>(count) : 0.0;
        }
        return share;
    }

private:
    static StoredMap mapOf(const Technique& technique, const LitScene& light, const Window& window)
    {
        MapMaker maker(technique, light.scene, window, Rounding::Once);
        return {maker, {}};
    }

    Technique m_mostBy, m_leastBy; // which the maps know
    StoredMap m_most, m_least;
};

/// Errors of PCF in one light: estimate less truth.
std::vector<double> errorsOf(const Technique& pcf, const Setting& setting, const LitScene& light, const Window& window)
{
    MapMaker maker(pcf, light.scene, window, Rounding::Once);
    const StoredMap map(maker, {});
    std::vector<double> errors;
    for (const Receiver& r : light.receivers)
        errors.push_back(static_cast<double>(estimateOf(map, pcf, r, setting) - r.visibility));
    return errors;
}

struct Sums
{
    Pairs squares{}, uncertain{}; ///< means over the receivers, the first weighted by n.l
    double pcf = 0.0;
};

Sums sumsOf(const std::vector<Receiver>& receivers, const std::vector<Answer>& answers, const std::vector<double>& pcf)
{
    Sums sums;
    double weight = 0.0;
    for (std::size_t i = 0; i < answers.size(); ++i)
        weight += static_cast<double>(receivers[i].surface.facing);
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
        const double share = static_cast<double>(receivers[i].surface.facing) / weight;
        const double truth = static_cast<double>(receivers[i].visibility);
        sums.pcf += share * pcf[i] * pcf[i];
        for (std::size_t pair = 0; pair < kPairs; ++pair)
        {
            const bool isDark = answers[i].isDark(pair), isLit = answers[i].isLit(pair);
            const double error = isDark ? truth : isLit ? 1.0 - truth : pcf[i];
            sums.squares[pair] += share * error * error;
            sums.uncertain[pair] += !isDark && !isLit ? 1.0 / static_cast<double>(answers.size()) : 0.0;
        }
    }
    return sums;
}

/// One technique in all lights, for any setting, worked out when first asked for.
class Trial
{
public:
    Trial(const Technique& technique, double units, const std::vector<LitScene>& lights, const Window& window)
        : m_settings(technique), m_units(units), m_lights(lights)
    {
        for (const LitScene& light : lights)
            m_bounds.push_back(std::make_unique<Bounds>(technique, light, window));
    }

    struct Choice
    {
        double cost = std::numeric_limits<double>::infinity(); ///< and a penalty for too much error
        Setting setting = kPlainSetting;
        std::size_t pair = 0;
    };

    /// The best for one light by the others, one member of the setting after the other. pcf: errors of each light.
    Choice best(std::size_t light, const std::vector<std::vector<double>>& pcf, double pcfUnits)
    {
        Settings::Index index = m_settings.plain();
        Choice least = choice(index, light, pcf, pcfUnits);
        for (int round = 0; round < 2; ++round)
        {
            // But for light bleeding, in whose place the rooms are.
            for (std::size_t member = 0; member < index.size() - 1; ++member)
            {
                for (std::size_t value = 0; value < m_settings.count(member); ++value)
                {
                    Settings::Index other = index;
                    other[member] = value;
                    const Choice found = choice(other, light, pcf, pcfUnits);
                    if (found.cost < least.cost)
                    {
                        least = found;
                        index = other;
                    }
                }
            }
        }
        return least;
    }

    const Bounds& bounds(std::size_t light) const { return *m_bounds[light]; }
    double units() const { return m_units; }

private:
    struct Answers
    {
        std::vector<Answer> receivers;
        Pairs groups;
    };

    const Answers& answers(const Settings::Index& index, std::size_t light)
    {
        const auto [found, isNew] = m_answers.try_emplace({index, light});
        if (isNew)
        {
            const std::vector<Receiver>& receivers = m_lights[light].receivers;
            const Setting setting = m_settings.at(index);
            for (std::size_t i = 0; i < std::min(receivers.size(), kChoiceReceivers); ++i)
                found->second.receivers.push_back(m_bounds[light]->answer(receivers[i], setting));
            found->second.groups =
                m_bounds[light]->groups(m_lights[light].scene.peel, receivers, kChoiceGroups, 1.0f, setting);
        }
        return found->second;
    }

    Choice choice(const Settings::Index& index, std::size_t light, const std::vector<std::vector<double>>& pcf,
                  double pcfUnits)
    {
        Pairs squares{}, groups{};
        double allowed = 0.0, count = 0.0;
        for (std::size_t other = 0; other < m_lights.size(); ++other)
        {
            if (other == light && m_lights.size() > 1)
                continue;
            const Answers& found = answers(index, other);
            const Sums sums = sumsOf(m_lights[other].receivers, found.receivers, pcf[other]);
            count += 1.0;
            allowed += kAllowed * kAllowed * sums.pcf;
            for (std::size_t pair = 0; pair < kPairs; ++pair)
            {
                squares[pair] += sums.squares[pair];
                groups[pair] += found.groups[pair];
            }
        }
        Choice least;
        for (std::size_t pair = 0; pair < kPairs; ++pair)
        {
            constexpr double kPenalty = 1e6;
            const double tooMuch = std::max(0.0, squares[pair] - allowed) / std::max(allowed, 1e-9);
            const double cost = m_units + groups[pair] / count * pcfUnits + kPenalty * tooMuch;
            if (cost < least.cost)
                least = {cost, m_settings.at(index), pair};
        }
        return least;
    }

    Settings m_settings;
    double m_units;
    const std::vector<LitScene>& m_lights;
    std::vector<std::unique_ptr<Bounds>> m_bounds; // which stay where they are: their maps know their techniques
    std::map<std::pair<Settings::Index, std::size_t>, Answers> m_answers;
};

} // namespace

Technique leastOf(const Technique& technique)
{
    class Least : public Estimator
    {
    public:
        explicit Least(std::unique_ptr<Estimator> most) : m_most(std::move(most)) {}
        void store(const Surface& nearest, float* texel) const override { m_most->store(nearest, texel); }
        void code(float* texel) const override { m_most->code(texel); }
        float visibility(const Query& query) const override { return m_most->least(query); }

    private:
        std::unique_ptr<Estimator> m_most;
    };
    Technique least = technique;
    least.prepare = [technique](const Map& map)
    {
        return std::make_unique<Least>(technique.prepare(map));
    };
    return least;
}

std::vector<Judge> judges(const Window& window)
{
    std::vector<Judge> all{{"least and greatest depths, widened", true, widenedRanges(window)},
                           {"least and greatest depths, pyramid", true, pyramidRanges(window)},
                           {"EVSM4 rgba32f", true, {}}};
    for (const char* exponents : {"42/10", "40/5", "42/42"})
        all.back().techniques.push_back(named(std::string("EVSM4 rgba32f ") + exponents));
    for (const char* name : {"MSM4 rgba32f", "LVSM-4 unorm8 bounded, uniform", "LVSM-8 unorm8 plane, optimal",
                             "mixture K=2 64-bit", "mixture K=4 128-bit"})
        all.push_back({name, named(name).peer, {named(name)}});
    return all;
}

std::vector<Certainty> measureCertainty(const Judge& judge, const std::vector<LitScene>& lights, const Window& window,
                                        const Costs& costs)
{
    const Technique pcf = named(kPcf);
    std::vector<LitScene> all = lights;
    for (LitScene& light : all)
    {
        light.isReported = true;
        light.pairs.clear();
    }
    const std::vector<Measurement> byPcf = measure(pcf, all, {window, {}, Rounding::Once, false});
    const double pcfUnits = costs.estimates.at(byPcf.front().estimateName()).units;

    std::vector<Trial> trials;
    for (const Technique& technique : judge.techniques)
    {
        const std::string estimate = technique.estimate + (technique.reading == Reading::Nearest ? " moved" : "");
        trials.emplace_back(technique, costs.estimates.at(estimate).units, lights, window);
    }
    std::vector<Certainty> found;
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
        if (!lights[i].isReported)
            continue;
        std::vector<std::vector<double>> errors;
        for (const LitScene& light : lights)
            errors.push_back(errorsOf(pcf, byPcf[i].setting, light, window));
        std::size_t chosen = 0;
        Trial::Choice best;
        for (std::size_t t = 0; t < trials.size(); ++t)
        {
            const Trial::Choice choice = trials[t].best(i, errors, pcfUnits);
            if (choice.cost < best.cost)
            {
                best = choice;
                chosen = t;
            }
        }
        const Bounds& bounds = trials[chosen].bounds(i);
        const std::vector<Receiver>& receivers = lights[i].receivers;
        std::vector<Answer> answers;
        for (const Receiver& r : receivers)
            answers.push_back(bounds.answer(r, best.setting));
        const Sums sums = sumsOf(receivers, answers, errors[i]);
        const auto groups = [&](float pixel)
        {
            return bounds.groups(lights[i].scene.peel, receivers, kGroups, pixel, best.setting)[best.pair];
        };
        found.push_back({judge.name, judge.peer, judge.techniques[chosen].name, lights[i].scene.name, window.width,
                         std::sqrt(sums.squares[best.pair]), std::sqrt(sums.pcf), sums.uncertain[best.pair],
                         groups(1.0f), groups(0.25f), trials[chosen].units(), pcfUnits});
    }
    return found;
}

std::optional<std::string> writeCertainty(const std::vector<Certainty>& found, const std::string& path)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Certainty& c : found)
    {
        rows.push_back({{"judge", c.judge},
                        {"peer", c.peer},
                        {"technique", c.technique},
                        {"scene", c.scene},
                        {"width", c.width},
                        {"rmse", c.rmse},
                        {"pcf_rmse", c.pcf},
                        {"uncertain", c.uncertain},
                        {"groups", c.groups},
                        {"groups_magnified", c.magnified},
                        {"bound_cost", c.bound},
                        {"pcf_cost", c.all},
                        {"cost", c.bound + c.groups * c.all}});
    }
    return support::writeWholeFile(path, rows.dump(1) + '\n');
}

} // namespace lvsm::quality
