#include "peel.hpp"

#include <algorithm>

namespace lvsm::quality
{

Peel::Peel(int size, std::vector<std::vector<Surface>> texels) : size_(size)
{
    first_.reserve(texels.size() + 1);
    first_.push_back(0);
    for (std::vector<Surface>& surfaces : texels)
    {
        std::stable_sort(surfaces.begin(), surfaces.end(),
                         [](const Surface& a, const Surface& b) { return a.depth < b.depth; });
        surfaces_.insert(surfaces_.end(), surfaces.begin(), surfaces.end());
        first_.push_back(surfaces_.size());
    }
}

} // namespace lvsm::quality
