// What is outside its range counts as the end of it.
#ifndef LVSM_TESTS_UNIT_RANGES_HPP
#define LVSM_TESTS_UNIT_RANGES_HPP

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numbers.hpp"

namespace lvsm::unit
{

// Of one argument. Where it matters near an end, a limit of half as much is told apart from that end.
template <typename T>
struct Range
{
    T least;
    T most;
    bool mattersAtLeast = true;
    bool mattersAtMost = true;
};

// To half of the digits: an end that a compiler knows as a constant, it may work out with other products fused into sums.
template <typename T>
bool isSame(T a, T b)
{
    return std::abs(a - b) <= std::sqrt(std::numeric_limits<T>::epsilon()) * std::max(T(1), std::abs(b));
}

template <glm::length_t L, typename T, glm::qualifier Q>
bool isSame(const glm::vec<L, T, Q>& a, const glm::vec<L, T, Q>& b)
{
    bool same = true;
    for (glm::length_t i = 0; i < L; ++i)
        same = same && isSame(a[i], b[i]);
    return same;
}

// The function takes an array of numbers. Each of them, taken out of its range, has to give what the end gives, wherever
// the others are in their ranges.
template <typename T, std::size_t N, typename Function>
void checkEnds(const std::array<Range<T>, N>& ranges, const Function& function)
{
    Random random(171);
    for (std::size_t i = 0; i < N; ++i)
    {
        CAPTURE(i);
        const Range<T>& range = ranges[i];
        const T length = range.most - range.least;
        bool seenAtLeast = false, seenAtMost = false;
        Tally tally;
        for (int round = 0; round < 500; ++round)
        {
            std::array<T, N> arguments{};
            for (std::size_t k = 0; k < N; ++k)
                arguments[k] = ranges[k].least + (ranges[k].most - ranges[k].least) * random.unit<T>();
            const auto with = [&](T value)
            {
                arguments[i] = value;
                return function(arguments);
            };
            const auto atLeast = with(range.least);
            const auto atMost = with(range.most);
            for (const T beyond : {T(0.25), T(0.75), T(2)})
            {
                tally.claim(isSame(with(range.least - beyond * length), atLeast), round, beyond);
                tally.claim(isSame(with(range.most + beyond * length), atMost), round, beyond);
            }
            seenAtLeast = seenAtLeast || !isSame(with(range.least + T(0.25) * length), atLeast);
            seenAtMost = seenAtMost || !isSame(with(range.most - T(0.25) * length), atMost);
        }
        LVSM_CHECK_TALLY(tally);
        CHECK((seenAtLeast || !range.mattersAtLeast));
        CHECK((seenAtMost || !range.mattersAtMost));
    }
}

} // namespace lvsm::unit

#endif
