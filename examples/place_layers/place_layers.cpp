// Places the layers for a depth image: the whole of what a program needs for it is in placeLayers().

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <lvsm/lvsm.hpp>
#include <stb_image.h>

namespace
{

struct DepthImage
{
    int width = 0;
    int height = 0;
    std::vector<float> depths;
};

std::optional<DepthImage> readDepths(const std::string& path)
{
    DepthImage image;
    int channels = 0;
    const std::unique_ptr<stbi_us, void (*)(void*)> texels(
        stbi_load_16(path.c_str(), &image.width, &image.height, &channels, 1), stbi_image_free);
    if (!texels)
        return std::nullopt;
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t i = 0; i < count; ++i)
        image.depths.push_back(static_cast<float>(texels.get()[i]) / 65535.0f);
    return image;
}

// Ground at 0.9, boards over it at 0.75, and leaves far above both at 0.2.
DepthImage makeDepths()
{
    DepthImage image{128, 128, {}};
    for (int y = 0; y < image.height; ++y)
    {
        for (int x = 0; x < image.width; ++x)
        {
            const bool leaf = (x / 11 + y / 7) % 3 == 0;
            const bool board = y % 64 < 24;
            image.depths.push_back(leaf ? 0.2f : board ? 0.75f : 0.9f);
        }
    }
    return image;
}

int placeLayers(const DepthImage& image, int layerCount)
{
    std::vector<float> splits(static_cast<std::size_t>(layerCount) + 1);
    const lvsm::RelaxResult<float> result =
        lvsm::lloydRelax(image.depths.data(), image.width, image.height, splits.data(), layerCount);
    if (!result)
    {
        std::fprintf(stderr, "place_layers: %s\n", lvsm::describe(result.status));
        return 1;
    }
    std::printf("%s, after %d iterations\n", lvsm::describe(result.status), result.iterations);
    for (std::size_t i = 0; i + 1 < splits.size(); ++i)
    {
        std::printf("layer %zu: depth %.4f to %.4f\n", i, static_cast<double>(splits[i]),
                    static_cast<double>(splits[i + 1]));
    }
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    std::string path;
    int layerCount = 4;
    CLI::App app("Places the layers of a layered variance shadow map for a depth image.");
    app.add_option("IMAGE", path, "Grey image of 8 or 16 bits, black at the light (default: a made-up scene)");
    app.add_option("--layers", layerCount, "Number of layers")->check(CLI::Range(1, 64))->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    const auto image = path.empty() ? makeDepths() : readDepths(path);
    if (!image)
    {
        std::fprintf(stderr, "place_layers: cannot read '%s': %s\n", path.c_str(), stbi_failure_reason());
        return 1;
    }
    return placeLayers(*image, layerCount);
}
