#include "passes_truth.hpp"

#include <algorithm>
#include <cmath>

namespace sampling
{
namespace
{

using Vec4 = glm::dvec4;

const float kSplits[] = {0, 0.25f, 0.625f, 1};

bool isIn(const lvsm::Rectangle& rectangle, int x, int y)
{
    return x >= rectangle.x && x < rectangle.x + rectangle.width && y >= rectangle.y &&
           y < rectangle.y + rectangle.height;
}

std::string describe(int x, int y, int slice)
{
    return std::to_string(x) + ' ' + std::to_string(y) + " slice " + std::to_string(slice);
}

// A blurred texel: every tap of a window on the map, and border for those off it.
Vec4 blurred(const Blur& blur, const Pixels& pixels, int x, int y, int slice)
{
    const int size = blur.kernel.size;
    Vec4 sum(0);
    Vec4 largest(0);
    for (int k = 0; k < size * size; ++k)
    {
        const int tapX = x + k % size - size / 2;
        const int tapY = y + k / size - size / 2;
        const Vec4 tap = isIn(blur.map, tapX, tapY) ? Vec4(pixels.at(tapX, tapY, slice)) : Vec4(kBorder);
        largest = glm::max(largest, tap);
        sum += blur.weight(k % size) * blur.weight(k / size) * tap;
    }
    return blur.maximum ? largest : sum;
}

Vec4 twoLayers(double depth, int slice)
{
    const auto moments = [&](int layer)
    {
        if (layer >= 3)
            return glm::dvec2(1, 1);
        return lvsm::layerMoments(depth, lvsm::layerInterval<double>(kSplits[layer], kSplits[layer + 1], 0.0625));
    };
    return lvsm::packLayers(moments(2 * slice), moments(2 * slice + 1));
}

const glm::dvec2 kExponents(40, 10);
const glm::dvec2 kInterval(0.2, 0.9);
constexpr double kMinVariance = 1e-5;

double groundDepth(double x, double slope)
{
    return 0.5 + slope * (x - 0.5 * kWidth);
}

Vec4 groundTexel(Ground ground, double depth)
{
    if (ground == Ground::Exponential)
        return lvsm::exponentialMoments(depth, kExponents);
    return Vec4(lvsm::layerMoments(depth, kInterval), 0, 0);
}

// From a bilinear sample at a position in texels.
double groundVisibility(Ground ground, double slope, const Pixels& blurred, double x)
{
    const auto texel = [&](int at)
    {
        return at >= 0 && at < kWidth ? Vec4(blurred.at(at, kHeight / 2)) : groundTexel(ground, 1);
    };
    const double corner = std::floor(x - 0.5);
    const double fraction = x - 0.5 - corner;
    const auto first = static_cast<int>(corner);
    const Vec4 sample = texel(first) * (1 - fraction) + texel(first + 1) * fraction;
    const double depth = groundDepth(x, slope);
    return ground == Ground::Exponential ? lvsm::exponentialVisibility4(sample, depth, kExponents, kMinVariance)
                                         : lvsm::layeredVisibility(glm::dvec2(sample), depth, kInterval, kMinVariance);
}

} // namespace

Pixels randomPixels(int slices)
{
    Pixels pixels(kWidth, kHeight, slices);
    Random random;
    for (glm::vec4& texel : pixels.texels)
        texel = {random.next(), random.next(), random.next(), random.next()};
    return pixels;
}

Blur binomialBlur()
{
    return {lvsm::binomialKernel(9), [](int i)
            {
                return lvsm::binomialWeight<double>(i, 9);
            }};
}

Blur gaussianBlur()
{
    return {lvsm::gaussianKernel(7, 1.5f), [](int i)
            {
                return lvsm::gaussianWeight(i, 7, 1.5);
            }};
}

Blur boxBlur()
{
    return {lvsm::boxKernel(3.5f, false), [](int i)
            {
                return lvsm::boxWeight(i - 2.0, 3.5);
            }};
}

Blur largestOfPart()
{
    Blur blur{lvsm::boxKernel(5, false), [](int i)
              {
                  return lvsm::boxWeight(i - 2.0, 5.0);
              }};
    blur.map = {2, 1, 20, 18};
    blur.region = {4, 1, 18, 15};
    blur.maximum = true;
    return blur;
}

Blur blurOfPart()
{
    Blur blur = binomialBlur();
    blur.map = {2, 1, 20, 18};
    blur.region = {4, 2, 11, 15};
    return blur;
}

bool compareBlur(const std::string& what, const Blur& blur, const Pixels& source, const Pixels& target, int bits)
{
    // A sampler places a fetch between two texels in steps of 2^-bits: of values in [0,4], each direction is off by at
    // most half a step. Both directions, and their rounding.
    const double tolerance = 4 * (std::ldexp(1.0, -bits) + 1.0 / (1 << 20));
    const lvsm::Rectangle written = blur.passes().down.region;
    Comparison comparison(what);
    for (int i = 0; i < kWidth * kHeight * kSlices; ++i)
    {
        const int x = i % kWidth;
        const int y = i / kWidth % kHeight;
        const int slice = i / (kWidth * kHeight);
        const Vec4 expected = isIn(written, x, y) ? blurred(blur, source, x, y, slice) : Vec4(0);
        for (int c = 0; c < 4; ++c)
            comparison.expect(static_cast<double>(target.at(x, y, slice)[c]), expected[c], tolerance,
                              describe(x, y, slice));
    }
    return comparison.passed();
}

Pixels groundMap(Ground ground, double slope)
{
    Pixels pixels(kWidth, kHeight, kSlices);
    for (std::size_t i = 0; i < pixels.texels.size(); ++i)
        pixels.texels[i] = groundTexel(ground, groundDepth(static_cast<double>(i % kWidth) + 0.5, slope));
    return pixels;
}

glm::vec4 groundBorder(Ground ground)
{
    return groundTexel(ground, 1);
}

bool compareGround(const std::string& what, Ground ground, double slope, const Pixels& blurred)
{
    // A kernel of 9 taps and the bilinear sample after it see no edge from 6 texels on.
    double middle = 1;
    double edge = 1;
    for (int step = -16 * 4; step <= 16 * (kWidth + 4); ++step)
    {
        const double x = step / 16.0;
        double& least = x > 6 && x < kWidth - 6 ? middle : edge;
        least = std::min(least, groundVisibility(ground, slope, blurred, x));
    }
    // A hundredth is nothing that anyone sees.
    Comparison comparison(what);
    comparison.expect(std::min(edge, middle), middle, 0.01, "slope " + std::to_string(slope));
    return comparison.passed();
}

Store layersStore()
{
    return {"", twoLayers};
}

Store exponentialStore(bool hlsl)
{
    const std::string exponents = hlsl ? "float2(5.0, 2.0)" : "vec2(5.0, 2.0)";
    return {"#define LVSM_STORE(depth, slice) lvsm_exponentialMoments(depth, " + exponents +
                ")\n#define LVSM_STORE_LARGEST LVSM_LARGEST_FP16\n",
            [](double depth, int)
            {
                return lvsm::exponentialMoments(depth, glm::dvec2(5, 2));
            }};
}

lvsm::Pass<lvsm::StoreBlock> storePassOfTest()
{
    return lvsm::storePass(kSplits, 3, 0.0625f, kWhole);
}

Pixels storeDepths()
{
    Pixels pixels = randomPixels(1);
    pixels.at(0, 0).x = 0;
    pixels.at(1, 0).x = 1;
    return pixels;
}

bool compareStore(const std::string& what, const Store& store, const Pixels& depths, const Pixels& target)
{
    Comparison comparison(what);
    for (int i = 0; i < kWidth * kHeight * kSlices; ++i)
    {
        const int x = i % kWidth;
        const int y = i / kWidth % kHeight;
        const int slice = i / (kWidth * kHeight);
        const Vec4 expected = store.texel(static_cast<double>(depths.at(x, y).x), slice);
        for (int c = 0; c < 4; ++c)
        {
            // Ten units of one division and a square, or 3 + 2 * 5 of an exponential of 5 and its square.
            const double tolerance = 40.0 / (1 << 23) * std::max(1.0, std::abs(expected[c]));
            comparison.expect(static_cast<double>(target.at(x, y, slice)[c]), expected[c], tolerance,
                              describe(x, y, slice));
        }
    }
    return comparison.passed();
}

} // namespace sampling
