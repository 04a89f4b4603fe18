#include "placing_images.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace sampling
{
namespace
{

using Depth = std::function<float(int, int)>;

constexpr int kRandomImages = 6;

Depth noise(float low, float high)
{
    return [=, random = Random()](int, int) mutable
    {
        return low + (high - low) * random.next();
    };
}

// Boxes of random places, sizes and depths over a ground.
Depth boxes(unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&](int below)
    {
        return static_cast<int>(random() % static_cast<unsigned>(below));
    };
    std::vector<glm::ivec4> edges;
    std::vector<float> depths;
    for (int i = 0; i < 24; ++i)
    {
        edges.emplace_back(number(kMap.width), number(kMap.height), 3 + number(30), 3 + number(30));
        depths.push_back(static_cast<float>(number(1 << 20)) / (1 << 20));
    }
    return [=](int x, int y)
    {
        float nearest = 1;
        for (std::size_t i = 0; i < edges.size(); ++i)
        {
            const glm::ivec4 box = edges[i];
            const bool inside = x >= box.x && y >= box.y && x < box.x + box.z && y < box.y + box.w;
            nearest = inside ? std::min(nearest, depths[i]) : nearest;
        }
        return nearest;
    };
}

} // namespace

Depths::Depths(const Depth& depth)
{
    for (std::size_t i = 0; i < pixels.texels.size(); ++i)
        pixels.texels[i] = glm::vec4(i % 3 == 0 ? 0.0f : 1.0f);
    for (int y = 0; y < kMap.height; ++y)
    {
        for (int x = 0; x < kMap.width; ++x)
        {
            values.push_back(depth(x, y));
            pixels.at(kMap.x + x, kMap.y + y).x = values.back();
        }
    }
}

float tree(int x, int y, float time)
{
    const int along = x + static_cast<int>(20 * time);
    const bool leaf = (along / 3 * 7 + y / 2 * 5) % 11 < 3 && y > 20;
    const bool board = (y + along / 5) % 40 < 18;
    const float ground = 0.7f + 0.002f * static_cast<float>(x) + 0.05f * time;
    return leaf ? 0.1f + 0.02f * static_cast<float>(along % 5) : board ? ground - 0.3f - 0.1f * time : ground;
}

Depths projectedTree()
{
    const auto projected = [](int x, int y)
    {
        const float distance = 1 + tree(x, y, 0) * (kFar - 1);
        return (kFar / distance - 1) / (kFar - 1);
    };
    Depths image(projected);
    for (float& value : image.values)
        value = lvsm::linearDepthReversed(value, 1.0f, kFar);
    return image;
}

std::vector<Depths> stillImages()
{
    std::vector<Depths> images;
    images.emplace_back([](int x, int y) { return tree(x, y, 0); });
    images.emplace_back([](int x, int y) { return (x / 9 + y / 13) % 4 == 0 ? 0.125f : 0.875f; });
    images.emplace_back([](int x, int y) { return 0.1f * static_cast<float>(1 + (x / 7 * 3 + y / 5) % 9); });
    images.emplace_back(noise(0, 1));
    // Steps so small that their variances are near the least one that counts.
    images.emplace_back([](int x, int y)
                        { return 0.96f + 0.003f * std::sqrt(static_cast<float>((x / 4 + y / 3) % 5)); });
    // Curved, as evenly spaced depths would lie on the very middle between two splits.
    images.emplace_back([](int x, int) { return static_cast<float>(x * (x + 300)) / 60000.0f; });
    for (int i = 0; i < kRandomImages; ++i)
        images.emplace_back(boxes(static_cast<unsigned>(i)));
    images.emplace_back([](int, int) { return 0.5f; });
    return images;
}

} // namespace sampling
