#ifndef LVSM_TESTS_PAPERS_PANELS_HPP
#define LVSM_TESTS_PAPERS_PANELS_HPP

#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace lvsm::papers
{

/// Pictures of one size, side by side.
class Panels
{
public:
    Panels(int width, int height, int count);

    int width() const { return m_width; }
    int height() const { return m_height; }
    /// A pixel of one of them; the first row is the uppermost.
    glm::vec3& at(int panel, int x, int y);

    /// The reason if it cannot be written.
    std::optional<std::string> write(const std::string& path) const;

private:
    int m_width, m_height, m_count;
    std::vector<glm::vec3> m_colours;
};

} // namespace lvsm::papers

#endif
