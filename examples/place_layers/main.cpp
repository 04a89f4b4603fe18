// Places the layers of a depth image, says what each way to do so is worth, and prints the splits ready to paste.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>
#include <lvsm/optimal.hpp>

#include "plot.hpp"
#include "report.hpp"
#include "whole_file.hpp"

namespace
{

using namespace lvsm::place_layers;

struct Options
{
    std::string path;
    std::string weightsPath;
    std::string plotPath;
    std::string method = "optimal";
    std::string format = "text";
    int layerCount = 4;
    float overlap = 0;
    DepthMeaning meaning;
};

int fail(const std::string& message)
{
    std::fprintf(stderr, "place_layers: %s\n", message.c_str());
    return 1;
}

void warn(const std::string& message)
{
    std::fprintf(stderr, "place_layers: warning: %s\n", message.c_str());
}

void addOptions(CLI::App& app, Options& options)
{
    app.add_option("IMAGE", options.path, "Depths: a PNG of 16 bits, an EXR or a PFM file")->required();
    app.add_option("--layers", options.layerCount, "Number of layers")->check(CLI::Range(1, 64))->capture_default_str();
    app.add_option("--method", options.method, "How to place them")
        ->check(CLI::IsMember({"uniform", "lloyd", "optimal"}))
        ->capture_default_str();
    app.add_option("--overlap", options.overlap, "By how much each layer reaches over its splits, in linear depth")
        ->check(CLI::Range(0.0f, 1.0f))
        ->capture_default_str();
    auto* const near =
        app.add_option("--near", options.meaning.nearDistance, "Distance that linear depth 0 stands for");
    auto* const far = app.add_option("--far", options.meaning.farDistance, "Distance that linear depth 1 stands for");
    near->needs(far);
    far->needs(near);
    app.add_flag("--projected", options.meaning.isProjected,
                 "The depths are a perspective projection's, from the near plane to the far plane")
        ->needs(near);
    app.add_flag("--reversed-z", options.meaning.isReversed,
                 "They are 1 at the near plane; with --near and --far of a perspective projection");
    app.add_option("--weights", options.weightsPath, "Image of the same size: how much each pixel counts");
    app.add_option("--format", options.format, "What to print")
        ->check(CLI::IsMember(formatNames()))
        ->capture_default_str();
    app.add_option("--plot", options.plotPath, "PNG file to write: the histogram with the splits");
}

// The reason why two options do not go together, or nothing.
std::string contradiction(const Options& options)
{
    const DepthMeaning& meaning = options.meaning;
    if (meaning.nearDistance && !(*meaning.nearDistance < *meaning.farDistance))
        return "--near has to be less than --far";
    if (meaning.nearDistance && (meaning.isProjected || meaning.isReversed) && !(*meaning.nearDistance > 0))
        return "--near has to be more than 0 for a perspective projection";
    if (meaning.farDistance && !std::isfinite(*meaning.farDistance))
        return "--far has to be finite";
    if (!(options.overlap >= 0))
        return "--overlap has to be a number";
    if (options.method == "optimal" && options.layerCount > lvsm::kMaxOptimalLayers)
        return "--layers: the method optimal places at most " + std::to_string(lvsm::kMaxOptimalLayers);
    return {};
}

lvsm::support::Result<Image> readWeights(const Options& options, const Image& depths)
{
    lvsm::support::Result<Image> weights = readImage(options.weightsPath, true);
    if (!weights)
        return weights;
    if (weights->width != depths.width || weights->height != depths.height)
        return lvsm::support::Failure{"--weights: '" + options.weightsPath + "' is " + std::to_string(weights->width) +
                                      " x " + std::to_string(weights->height) + " pixels, the depths are " +
                                      std::to_string(depths.width) + " x " + std::to_string(depths.height)};
    double sum = 0;
    for (float& weight : weights->values)
    {
        weight = std::isfinite(weight) ? std::max(weight, 0.0f) : 0.0f;
        sum += static_cast<double>(weight);
    }
    if (sum <= 0)
        return lvsm::support::Failure{"--weights: '" + options.weightsPath + "' has no pixel that counts"};
    return weights;
}

int run(const Options& options)
{
    auto image = readImage(options.path);
    if (!image)
        return fail(image.error());
    if (image->hasEightBits)
        warn("'" + options.path + "' has 8 bits: 256 depths are few, and steps between them look like edges");
    const auto depths = linearDepths(std::move(*image), options.meaning);
    if (!depths)
        return fail("'" + options.path + "': " + depths.error());
    if (depths->ignored > 0)
        warn("'" + options.path + "': " + std::to_string(depths->ignored) + " pixels are NaN or infinite and ignored");
    if (depths->beyond > 0)
        warn("'" + options.path + "': " + std::to_string(depths->beyond) +
             " pixels are nearer than --near or farther than --far");
    const auto layers = static_cast<std::size_t>(options.layerCount);
    if (distinctDepths(depths->image, layers) < layers)
        return fail("--layers: more than the " + std::to_string(distinctDepths(depths->image, layers)) +
                    " depths that '" + options.path + "' has");

    Task task{depths->image, {}, options.layerCount, options.overlap};
    if (!options.weightsPath.empty())
    {
        auto weights = readWeights(options, depths->image);
        if (!weights)
            return fail(weights.error());
        task.weights = std::move(*weights);
    }
    const std::vector<Placement> placements = placeLayers(task);
    const auto chosen = std::find_if(placements.begin(), placements.end(),
                                     [&](const Placement& placement) { return placement.method == options.method; });
    const Report report{options.path, *depths, task, placements, *chosen};

    if (!options.plotPath.empty())
    {
        if (const auto error = lvsm::support::writeWholeFile(options.plotPath, plot(report)))
            return fail("--plot: " + *error);
    }
    const std::string text = format(report, options.format);
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        return fail("cannot write what --format " + options.format + " gives to standard output");
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app("Places the layers of a layered variance shadow map for a depth image.", "place_layers");
    addOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    const std::string refused = contradiction(options);
    return refused.empty() ? run(options) : fail(refused);
}
