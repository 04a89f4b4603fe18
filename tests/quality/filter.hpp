#ifndef LVSM_TESTS_QUALITY_FILTER_HPP
#define LVSM_TESTS_QUALITY_FILTER_HPP

#include <vector>

#include "formats.hpp"
#include "image.hpp"

namespace lvsm::quality
{

/// Binomial weights of an odd width, in double, which sum to 1.
std::vector<double> binomialKernel(int width);

/// Standard deviation of a kernel, in texels.
double deviationOf(const std::vector<double>& kernel);

/// Separable filter; both passes store what they make. At the border the last texel repeats.
void blur(Image& image, const std::vector<double>& kernel, Format format);

} // namespace lvsm::quality

#endif
