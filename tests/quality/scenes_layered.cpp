#include "scenes_layered.hpp"

#include <algorithm>
#include <functional>
#include <random>

namespace lvsm::quality
{
namespace
{

class Layers
{
public:
    Layers(int size, unsigned seed) : m_size(size), m_random(seed), m_texels(texelIndex(0, size, size)) {}

    float u() { return m_uniform(m_random); }
    float extent() const { return static_cast<float>(m_size); }

    void ground(float depth, float slopeY)
    {
        for (int y = 0; y < m_size; ++y)
        {
            for (int x = 0; x < m_size; ++x)
                add(x, y, depth + slopeY * static_cast<float>(y), slopeY);
        }
    }

    void disc(float centreX, float centreY, float radius, float depth)
    {
        const auto covers = [=](int x, int y)
        {
            const float dx = static_cast<float>(x) - centreX;
            const float dy = static_cast<float>(y) - centreY;
            return dx * dx + dy * dy < radius * radius;
        };
        fill({centreX - radius, centreY - radius}, {centreX + radius, centreY + radius}, depth, covers);
    }

    void rectangle(float x, float y, float width, float height, float depth)
    {
        fill({x, y}, {x + width, y + height}, depth, [](int, int) { return true; });
    }

    void stripes(int number, int period, float depth)
    {
        const auto covers = [=](int x, int y)
        {
            return ((number % 2 == 0 ? x : y) + 7 * number) % period < period / 2;
        };
        fill({0.0f, 0.0f}, {extent(), extent()}, depth, covers);
    }

    Scene scene(const std::string& name) && { return {name, Peel(m_size, std::move(m_texels)), false}; }

private:
    void add(int x, int y, float depth, float slopeY)
    {
        m_texels[texelIndex(x, y, m_size)].push_back({depth, {0.0f, slopeY}, 1.0f});
    }

    void fill(glm::vec2 low, glm::vec2 high, float depth, const std::function<bool(int, int)>& covers)
    {
        for (int y = std::max(0, static_cast<int>(low.y)); y < m_size && static_cast<float>(y) <= high.y; ++y)
        {
            for (int x = std::max(0, static_cast<int>(low.x)); x < m_size && static_cast<float>(x) <= high.x; ++x)
            {
                if (covers(x, y))
                    add(x, y, depth, 0.0f);
            }
        }
    }

    int m_size;
    std::mt19937 m_random;
    std::uniform_real_distribution<float> m_uniform{0.0f, 1.0f};
    std::vector<std::vector<Surface>> m_texels;
};

// Each draw is a statement of its own: the order of a call's arguments is the compiler's.
Scene foliage(int size, unsigned seed)
{
    Layers layers(size, seed);
    layers.ground(0.95f, 0.0f);
    for (int i = 0; i < 900; ++i)
    {
        const float x = layers.extent() * layers.u();
        const float y = layers.extent() * layers.u();
        const float radius = 2.0f + 10.0f * layers.u();
        layers.disc(x, y, radius, 0.1f + 0.75f * layers.u());
    }
    return std::move(layers).scene("foliage");
}

Scene fence(int size, unsigned)
{
    Layers layers(size, 0);
    layers.ground(0.9f, 0.0f);
    constexpr float depths[] = {0.08f, 0.15f, 0.5f, 0.8f};
    constexpr int periods[] = {17, 23, 29, 13};
    for (int k = 0; k < 4; ++k)
        layers.stripes(k, periods[k], depths[k]);
    return std::move(layers).scene("fence");
}

Scene stack(int size, unsigned seed)
{
    Layers layers(size, seed + 2);
    layers.ground(0.99f, 0.0f);
    for (int i = 0; i < 24; ++i)
    {
        const float x = layers.extent() * layers.u();
        const float y = layers.extent() * layers.u();
        const float width = 30.0f + 120.0f * layers.u();
        const float height = 30.0f + 120.0f * layers.u();
        const float u = layers.u();
        layers.rectangle(x, y, width, height, i < 8 ? 0.02f + 0.1f * u : 0.85f + 0.12f * u);
    }
    return std::move(layers).scene("stack");
}

Scene slanted(int size, unsigned seed)
{
    Layers layers(size, seed + 3);
    layers.ground(0.5f, 0.4f / layers.extent());
    for (int i = 0; i < 60; ++i)
    {
        const float x = layers.extent() * layers.u();
        const float y = layers.extent() * layers.u();
        const float width = 5.0f + 40.0f * layers.u();
        const float height = 5.0f + 40.0f * layers.u();
        layers.rectangle(x, y, width, height, 0.1f + 0.35f * layers.u());
    }
    return std::move(layers).scene("slanted");
}

} // namespace

const std::vector<std::string>& layeredSceneNames()
{
    static const std::vector<std::string> names{"foliage", "fence", "stack", "slanted"};
    return names;
}

Scene layeredScene(const std::string& name, int size, unsigned seed)
{
    if (name == "foliage")
        return foliage(size, seed);
    if (name == "fence")
        return fence(size, seed);
    if (name == "stack")
        return stack(size, seed);
    return slanted(size, seed);
}

} // namespace lvsm::quality
