// lvsm_client_splits FOLDER: images and where lvsm::lloydRelax and lvsm::optimalSplits place their splits, for the
// WebAssembly module to do the same: FOLDER/IMAGE.depths, floats row by row, and FOLDER/splits.json.
#include <lvsm/lloyd.hpp>
#include <lvsm/optimal.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using nlohmann::json;

struct Image
{
    std::string name;
    int width;
    int height;
    std::vector<float> depths;
};

// Leaves over tables over sloping ground.
Image scene(const std::string& name, int width, int height)
{
    Image image{name, width, height, {}};
    std::mt19937 random(1);
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            const bool leaf = random() % 5 == 0;
            const bool table = x % 97 < 40 && y % 61 < 30;
            const float slope = 0.1f * static_cast<float>(y) / static_cast<float>(height);
            image.depths.push_back(leaf ? 0.2f + 0.1f * std::sin(static_cast<float>(x)) : table ? 0.5f : 0.8f + slope);
        }
    }
    return image;
}

std::vector<Image> images()
{
    const float infinity = std::numeric_limits<float>::infinity();
    return {scene("large", 512, 512),
            scene("narrow", 3, 700),
            {"flat", 8, 8, std::vector<float>(64, 0.5f)},
            {"texel", 1, 1, {0.25f}},
            {"infinite", 2, 1, {0.25f, infinity}},
            {"none", 0, 0, {}}};
}

template <typename Result>
json row(const Image& image, const char* function, int layerCount, const json& options, const Result& result,
         const std::vector<float>& splits)
{
    return {{"image", image.name},
            {"width", image.width},
            {"height", image.height},
            {"function", function},
            {"layerCount", layerCount},
            {"options", options},
            {"placed", static_cast<bool>(result)},
            {"message", lvsm::describe(result.status)},
            {"splits", splits}};
}

json relaxed(const Image& image, int layerCount, bool some)
{
    lvsm::RelaxOptions<float> options;
    json named = json::object();
    if (some)
    {
        options.maxIterations = 3;
        options.minVariance = 0.01f;
        options.splitsPerIteration = 2;
        options.maxSamples = 5000;
        named = {{"maxIterations", 3}, {"minVariance", 0.01}, {"splitsPerIteration", 2}, {"maxSamples", 5000}};
    }
    std::vector<float> splits(static_cast<std::size_t>(std::max(0, layerCount)) + 1);
    const auto result =
        lvsm::lloydRelax(image.depths.data(), image.width, image.height, splits.data(), layerCount, options);
    return row(image, "lloydRelax", layerCount, named, result, splits);
}

json placed(const Image& image, int layerCount, bool some)
{
    lvsm::OptimalOptions<float> options;
    json named = json::object();
    if (some)
    {
        options.uniformShare = 0.0f;
        options.minLength = 0.0f;
        options.maxSamples = 0;
        named = {{"uniformShare", 0}, {"minLength", 0}, {"maxSamples", 0}};
    }
    std::vector<float> splits(static_cast<std::size_t>(std::max(0, layerCount)) + 1);
    const auto result =
        lvsm::optimalSplits(image.depths.data(), image.width, image.height, splits.data(), layerCount, options);
    return row(image, "optimalSplits", layerCount, named, result, splits);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    const std::string folder = argv[1];
    json rows = json::array();
    for (const Image& image : images())
    {
        std::ofstream(folder + "/" + image.name + ".depths", std::ios::binary)
            .write(reinterpret_cast<const char*>(image.depths.data()),
                   static_cast<std::streamsize>(image.depths.size() * sizeof(float)));
        for (const int layerCount : {0, 1, 2, 4, 16, 17})
        {
            for (const bool some : {false, true})
            {
                rows.push_back(relaxed(image, layerCount, some));
                rows.push_back(placed(image, layerCount, some));
            }
        }
    }
    std::ofstream(folder + "/splits.json") << rows.dump(1) << '\n';
    return 0;
}
