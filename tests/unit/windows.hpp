// Filter windows of a depth map as mixtures, made by the tree, beside the same windows tap by tap.
#ifndef LVSM_TESTS_UNIT_WINDOWS_HPP
#define LVSM_TESTS_UNIT_WINDOWS_HPP

#include <lvsm/components.hpp>

#include <functional>
#include <vector>

#include "numbers.hpp"

namespace lvsm::unit
{

// Depth at a whole offset from the window's centre.
using DepthMap = std::function<double(int, int)>;

// The mixture of the window after so many rounds of the tree, simplified.
template <typename T>
class WindowTree
{
public:
    WindowTree(const DepthMap& map, int rounds, int count) : map_(map), count_(count)
    {
        mixture_ = window(0, 0, rounds);
        simplifyMixture(mixture_, count_);
    }

    const Mixture<T>& mixture() const { return mixture_; }

private:
    Mixture<T> window(int x, int y, int rounds) const
    {
        if (rounds == 0)
        {
            Mixture<T> tap{};
            tap.components[0] = tapComponent(static_cast<T>(map_(x, y)));
            return tap;
        }
        const int step = 1 << (rounds - 1);
        Mixture<T> rows[3];
        for (int i = 0; i < 3; ++i)
        {
            const int at = y + (i - 1) * step;
            const Mixture<T> taps[3] = {window(x - step, at, rounds - 1), window(x, at, rounds - 1),
                                        window(x + step, at, rounds - 1)};
            rows[i] = mixed(taps, Vec2<T>(T(step), T(0)));
        }
        return mixed(rows, Vec2<T>(T(0), T(step)));
    }

    Mixture<T> mixed(const Mixture<T>* three, const Vec2<T>& step) const
    {
        Mixture<T> sum{};
        for (const int i : {1, 0, 2})
        {
            for (int k = 0; k < count_; ++k)
            {
                const Vec2<T> offset = step * T(i - 1);
                insertComponent(sum, moveComponent(three[i].components[k], offset, i == 1 ? T(0.5) : T(0.25)), count_);
            }
        }
        return sum;
    }

    const DepthMap& map_;
    int count_;
    Mixture<T> mixture_;
};

// Weights of the tree's window along an axis, which sum to 1; the middle one is the centre's.
inline std::vector<double> treeKernel(int rounds)
{
    std::vector<double> kernel{1.0};
    for (int round = 0; round < rounds; ++round)
    {
        const std::size_t step = std::size_t(1) << round;
        std::vector<double> wider(kernel.size() + 2 * step);
        for (std::size_t i = 0; i < kernel.size(); ++i)
        {
            wider[i] += 0.25 * kernel[i];
            wider[i + step] += 0.5 * kernel[i];
            wider[i + 2 * step] += 0.25 * kernel[i];
        }
        kernel = wider;
    }
    return kernel;
}

// Share of the window that passes a test of (x, y, depth), the window moved by f as a bilinear fetch moves it.
template <typename Test>
double shareOfWindow(const DepthMap& map, int rounds, const Vec2<double>& f, const Test& test)
{
    const std::vector<double> kernel = treeKernel(rounds);
    const int radius = static_cast<int>(kernel.size()) / 2;
    const auto weight = [&](int offset, double moved)
    {
        const auto at = [&](int i)
        {
            return std::abs(i) > radius ? 0.0 : kernel[static_cast<std::size_t>(i + radius)];
        };
        const double place = offset - moved;
        const int below = static_cast<int>(std::floor(place));
        return (below + 1 - place) * at(below) + (place - below) * at(below + 1);
    };
    double share = 0.0;
    for (int y = -radius - 2; y <= radius + 2; ++y)
    {
        for (int x = -radius - 2; x <= radius + 2; ++x)
            share += test(x, y, map(x, y)) ? weight(x, f.x) * weight(y, f.y) : 0.0;
    }
    return share;
}

} // namespace lvsm::unit

#endif
