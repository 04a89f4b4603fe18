#ifndef LVSM_TESTS_QUALITY_PARALLEL_HPP
#define LVSM_TESTS_QUALITY_PARALLEL_HPP

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace lvsm::quality
{

/// Calls work(0) to work(count - 1), each once, from as many threads as there are cores.
template <typename Work>
void parallelFor(std::size_t count, const Work& work)
{
    std::atomic<std::size_t> next{0};
    const auto run = [&]
    {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::thread> helpers;
    const std::size_t threads = std::min<std::size_t>(count, std::max(1u, std::thread::hardware_concurrency()));
    for (std::size_t i = 1; i < threads; ++i)
        helpers.emplace_back(run);
    run();
    for (std::thread& helper : helpers)
        helper.join();
}

} // namespace lvsm::quality

#endif
