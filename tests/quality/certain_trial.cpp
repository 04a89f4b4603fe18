#include "certain_trial.hpp"

#include <algorithm>

#include "certain.hpp"

namespace lvsm::quality
{
namespace
{

constexpr double kAllowed = 1.05;              // of PCF's RMSE, in the lights that settings are chosen on
constexpr std::size_t kChoiceReceivers = 1500; // of each light, to choose on
constexpr std::size_t kChoiceGroups = 100;     // likewise

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

StoredMap mapOf(const Technique& technique, const LitScene& light, const Window& window)
{
    MapMaker maker(technique, light.scene, window, Rounding::Once);
    return {maker, {}};
}

} // namespace

Bounds::Bounds(const Technique& technique, const LitScene& light, const Window& window)
    : m_mostBy(technique), m_leastBy(leastOf(technique)), m_most(mapOf(m_mostBy, light, window)),
      m_least(mapOf(m_leastBy, light, window))
{
}

Answer Bounds::answer(const Receiver& r, const Setting& setting) const
{
    const auto first = [](float value)
    {
        return static_cast<std::size_t>(
            std::find_if(kRooms.begin(), kRooms.end(), [value](float room) { return value <= room + 1e-6f; }) -
            kRooms.begin());
    };
    return {first(m_most.estimate(r, setting)), first(1.0f - m_least.estimate(r, setting))};
}

Pairs Bounds::groups(const Peel& peel, const std::vector<Receiver>& receivers, std::size_t most, float pixel,
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

Trial::Trial(const Technique& technique, double units, const std::vector<LitScene>& lights, const Window& window)
    : m_settings(technique), m_units(units), m_lights(lights)
{
    for (const LitScene& light : lights)
        m_bounds.push_back(std::make_unique<Bounds>(technique, light, window));
}

Trial::Choice Trial::best(std::size_t light, const std::vector<std::vector<double>>& pcf, double pcfUnits)
{
    // But for light bleeding, in whose place the rooms are.
    return m_settings.best(Settings::kMembers - 1,
                           [&](const Settings::Index& index) { return choice(index, light, pcf, pcfUnits); });
}

const Trial::Answers& Trial::answers(const Settings::Index& index, std::size_t light)
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

Trial::Choice Trial::choice(const Settings::Index& index, std::size_t light,
                            const std::vector<std::vector<double>>& pcf, double pcfUnits)
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

} // namespace lvsm::quality
