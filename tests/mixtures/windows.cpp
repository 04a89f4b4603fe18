// lvsm_mixture_windows [WINDOWS] [SEED]: random windows by kind, what a coded mixture says of them beside brute force.
//
// A window is of width 7, made by the tree. The receiver is anywhere within half a texel of its centre, on a plane of its
// own, and the truth is the share of taps that are not in front of that plane, moved as a bilinear fetch moves them.
#include "../unit/windows.hpp"

#include <lvsm/mixture.hpp>
#include <lvsm/receiver.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace
{

constexpr int kRounds = 2;

class Random
{
public:
    explicit Random(unsigned seed) : m_engine(seed) {}

    float between(float low, float high)
    {
        return low + (high - low) * static_cast<float>(m_engine() >> 8) / 16777216.0f;
    }

private:
    std::mt19937 m_engine;
};

struct Plane
{
    float depth;
    glm::vec2 gradient;

    float at(const glm::vec2& p) const { return std::min(1.0f, std::max(0.0f, depth + glm::dot(gradient, p))); }
};

Plane anyPlane(Random& random, float nearest, float farthest)
{
    const float slope = 0.03f * std::pow(random.between(0.0f, 1.0f), 2.0f);
    const float angle = random.between(0.0f, 6.2831853f);
    return {random.between(nearest, farthest), {slope * std::cos(angle), slope * std::sin(angle)}};
}

// Which surface a tap sees: 0 is the farthest.
using Cover = int (*)(const glm::vec2& place, const float* numbers);

struct Kind
{
    const char* name;
    int surfaces;
    Cover cover;
};

float across(const glm::vec2& p, const float* n)
{
    return std::cos(n[0]) * p.x + std::sin(n[0]) * p.y - n[1];
}

const Kind kKinds[] = {
    {"one plane", 1,
     [](const glm::vec2&, const float*)
     {
         return 0;
     }},
    {"straight edge", 2,
     [](const glm::vec2& p, const float* n)
     {
         return across(p, n) > 0.0f ? 1 : 0;
     }},
    {"corner", 2,
     [](const glm::vec2& p, const float* n)
     {
         return across(p, n) > 0.0f && across(p, n + 2) > 0.0f ? 1 : 0;
     }},
    {"thin bar", 2,
     [](const glm::vec2& p, const float* n)
     {
         return std::abs(across(p, n)) < 0.7f ? 1 : 0;
     }},
    {"two edges", 3,
     [](const glm::vec2& p, const float* n)
     {
         return across(p, n) > 0.5f ? 1 : across(p, n) < -0.5f ? 2 : 0;
     }},
    {"edge over edge", 4,
     [](const glm::vec2& p, const float* n)
     {
         return (across(p, n) > 0.0f ? 1 : 0) + (across(p, n + 2) > 0.0f ? 2 : 0);
     }},
    {"leaves", 6,
     [](const glm::vec2& p, const float* n)
     {
         return static_cast<int>(std::abs(std::sin(12.9898f * p.x + 78.233f * p.y + n[0]) * 43758.547f)) % 6;
     }},
};

struct Tally
{
    long windows = 0;
    double sum = 0.0;
    double squares = 0.0;
    double worst = 0.0;

    void add(double error)
    {
        ++windows;
        sum += std::abs(error);
        squares += error * error;
        worst = std::max(worst, std::abs(error));
    }
};

// Errors of four planes in 128 bits and of two in 64, of one window.
void tryWindow(const Kind& kind, Random& random, Tally& four, Tally& two)
{
    Plane surfaces[6];
    for (int i = 0; i < kind.surfaces; ++i)
        surfaces[i] = anyPlane(random, 0.1f, 0.9f);
    const float numbers[4] = {random.between(0.0f, 6.2831853f), random.between(-1.5f, 1.5f),
                              random.between(0.0f, 6.2831853f), random.between(-1.5f, 1.5f)};
    const lvsm::unit::DepthMap map = [&](int x, int y)
    {
        const glm::vec2 p(x, y);
        return static_cast<double>(surfaces[kind.cover(p, numbers)].at(p));
    };
    // On one of the surfaces, or anywhere.
    const int own = static_cast<int>(random.between(0.0f, static_cast<float>(kind.surfaces) + 1.0f));
    const Plane receiver = own < kind.surfaces ? surfaces[own] : anyPlane(random, 0.1f, 0.9f);
    const glm::vec2 f(random.between(-0.5f, 0.5f), random.between(-0.5f, 0.5f));
    const double truth =
        lvsm::unit::shareOfWindow(map, kRounds, glm::dvec2(f),
                                  [&](int x, int y, double depth)
                                  { return depth >= static_cast<double>(receiver.at(glm::vec2(x, y))) - 1.0e-6; });
    const float sigma = lvsm::mixtureDeviation(kRounds);
    const float depth = lvsm::shiftReceiver(receiver.at(f), receiver.gradient, 0.5f);
    const auto add = [&](Tally& tally, float visibility)
    {
        tally.add(static_cast<double>(visibility) - truth);
    };
    add(four,
        lvsm::mixtureVisibility4(lvsm::encodeMixture4(lvsm::unit::WindowTree<float>(map, kRounds, 4).mixture(), sigma),
                                 f, depth, receiver.gradient, sigma, lvsm::kMixtureBias<float>));
    add(two,
        lvsm::mixtureVisibility2(lvsm::encodeMixture2(lvsm::unit::WindowTree<float>(map, kRounds, 2).mixture(), sigma),
                                 f, depth, receiver.gradient, sigma, lvsm::kMixtureBias<float>));
}

} // namespace

int main(int argc, char** argv)
{
    const long windows = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1000000;
    const unsigned seed = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1u;
    if (windows <= 0)
    {
        std::fprintf(stderr, "usage: lvsm_mixture_windows [WINDOWS] [SEED]\n");
        return 2;
    }
    bool passed = true;
    std::printf(
        "| kind of window | windows | K = 4, 128 bits: mean, RMSE, worst | K = 2, 64 bits |\n|---|---|---|---|\n");
    for (const Kind& kind : kKinds)
    {
        Random random(seed);
        Tally four;
        Tally two;
        for (long i = 0; i < windows / static_cast<long>(std::size(kKinds)) + 1; ++i)
            tryWindow(kind, random, four, two);
        const auto print = [](const Tally& t)
        {
            const double n = static_cast<double>(t.windows);
            std::printf(" %.4f, %.4f, %.2f |", t.sum / n, std::sqrt(t.squares / n), t.worst);
        };
        std::printf("| %s | %ld |", kind.name, four.windows);
        print(four);
        print(two);
        std::printf("\n");
        // A surface alone is never its own shadow, and what is in front of all or behind it is known.
        const bool isAlone = kind.surfaces == 1;
        passed = passed && (!isAlone || four.sum / static_cast<double>(four.windows) < 0.01);
    }
    return passed ? 0 : 1;
}
