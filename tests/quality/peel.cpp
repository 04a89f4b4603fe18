#include "peel.hpp"

#include <algorithm>

namespace lvsm::quality
{

Peel::Peel(int size, std::vector<std::vector<Surface>> texels) : m_size(size)
{
    m_first.reserve(texels.size() + 1);
    m_first.push_back(0);
    for (std::vector<Surface>& surfaces : texels)
    {
        std::stable_sort(surfaces.begin(), surfaces.end(),
                         [](const Surface& a, const Surface& b) { return a.depth < b.depth; });
        m_surfaces.insert(m_surfaces.end(), surfaces.begin(), surfaces.end());
        m_first.push_back(m_surfaces.size());
    }
}

} // namespace lvsm::quality
