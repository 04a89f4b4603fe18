#include "checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sampling
{

float Random::next()
{
    m_state = m_state * 1664525u + 1013904223u;
    return static_cast<float>(m_state >> 8) / static_cast<float>(1 << 24);
}

void Comparison::expect(double answer, double expected, double tolerance, const std::string& where)
{
    ++m_count;
    const double error = std::abs(answer - expected);
    m_worst = std::isnan(error) ? error : std::max(m_worst, error);
    if (error <= tolerance)
        return;
    if (m_failures++ == 0)
        std::printf("FAIL %s: expected %.9g within %.3g, got %.9g at %s\n", m_what.c_str(), expected, tolerance, answer,
                    where.c_str());
}

bool Comparison::passed() const
{
    const bool passed = m_count > 0 && m_failures == 0;
    std::printf("%s %s: %ld results, %ld wrong, worst error %.3g\n", passed ? "ok  " : "FAIL", m_what.c_str(), m_count,
                m_failures, m_worst);
    return passed;
}

} // namespace sampling
