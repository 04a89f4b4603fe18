#include "filter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <lvsm/filter.hpp>

namespace lvsm::quality
{
namespace
{

void pass(const Image& from, Image& to, const std::vector<float>& kernel, int stepX, int stepY, Format format)
{
    const int radius = static_cast<int>(kernel.size()) / 2;
    const int last = from.size() - 1;
    std::vector<float> sum(static_cast<std::size_t>(from.channels()));
    for (int y = 0; y <= last; ++y)
    {
        for (int x = 0; x <= last; ++x)
        {
            std::fill(sum.begin(), sum.end(), 0.0f);
            for (int k = -radius; k <= radius; ++k)
            {
                const float* tap = from.texel(std::clamp(x + k * stepX, 0, last), std::clamp(y + k * stepY, 0, last));
                const float weight = kernel[static_cast<std::size_t>(k + radius)];
                for (std::size_t c = 0; c < sum.size(); ++c)
                    sum[c] += weight * tap[c];
            }
            float* out = to.texel(x, y);
            for (std::size_t c = 0; c < sum.size(); ++c)
                out[c] = stored(sum[c], format);
        }
    }
}

std::vector<double> kernelOf(const std::vector<Round>& rounds)
{
    std::vector<double> kernel{1.0};
    for (const Round& round : rounds)
    {
        const std::size_t step = static_cast<std::size_t>(round.step);
        std::vector<double> wider(kernel.size() + 2 * step);
        for (std::size_t i = 0; i < kernel.size(); ++i)
        {
            wider[i] += round.share * kernel[i];
            wider[i + step] += (1.0 - 2.0 * round.share) * kernel[i];
            wider[i + 2 * step] += round.share * kernel[i];
        }
        kernel = wider;
    }
    return kernel;
}

} // namespace

std::vector<double> binomialKernel(int width)
{
    std::vector<double> kernel;
    for (int i = 0; i < width; ++i)
        kernel.push_back(binomialWeight<double>(i, width));
    return kernel;
}

std::vector<Round> Window::rounds() const
{
    std::vector<Round> rounds;
    for (int left = width / 2, step = 1; left > 0; left -= step, step *= tree ? 2 : 1)
        rounds.push_back({step, 0.25});
    return rounds;
}

std::vector<double> Window::kernel() const
{
    return tree ? kernelOf(rounds()) : binomialKernel(width);
}

std::vector<double> Window::cut(double deviations) const
{
    const std::vector<double> whole = kernel();
    const auto middle = whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2);
    const double reach = std::floor(deviations * deviationOf(whole));
    const auto radius = static_cast<std::ptrdiff_t>(std::min(reach, static_cast<double>(whole.size() / 2)));
    std::vector<double> kept(middle - radius, middle + radius + 1);
    const double sum = std::accumulate(kept.begin(), kept.end(), 0.0);
    for (double& weight : kept)
        weight /= sum;
    return kept;
}

std::vector<double> Window::before(int tapsAcross, bool half) const
{
    // What a bilinear sample between texels, or a texel for 2 x 2, filters by itself.
    constexpr double kOwnOfHalf = 0.5;
    if (tree && half)
    {
        std::vector<Round> less = rounds();
        const double step = less.back().step;
        less.back().share -= 0.5 * kOwnOfHalf / (step * step);
        return kernelOf(less);
    }
    if (tree)
        return kernel();
    const int left = tapsAcross % 2 == 1 ? width - tapsAcross + 1 : width - tapsAcross;
    return binomialKernel(std::max(1, half ? left - 2 : left));
}

double deviationOf(const std::vector<double>& kernel)
{
    const double centre = 0.5 * static_cast<double>(kernel.size() - 1);
    double variance = 0.0;
    for (std::size_t i = 0; i < kernel.size(); ++i)
    {
        const double offset = static_cast<double>(i) - centre;
        variance += kernel[i] * offset * offset;
    }
    return std::sqrt(variance);
}

ShiftedKernel::ShiftedKernel(const std::vector<double>& kernel, float offset)
    : m_first(static_cast<int>(std::floor(offset)) - static_cast<int>(kernel.size()) / 2), m_weights(kernel.size() + 1)
{
    const double fraction = static_cast<double>(offset - std::floor(offset));
    for (std::size_t i = 0; i < kernel.size(); ++i)
    {
        m_weights[i] += (1.0 - fraction) * kernel[i];
        m_weights[i + 1] += fraction * kernel[i];
    }
}

void blur(Image& image, const std::vector<double>& kernel, Format format)
{
    const std::vector<float> weights(kernel.begin(), kernel.end());
    Image between(image.size(), image.channels());
    pass(image, between, weights, 1, 0, format);
    pass(between, image, weights, 0, 1, format);
}

Image halved(const Image& image)
{
    Image half(image.size() / 2, image.channels());
    for (int y = 0; y < half.size(); ++y)
    {
        for (int x = 0; x < half.size(); ++x)
        {
            for (int c = 0; c < image.channels(); ++c)
            {
                half.texel(x, y)[c] = 0.25f * (image.texel(2 * x, 2 * y)[c] + image.texel(2 * x + 1, 2 * y)[c] +
                                               image.texel(2 * x, 2 * y + 1)[c] + image.texel(2 * x + 1, 2 * y + 1)[c]);
            }
        }
    }
    return half;
}

} // namespace lvsm::quality
