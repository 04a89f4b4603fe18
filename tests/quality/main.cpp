// Measures the error of every technique of the library, and of its peers, against exact filtered visibility.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <mutex>

#include <CLI/CLI.hpp>

#include "certain.hpp"
#include "filter.hpp"
#include "parallel.hpp"
#include "picture.hpp"
#include "report.hpp"
#include "scenes_layered.hpp"
#include "scenes_mesh.hpp"

namespace lvsm::quality
{
namespace
{

struct Options
{
    unsigned seed = 1;
    int size = 256;
    std::vector<int> widths = {7};
    bool tree = false;
    std::vector<int> footprint = {1, 1};
    std::size_t receivers = 8000;
    bool centred = false;
    bool eachPass = false;
    bool oneTap = false;
    std::vector<std::string> techniques;
    std::vector<std::string> scenes;
    std::string model;
    bool forms = false;
    bool certain = false;
    std::string costs = "tests/cost/recorded.json";
    std::string output = "build/reports/quality.json";
    std::string pictures;
};

/// The lights of a world, or two seeds of a scene, the second of which only the settings are chosen on.
struct Plan
{
    std::vector<std::string> reported;
    std::function<std::vector<Scene>()> make;
};

bool contains(const std::string& name, const std::vector<std::string>& parts)
{
    return parts.empty() || std::any_of(parts.begin(), parts.end(),
                                        [&](const std::string& part) { return name.find(part) != std::string::npos; });
}

/// Each wanted name must mean something.
std::optional<std::string> unknown(const std::vector<std::string>& wanted, const std::vector<std::string>& names)
{
    for (const std::string& part : wanted)
    {
        const auto means = [&](const std::string& name)
        {
            return contains(name, {part});
        };
        if (std::none_of(names.begin(), names.end(), means))
            return part;
    }
    return std::nullopt;
}

std::string fileName(std::string name)
{
    for (char& c : name)
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
    return name;
}

support::Result<std::vector<Plan>> planScenes(const Options& options)
{
    std::vector<std::string> known = layeredSceneNames();
    std::vector<std::string> worlds = worldNames();
    if (!options.model.empty())
        worlds.insert(worlds.begin(), "model");
    for (const std::string& name : worlds)
    {
        for (const std::string& light : lightNames())
            known.push_back(name + "-" + light);
    }
    if (const auto name = unknown(options.scenes, known))
    {
        return support::Failure{"--scenes: there is no scene '" + *name + "'"};
    }
    const bool modelAlone = !options.model.empty() && options.scenes.empty();

    std::vector<Plan> plans;
    for (const std::string& name : layeredSceneNames())
    {
        if (modelAlone || !contains(name, options.scenes))
            continue;
        plans.push_back({{name},
                         [=]
                         {
                             std::vector<Scene> seeds;
                             seeds.push_back(layeredScene(name, options.size, options.seed));
                             seeds.push_back(layeredScene(name, options.size, options.seed + 1));
                             seeds.back().name += " of another seed";
                             return seeds;
                         }});
    }
    for (const std::string& name : worlds)
    {
        if (modelAlone && name != "model")
            continue;
        Plan plan;
        for (const std::string& light : lightNames())
        {
            if (contains(name + "-" + light, options.scenes))
                plan.reported.push_back(name + "-" + light);
        }
        if (plan.reported.empty())
            continue;
        support::Result<Mesh> made = name == "model" ? modelWorld(options.model) : world(name, options.seed);
        if (!made)
            return support::Failure{made.error()};
        const auto mesh = std::make_shared<Mesh>(std::move(*made));
        plan.make = [=]
        {
            std::vector<Scene> lights;
            for (const std::string& light : lightNames())
                lights.push_back(meshScene(name, *mesh, light, options.size));
            return lights;
        };
        plans.push_back(std::move(plan));
    }
    return plans;
}

/// The scenes with what is measured in them for one width of the filter.
std::vector<LitScene> litScenes(const std::vector<Scene>& scenes, const Plan& plan, const Terms& terms,
                                const Options& options)
{
    constexpr std::size_t kPairs = 2000;
    const std::vector<double> kernel = terms.window.kernel();
    std::vector<LitScene> lights;
    for (const Scene& scene : scenes)
    {
        const bool isReported =
            std::find(plan.reported.begin(), plan.reported.end(), scene.name) != plan.reported.end();
        const std::size_t most = options.pictures.empty() ? options.receivers : std::numeric_limits<std::size_t>::max();
        LitScene light{scene, isReported, receiversOf(scene, kernel, {options.centred, most, terms.footprint}), {}};
        if (isReported && !terms.footprint.minified())
            light.pairs = neighboursOf(scene, receiversOf(scene, kernel, {options.centred, kPairs}), kernel);
        lights.push_back(std::move(light));
    }
    return lights;
}

/// Certain or not, in the scenes of meshes.
support::Result<std::vector<Certainty>> measureCertain(const Options& options)
{
    support::Result<std::vector<Plan>> plans = planScenes(options);
    if (!plans)
        return support::Failure{plans.error()};
    const Costs costs = readCosts(options.costs);
    if (costs.estimates.empty())
        return support::Failure{"--costs: '" + options.costs + "' has none, and what is cheapest is chosen by them"};
    std::vector<Certainty> all;
    for (const Plan& plan : *plans)
    {
        const std::vector<Scene> scenes = plan.make();
        for (const int width : options.widths)
        {
            if (!scenes.front().mesh)
                continue;
            const Terms terms{{width, options.tree}, {}, Rounding::Once, false};
            const std::vector<LitScene> lights = litScenes(scenes, plan, terms, options);
            std::fprintf(stderr, "%s, width %d\n", plan.reported.front().c_str(), width);
            std::vector<Judge> wanted = judges(terms.window);
            wanted.erase(std::remove_if(wanted.begin(), wanted.end(),
                                        [&](const Judge& judge) { return !contains(judge.name, options.techniques); }),
                         wanted.end());
            std::vector<std::vector<Certainty>> found(wanted.size());
            parallelFor(wanted.size(),
                        [&](std::size_t j) { found[j] = measureCertainty(wanted[j], lights, terms.window, costs); });
            for (const std::vector<Certainty>& of : found)
                all.insert(all.end(), of.begin(), of.end());
        }
    }
    return all;
}

support::Result<Run> measureAll(const Options& options)
{
    std::vector<Technique> techniques = options.forms ? layeredForms() : allTechniques();
    std::vector<std::string> names;
    for (const Technique& technique : techniques)
        names.push_back(technique.name);
    if (const auto name = unknown(options.techniques, names))
    {
        return support::Failure{"--techniques: there is no technique '" + *name + "'"};
    }
    const auto unwanted = [&](const Technique& t)
    {
        return !contains(t.name, options.techniques);
    };
    techniques.erase(std::remove_if(techniques.begin(), techniques.end(), unwanted), techniques.end());

    support::Result<std::vector<Plan>> plans = planScenes(options);
    if (!plans)
        return support::Failure{plans.error()};

    Run run{options.seed, options.size, {}, readCosts(options.costs)};
    std::mutex mutex;
    std::optional<std::string> problem;
    const Shown picture = [&](const Measurement& measured, const StoredMap& map, const LitScene& light)
    {
        const auto technique =
            std::find_if(techniques.begin(), techniques.end(),
                         [&](const Technique& t) { return t.name + measured.variant.suffix() == measured.technique; });
        const std::string path =
            options.pictures + "/" +
            fileName(measured.scene + " " + measured.technique + " " + std::to_string(measured.window.width)) + ".png";
        const auto failed = writePicture(map, *technique, measured.setting, light, path);
        const std::lock_guard<std::mutex> lock(mutex);
        if (failed)
            problem = failed;
    };
    for (std::size_t i = 0; i < plans->size(); ++i)
    {
        const std::vector<Scene> scenes = (*plans)[i].make();
        for (const int width : options.widths)
        {
            const Footprint footprint{options.footprint[0], options.footprint[1]};
            const Terms terms{{width, options.tree},
                              footprint,
                              options.eachPass ? Rounding::EachPass : Rounding::Once,
                              !options.oneTap && !footprint.minified()};
            const std::vector<LitScene> lights = litScenes(scenes, (*plans)[i], terms, options);
            for (const LitScene& light : lights)
            {
                std::fprintf(stderr, "[%zu/%zu] %s, width %d: %zu receivers\n", i + 1, plans->size(),
                             light.scene.name.c_str(), width, light.receivers.size());
                if (light.receivers.empty())
                    return support::Failure{"scene '" + light.scene.name + "' has nothing that faces the light"};
            }
            std::vector<std::vector<Measurement>> found(techniques.size());
            parallelFor(
                techniques.size(), [&](std::size_t t)
                { found[t] = measure(techniques[t], lights, terms, options.pictures.empty() ? Shown() : picture); });
            if (problem)
                return support::Failure{"--pictures: " + *problem};
            for (std::vector<Measurement>& of : found)
                run.measurements.insert(run.measurements.end(), of.begin(), of.end());
        }
    }
    return run;
}

} // namespace
} // namespace lvsm::quality

int main(int argc, char** argv)
{
    using namespace lvsm::quality;
    Options options;
    CLI::App app("Error of shadow map techniques against exact filtered visibility");
    app.add_option("--seed", options.seed, "Seed of the random scenes")->capture_default_str();
    app.add_option("--size", options.size, "Texels along each side of the map")
        ->check(CLI::Range(32, 2048))
        ->capture_default_str();
    app.add_option("--width", options.widths, "Widths of the binomial filter, odd")
        ->check(CLI::Range(3, 25))
        ->delimiter(',')
        ->capture_default_str();
    app.add_flag("--tree", options.tree, "Filters are windows of the tree of mixtures, of width 3, 7 or 15");
    app.add_option("--footprint", options.footprint,
                   "Length of a receiver's footprint in texels, and how often narrower")
        ->check(CLI::Range(1, 16))
        ->delimiter(',')
        ->expected(2)
        ->capture_default_str();
    app.add_option("--receivers", options.receivers, "Most receivers of a scene")->capture_default_str();
    app.add_flag("--centred", options.centred, "Receivers on texel centres, not anywhere between them");
    app.add_flag("--each-pass", options.eachPass, "Round when storing and after each pass of the filter, not once");
    app.add_flag("--one-tap", options.oneTap, "One tap at full resolution, and no other variant");
    app.add_flag("--forms", options.forms, "What parts of two estimates from layers are worth, and nothing else");
    app.add_flag("--certain", options.certain, "Who is certain by bounds on both sides, and nothing else");
    app.add_option("--techniques", options.techniques, "Only those whose name contains one of these")->delimiter(',');
    app.add_option("--scenes", options.scenes, "Only those whose name contains one of these")->delimiter(',');
    app.add_option("--model", options.model, "A model of your own, in any format Assimp reads, instead of the scenes");
    app.add_option("--costs", options.costs, "What lvsm_cost recorded")->capture_default_str();
    app.add_option("--output", options.output, "Where the rows go, as JSON")->capture_default_str();
    app.add_option("--pictures", options.pictures, "A folder for pictures of where the error is");
    CLI11_PARSE(app, argc, argv);
    for (const int width : options.widths)
    {
        if (width % 2 == 0)
        {
            std::fprintf(stderr, "--width: %d is even, and a filter has a middle\n", width);
            return 1;
        }
        if (options.tree && (width & (width + 1)) != 0)
        {
            std::fprintf(stderr, "--width: no tree is %d texels wide\n", width);
            return 1;
        }
    }

    const auto start = std::chrono::steady_clock::now();
    if (options.certain)
    {
        const auto found = measureCertain(options);
        const auto problem = found ? writeCertainty(*found, options.output) : found.error();
        if (problem)
            std::fprintf(stderr, "%s\n", problem->c_str());
        return problem ? 1 : 0;
    }
    lvsm::support::Result<Run> run = measureAll(options);
    if (!run)
    {
        std::fprintf(stderr, "%s\n", run.error().c_str());
        return 1;
    }
    if (const auto problem = writeJson(*run, options.output))
    {
        std::fprintf(stderr, "--output: %s\n", problem->c_str());
        return 1;
    }
    printTables(*run, std::cout);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::fprintf(stderr, "%.0f s\n", taken.count());
    return 0;
}
