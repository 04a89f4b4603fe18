#ifndef LVSM_TESTS_QUALITY_IMAGE_HPP
#define LVSM_TESTS_QUALITY_IMAGE_HPP

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

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
        : m_size(size), m_channels(channels), m_values(texelIndex(0, size, size) * static_cast<std::size_t>(channels))
    {
    }

    int size() const { return m_size; }
    int channels() const { return m_channels; }
    float* texel(int x, int y) { return m_values.data() + offset(x, y); }
    const float* texel(int x, int y) const { return m_values.data() + offset(x, y); }

    /// A bilinear sample of one channel; whole numbers are the centres of texels, and the last ones repeat.
    float bilinear(glm::vec2 place, int channel) const
    {
        const glm::vec2 inside = glm::clamp(place, 0.0f, static_cast<float>(m_size - 1));
        const glm::ivec2 low = glm::min(glm::ivec2(inside), m_size - 2);
        const glm::vec2 f = inside - glm::vec2(low);
        const float* first = texel(low.x, low.y) + channel;
        const float* second = texel(low.x, low.y + 1) + channel;
        return glm::mix(glm::mix(first[0], first[m_channels], f.x), glm::mix(second[0], second[m_channels], f.x), f.y);
    }

private:
    std::size_t offset(int x, int y) const { return texelIndex(x, y, m_size) * static_cast<std::size_t>(m_channels); }

    int m_size;
    int m_channels;
    std::vector<float> m_values;
};

} // namespace lvsm::quality

#endif
