// LVSM_ASSERT is the client's to replace, so this program is built apart from those that keep the default.
#include <stdexcept>

#define LVSM_ASSERT(condition) ((condition) ? void() : throw std::logic_error(#condition))

#include <lvsm/lvsm.hpp>

#include <doctest/doctest.h>

namespace
{

constexpr const float* kNoSplits = nullptr;

TEST_CASE("LVSM_ASSERT can be replaced and sees a null pointer")
{
    float splits[] = {0.0f, 0.5f, 1.0f};
    float* none = nullptr;
    CHECK_THROWS_AS(lvsm::layerIndex(0.5f, kNoSplits, 2), std::logic_error);
    CHECK_THROWS_AS(lvsm::nearestSplit(0.5f, kNoSplits, 2), std::logic_error);
    CHECK_THROWS_AS(lvsm::monotoneSplits(none, 2), std::logic_error);
    CHECK_THROWS_AS(lvsm::teleportSplits(none, splits, 2), std::logic_error);
    CHECK_THROWS_AS(lvsm::teleportSplits(splits, kNoSplits, 2), std::logic_error);
}

TEST_CASE("LVSM_ASSERT is silent where the preconditions hold")
{
    float splits[] = {0.0f, 0.5f, 1.0f};
    const float weights[] = {0.0f, 1.0f, 0.0f};
    CHECK_NOTHROW(lvsm::layerIndex(0.5f, splits, 2));
    CHECK_NOTHROW(lvsm::nearestSplit(0.5f, splits, 2));
    CHECK_NOTHROW(lvsm::monotoneSplits(splits, 2));
    CHECK_NOTHROW(lvsm::teleportSplits(splits, weights, 2));
}

TEST_CASE("host functions report a null pointer instead of asserting")
{
    float splits[] = {0.0f, 0.5f, 1.0f};
    float* none = nullptr;
    const float depths[] = {0.5f};
    CHECK_NOTHROW(lvsm::lloydRelax(kNoSplits, 1, 1, splits, 2));
    CHECK_NOTHROW(lvsm::lloydRelax(depths, 1, 1, none, 2));
}

} // namespace
