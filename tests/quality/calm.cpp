// How much the error of each technique flickers: points at their exact place on surfaces, while the map's grid moves by
// quarters of a texel, and while the light turns by tenths of a degree.
#include <cstdio>
#include <iostream>
#include <mutex>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "measure.hpp"
#include "parallel.hpp"
#include "scenes_mesh.hpp"
#include "whole_file.hpp"

namespace lvsm::quality
{
namespace
{

struct Case
{
    std::string world, light;
    int width;
};
const std::vector<Case> kCases{
    {"street", "oblique", 7}, {"bunnies", "spot", 7}, {"trees", "oblique", 7}, {"machine", "oblique", 15}};

struct Motion
{
    std::string name;
    int frames;
    std::function<Light(const Mesh&, const std::string&, int size, int frame)> light;
};
const std::vector<Motion> kMotions{
    {"grid moves", 16,
     [](const Mesh& mesh, const std::string& name, int size, int frame)
     {
         return meshLight(mesh, name, size).moved(0.25 * glm::dvec2(frame % 4, frame / 4));
     }},
    {"light turns", 64,
     [](const Mesh& mesh, const std::string& name, int size, int frame)
     {
         return meshLight(mesh, name, size, 0.1f * static_cast<float>(frame));
     }},
};

struct Options
{
    int size = 256;
    std::size_t points = 2000;
    std::size_t cases = kCases.size();
    int frames = 64;
    std::string output = "build/reports/calm.json";
};

struct Candidate
{
    Technique technique;
    Variant variant;
    std::string name() const { return technique.name + variant.suffix(); }
};

/// A few of each kind, and power moments with four decisions too.
std::vector<Candidate> candidates()
{
    std::vector<Candidate> found;
    for (const Technique& t : allTechniques())
    {
        for (const char* name : {"mixture K=2 64-bit", "mixture K=4 128-bit", "MSM4 rgba32f", "MSM4 quantised 64-bit",
                                 "trigonometric unorm16", "EVSM4 rgba32f 42/10", "LVSM-8 unorm8 plane, optimal",
                                 "LVSM-16 unorm8 plane, optimal", "PCF, whole window"})
        {
            if (t.name != name)
                continue;
            found.push_back({t, {}});
            if (t.own || t.name == "MSM4 rgba32f")
                found.push_back({t, {1, false, true}});
        }
    }
    return found;
}

/// A point as a receiver of a frame; nothing if its surface is not at the nearest texel's centre, or is turned away.
std::optional<Receiver> seen(glm::dvec3 point, const Light& light, const Scene& scene)
{
    constexpr int kMargin = 16;
    const glm::dvec2 place = light.texel(point);
    const glm::ivec2 texel(glm::floor(place));
    const glm::vec2 offset(place - glm::dvec2(texel) - 0.5);
    if (glm::any(glm::lessThan(texel, glm::ivec2(kMargin))) ||
        glm::any(glm::greaterThanEqual(texel, glm::ivec2(scene.peel.size() - kMargin))))
        return std::nullopt;
    const float depth = static_cast<float>(light.depth(point));
    std::optional<Receiver> found;
    float least = 1.0f;
    for (const Surface* s = scene.peel.begin(texel.x, texel.y); s != scene.peel.end(texel.x, texel.y); ++s)
    {
        const float away = std::abs(s->depth + glm::dot(s->gradient, offset) - depth);
        if (!(s->facing > 0.0f) || away > std::min(least, 1.0e-5f + 0.25f * glm::length(s->gradient)))
            continue;
        least = away;
        found = Receiver{texel.x, texel.y, offset, *s, 0.0f, 0.0f};
        found->surface.depth = depth - glm::dot(s->gradient, offset);
    }
    return found;
}

struct Flicker
{
    std::string scene, motion, technique;
    double rmse, deviation;
};

/// Errors of all frames of each point that every frame sees: their size, and their deviation over the frames.
Flicker flickerOf(const std::vector<std::vector<float>>& errors, const std::vector<float>& weights)
{
    double weight = 0.0, squares = 0.0, variances = 0.0;
    for (std::size_t point = 0; point < weights.size(); ++point)
    {
        double sum = 0.0, square = 0.0;
        for (const std::vector<float>& frame : errors)
        {
            sum += static_cast<double>(frame[point]);
            square += static_cast<double>(frame[point] * frame[point]);
        }
        const double count = static_cast<double>(errors.size());
        const double w = static_cast<double>(weights[point]);
        weight += w;
        squares += w * square / count;
        variances += w * std::max(0.0, square / count - sum * sum / (count * count));
    }
    return {"", "", "", std::sqrt(squares / weight), std::sqrt(variances / weight)};
}

std::vector<Flicker> measureCase(const Case& c, const Mesh& mesh, const Motion& motion, const Options& options)
{
    const Window window{c.width};
    const std::vector<double> kernel = window.kernel();
    const std::size_t frames = static_cast<std::size_t>(std::min(motion.frames, options.frames));

    const Light first = motion.light(mesh, c.light, options.size, 0);
    std::vector<Scene> scenes;
    std::vector<Light> lights;
    for (std::size_t frame = 0; frame < frames; ++frame)
    {
        lights.push_back(motion.light(mesh, c.light, options.size, static_cast<int>(frame)));
        scenes.push_back({c.world, depthPeel(mesh, lights.back(), options.size), true});
    }
    std::vector<float> weights;
    std::vector<std::vector<Receiver>> receivers(frames);
    for (const Receiver& r : receiversOf(scenes[0], kernel, {false, options.points}))
    {
        const glm::dvec2 place = glm::dvec2(r.x, r.y) + 0.5 + glm::dvec2(r.offset);
        const glm::dvec3 point = first.point(place, static_cast<double>(r.depth()));
        std::vector<Receiver> all;
        for (std::size_t frame = 0; frame < frames && all.size() == frame; ++frame)
        {
            if (const auto there = seen(point, lights[frame], scenes[frame]))
                all.push_back(*there);
        }
        if (all.size() < frames)
            continue;
        weights.push_back(r.surface.facing);
        for (std::size_t frame = 0; frame < frames; ++frame)
            receivers[frame].push_back(all[frame]);
    }
    for (std::size_t frame = 0; frame < frames; ++frame)
        judgeAll(scenes[frame], kernel, receivers[frame]);

    std::vector<Flicker> found;
    std::vector<std::vector<float>> truth(frames);
    for (std::size_t frame = 0; frame < frames; ++frame)
    {
        for (const Receiver& r : receivers[frame])
            truth[frame].push_back(r.visibility);
    }
    found.push_back(flickerOf(truth, weights));
    found.back().technique = "the light itself";
    for (const Candidate& candidate : candidates())
    {
        // What is chosen is chosen in the first frame, for all of them.
        std::vector<LitScene> still;
        still.push_back({scenes[0], true, receivers[0], {}});
        const Setting setting =
            measure(candidate.technique, still, {window, {}, Rounding::Once, false}).front().setting;
        std::vector<std::vector<float>> errors(frames);
        parallelFor(frames,
                    [&](std::size_t frame)
                    {
                        MapMaker maker(candidate.technique, scenes[frame], window, Rounding::Once);
                        const StoredMap map(maker, candidate.variant);
                        for (const Receiver& r : receivers[frame])
                            errors[frame].push_back(estimateOf(map, candidate.technique, r, setting) - r.visibility);
                    });
        found.push_back(flickerOf(errors, weights));
        found.back().technique = candidate.name();
    }
    for (Flicker& f : found)
    {
        f.scene = c.world + "-" + c.light + " " + std::to_string(c.width);
        f.motion = motion.name;
    }
    std::fprintf(stderr, "%s, %s: %zu points\n", found.front().scene.c_str(), motion.name.c_str(), weights.size());
    return found;
}

int run(const Options& options)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < std::min(options.cases, kCases.size()); ++i)
    {
        const support::Result<Mesh> mesh = world(kCases[i].world, 1);
        if (!mesh)
        {
            std::fprintf(stderr, "%s\n", mesh.error().c_str());
            return 1;
        }
        for (const Motion& motion : kMotions)
        {
            for (const Flicker& f : measureCase(kCases[i], *mesh, motion, options))
            {
                std::printf("%-22s %-12s %-42s %.4f %.4f\n", f.scene.c_str(), f.motion.c_str(), f.technique.c_str(),
                            f.rmse, f.deviation);
                rows.push_back({{"scene", f.scene},
                                {"motion", f.motion},
                                {"technique", f.technique},
                                {"rmse", f.rmse},
                                {"deviation", f.deviation}});
            }
        }
    }
    if (const auto problem = support::writeWholeFile(options.output, rows.dump(1) + '\n'))
    {
        std::fprintf(stderr, "--output: %s\n", problem->c_str());
        return 1;
    }
    return 0;
}

} // namespace
} // namespace lvsm::quality

int main(int argc, char** argv)
{
    lvsm::quality::Options options;
    CLI::App app("Deviation of each technique's error while the map's grid moves and while the light turns");
    app.add_option("--size", options.size, "Texels along each side of the map")
        ->check(CLI::Range(64, 2048))
        ->capture_default_str();
    app.add_option("--points", options.points, "Points of a scene")->capture_default_str();
    app.add_option("--cases", options.cases, "Only the first so many scenes")->capture_default_str();
    app.add_option("--frames", options.frames, "Frames at most")->check(CLI::Range(2, 64))->capture_default_str();
    app.add_option("--output", options.output, "Where the rows go, as JSON")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return lvsm::quality::run(options);
}
