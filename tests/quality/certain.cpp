#include "certain.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "certain_trial.hpp"
#include "whole_file.hpp"

namespace lvsm::quality
{
namespace
{

constexpr std::size_t kGroups = 400; // to report
constexpr const char* kPcf = "PCF, window cut at 2 deviations";

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
        all.back().techniques.push_back(techniqueNamed(std::string("EVSM4 rgba32f ") + exponents));
    for (const char* name : {"MSM4 rgba32f", "LVSM-4 unorm8 bounded, uniform", "LVSM-8 unorm8 plane, optimal",
                             "mixture K=2 64-bit", "mixture K=4 128-bit"})
        all.push_back({name, techniqueNamed(name).peer, {techniqueNamed(name)}});
    return all;
}

std::vector<Certainty> measureCertainty(const Judge& judge, const std::vector<LitScene>& lights, const Window& window,
                                        const Costs& costs)
{
    const Technique pcf = techniqueNamed(kPcf);
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
        const std::string estimate = technique.estimateBy(technique.reading);
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
