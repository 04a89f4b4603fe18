#ifndef LVSM_TESTS_QUALITY_IMAGE_HPP
#define LVSM_TESTS_QUALITY_IMAGE_HPP

#include <cstddef>
#include <vector>

namespace lvsm::quality
{

/// Number of a texel in a square image, row by row.
constexpr std::size_t texelIndex(int x, int y, int size)
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
}

/// A square image of any number of channels.
class Image
{
public:
    Image(int size, int channels)
        : size_(size), channels_(channels), values_(texelIndex(0, size, size) * static_cast<std::size_t>(channels))
    {
    }

    int size() const { return size_; }
    int channels() const { return channels_; }
    float* texel(int x, int y) { return values_.data() + offset(x, y); }
    const float* texel(int x, int y) const { return values_.data() + offset(x, y); }

private:
    std::size_t offset(int x, int y) const { return texelIndex(x, y, size_) * static_cast<std::size_t>(channels_); }

    int size_;
    int channels_;
    std::vector<float> values_;
};

} // namespace lvsm::quality

#endif
