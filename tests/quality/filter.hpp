#ifndef LVSM_TESTS_QUALITY_FILTER_HPP
#define LVSM_TESTS_QUALITY_FILTER_HPP

#include <vector>

#include "formats.hpp"
#include "image.hpp"

namespace lvsm::quality
{

/// Binomial weights of an odd width, in double, which sum to 1.
std::vector<double> binomialKernel(int width);

/// A step of a filter: three texels so far apart, the outer ones with this share each.
struct Round
{
    int step;
    double share;
};

/// The filter that everybody is given. A binomial one is rounds of step 1, each with a share of 1/4; the tree, by which
/// mixtures are made, doubles the step from round to round and has the widths 3, 7, 15 and so on.
struct Window
{
    int width;
    bool tree = false;

    std::vector<Round> rounds() const;
    std::vector<double> kernel() const;
    /// Its middle, so many deviations to each side, whole texels: what weighs hardly anything is left out.
    std::vector<double> cut(double deviations) const;
    /// What is left for a filter before n x n taps or a map of half resolution. The tree has no variant with taps.
    std::vector<double> before(int tapsAcross, bool half) const;
};

/// Standard deviation of a kernel, in texels.
double deviationOf(const std::vector<double>& kernel);

/// A kernel whose centre is between texels, as a bilinear sample of a filtered map weighs them: one texel wider.
class ShiftedKernel
{
public:
    /// offset: of the centre, in texels, from a texel's.
    ShiftedKernel(const std::vector<double>& kernel, float offset);

    int first() const { return m_first; }
    int last() const { return m_first + static_cast<int>(m_weights.size()) - 1; }
    double weight(int texel) const { return m_weights[static_cast<std::size_t>(texel - m_first)]; }

private:
    int m_first;
    std::vector<double> m_weights;
};

/// Separable filter; both passes store what they make. At the border the last texel repeats.
void blur(Image& image, const std::vector<double>& kernel, Format format);

/// A texel for 2 x 2 of an image of even size: their mean.
Image halved(const Image& image);

} // namespace lvsm::quality

#endif
