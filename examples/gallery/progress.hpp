#ifndef LVSM_GALLERY_PROGRESS_HPP
#define LVSM_GALLERY_PROGRESS_HPP

#include <chrono>
#include <cstddef>
#include <string>

namespace lvsm::gallery
{

/// Tells stderr how far the work is and how long the rest may take.
class Progress
{
public:
    explicit Progress(std::size_t steps);

    void step(const std::string& what);

private:
    std::size_t m_steps;
    std::size_t m_done = 0;
    std::chrono::steady_clock::time_point m_begin;
};

} // namespace lvsm::gallery

#endif
