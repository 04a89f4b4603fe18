#include "panels.hpp"

#include "picture.hpp"

namespace lvsm::papers
{
namespace
{

constexpr int kGap = 4;

int rowWidth(int width, int count)
{
    return count * (width + kGap) - kGap;
}

} // namespace

Panels::Panels(int width, int height, int count)
    : m_width(width), m_height(height), m_count(count),
      m_colours(static_cast<std::size_t>(rowWidth(width, count)) * static_cast<std::size_t>(height), glm::vec3(1.0f))
{
}

glm::vec3& Panels::at(int panel, int x, int y)
{
    return m_colours[static_cast<std::size_t>(y * rowWidth(m_width, m_count) + panel * (m_width + kGap) + x)];
}

std::optional<std::string> Panels::write(const std::string& path) const
{
    return quality::writePng(path, m_colours, rowWidth(m_width, m_count));
}

} // namespace lvsm::papers
