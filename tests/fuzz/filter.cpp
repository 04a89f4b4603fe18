// Filter weights and taps: their sums and ranges for any size, index and width.
#include <lvsm/convolution.hpp>
#include <lvsm/filter.hpp>

#include "bytes.hpp"

#include <algorithm>

namespace
{

using namespace lvsm;
using namespace lvsm::fuzz;

template <typename T>
bool isIn(T value, T low, T high)
{
    return value >= low && value <= high;
}

template <typename T>
void weigh(Bytes& bytes)
{
    const int size = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    const int index = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    const T sigma = bytes.number<T>();
    const int count = std::clamp(size, 1, kMaxFilterSize);

    T binomial = 0, gaussian = 0, binomialTaps = 0, gaussianTaps = 0;
    for (int i = 0; i < count; ++i)
    {
        binomial += binomialWeight<T>(i, size);
        gaussian += gaussianWeight(i, size, sigma);
        binomialTaps += binomialTap<T>(i, size).y;
        gaussianTaps += gaussianTap(i, size, sigma).y;
    }
    for (const T sum : {binomial, gaussian, binomialTaps, gaussianTaps})
        LVSM_CLAIM(isIn(sum, T(0.9999), T(1.0001)));
    LVSM_CLAIM(isIn(binomialWeight<T>(index, size), T(0), T(1)));
    LVSM_CLAIM(isIn(gaussianWeight(index, size, sigma), T(0), T(1)));
    LVSM_CLAIM(isIn(binomialTap<T>(index, size).x, T(-32), T(32)));
    LVSM_CLAIM(isIn(gaussianTap(index, size, sigma).x, T(-32), T(32)));

    const T width = bytes.number<T>(), other = bytes.number<T>();
    LVSM_CLAIM(isIn(boxWeight(sigma, width), T(0), T(1)));
    LVSM_CLAIM(isIn(linearPair(width, other).x, T(0), T(1)));
    LVSM_CLAIM(isIn(linearPair(width, other).y, T(0), kHuge<T>));
    LVSM_CLAIM(isIn(binomialHeadRoom<T>(size, index), T(1), kHuge<T>));
    LVSM_CLAIM(isIn(boxHeadRoom(width, other), T(1), kHuge<T>));
    LVSM_CLAIM(isIn(fourierOffset<T>(size), T(0), T(0.25)));
    LVSM_CLAIM(isIn(fourierAttenuation(index, size, sigma), T(0), T(1)));
    const glm::vec<4, T> sines = fourierSines(width, index, size), cosines = fourierCosines(width, index, size);
    LVSM_CLAIM(isIn(fourierSum(sines, cosines, other, sigma, index, size, width), T(-1.51), T(1.51)));
}

} // namespace

LVSM_FUZZ(weigh)
