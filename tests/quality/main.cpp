// Measures the error of every technique of the library, and of its peers, against exact filtered visibility.
#include <cstdio>
#include <iostream>
#include <mutex>

#include <CLI/CLI.hpp>

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
    int size = 384;
    int kernel = 7;
    std::vector<std::string> techniques;
    std::vector<std::string> scenes;
    std::string model;
    std::string output = "build/reports/quality.json";
    std::string pictures;
};

/// A scene that can be made when its turn comes.
struct Plan
{
    std::string name;
    std::function<Scene()> make;
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
        plans.push_back({name, [=]
                         {
                             return layeredScene(name, options.size, options.seed);
                         }});
    }
    for (const std::string& name : worlds)
    {
        if (modelAlone && name != "model")
            continue;
        std::shared_ptr<Mesh> mesh;
        for (const std::string& light : lightNames())
        {
            const std::string sceneName = name + "-" + light;
            if (!contains(sceneName, options.scenes))
                continue;
            if (mesh == nullptr)
            {
                support::Result<Mesh> made = name == "model" ? modelWorld(options.model) : world(name, options.seed);
                if (!made)
                    return support::Failure{made.error()};
                mesh = std::make_shared<Mesh>(std::move(*made));
            }
            plans.push_back({sceneName, [=]
                             {
                                 return meshScene(name, *mesh, light, options.size);
                             }});
        }
    }
    return plans;
}

support::Result<Run> measure(const Options& options)
{
    std::vector<Technique> techniques = allTechniques();
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

    const std::vector<double> kernel = binomialKernel(options.kernel);
    Run run{options.seed, options.size, options.kernel, {}};
    for (std::size_t i = 0; i < plans->size(); ++i)
    {
        const Scene scene = (*plans)[i].make();
        const std::vector<Receiver> receivers = receiversOf(scene, kernel);
        std::fprintf(stderr, "[%zu/%zu] %s: %zu receivers\n", i + 1, plans->size(), scene.name.c_str(),
                     receivers.size());
        if (receivers.empty())
            return support::Failure{"scene '" + scene.name + "' has nothing that faces the light"};
        const std::size_t first = run.measurements.size();
        run.measurements.resize(first + techniques.size());
        std::mutex mutex;
        std::optional<std::string> problem;
        parallelFor(techniques.size(),
                    [&](std::size_t t)
                    {
                        const Judge judge(techniques[t], scene, receivers, kernel);
                        Measurement& measured = run.measurements[first + t];
                        measured = judge.measure();
                        if (options.pictures.empty())
                            return;
                        const std::string path =
                            options.pictures + "/" + fileName(scene.name + " " + measured.technique) + ".png";
                        const auto failed = writePicture(judge, measured.setting, scene, receivers, path);
                        const std::lock_guard<std::mutex> lock(mutex);
                        if (failed)
                            problem = failed;
                    });
        if (problem)
            return support::Failure{"--pictures: " + *problem};
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
    app.add_option("--kernel", options.kernel, "Width of the binomial filter, odd")
        ->check(CLI::Range(3, 25))
        ->capture_default_str();
    app.add_option("--techniques", options.techniques, "Only those whose name contains one of these")->delimiter(',');
    app.add_option("--scenes", options.scenes, "Only those whose name contains one of these")->delimiter(',');
    app.add_option("--model", options.model, "A model of your own, in any format Assimp reads, instead of the scenes");
    app.add_option("--output", options.output, "Where the rows go, as JSON")->capture_default_str();
    app.add_option("--pictures", options.pictures, "A folder for pictures of where the error is");
    CLI11_PARSE(app, argc, argv);
    if (options.kernel % 2 == 0)
    {
        std::fprintf(stderr, "--kernel: %d is even, and a filter has a middle\n", options.kernel);
        return 1;
    }

    lvsm::support::Result<Run> run = measure(options);
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
    return 0;
}
