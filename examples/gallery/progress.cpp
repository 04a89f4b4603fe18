#include "progress.hpp"

#include <cstdio>

namespace lvsm::gallery
{

Progress::Progress(std::size_t steps) : m_steps(steps), m_begin(std::chrono::steady_clock::now()) {}

void Progress::step(const std::string& what)
{
    ++m_done;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - m_begin;
    const double left = passed.count() * static_cast<double>(m_steps - m_done) / static_cast<double>(m_done);
    std::fprintf(stderr, "[%3zu %%, %.0f s left] %s\n", 100 * m_done / m_steps, left, what.c_str());
}

} // namespace lvsm::gallery
