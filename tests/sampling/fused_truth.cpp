#include "fused_truth.hpp"

namespace sampling
{
namespace
{

constexpr float kSplits[] = {0, 0.25f, 0.625f, 1};
constexpr int kLayers = 3;
constexpr float kOverlap = 0.0625f;
glm::dvec4 storedTexel(double depth, int slice)
{
    const auto moments = [&](int layer)
    {
        if (layer >= kLayers)
            return glm::dvec2(1, 1);
        const double begin = static_cast<double>(kSplits[layer]);
        const double end = static_cast<double>(kSplits[layer + 1]);
        return lvsm::layerMoments(depth, lvsm::layerInterval(begin, end, static_cast<double>(kOverlap)));
    };
    return lvsm::packLayers(moments(2 * slice), moments(2 * slice + 1));
}

} // namespace

Pixels fusedDepths()
{
    Pixels depths(kFusedSize.width, kFusedSize.height);
    Random random;
    for (glm::vec4& texel : depths.texels)
        texel.x = random.next();
    return depths;
}

std::vector<Blur> fusedBlurs()
{
    const lvsm::Rectangle whole{0, 0, kFusedSize.width, kFusedSize.height};
    Blur binomial = binomialBlur();
    binomial.map = whole;
    binomial.region = whole;
    Blur box = boxBlur();
    box.map = {3, 1, 140, 9};
    box.region = {20, 3, 77, 4};
    Blur widest{lvsm::gaussianKernel(65, 12, false), [](int i) { return lvsm::gaussianWeight(i, 65, 12.0); }, whole,
                whole};
    return {binomial, box, widest};
}

lvsm::FusedPasses fusedPassesOf(const Blur& blur)
{
    return lvsm::fusedPasses(blur.kernel, kSplits, kLayers, kOverlap, blur.map, blur.region, kBorder);
}

bool compareFused(const std::string& what, const Blur& blur, const Pixels& result)
{
    const lvsm::Rectangle map = blur.map;
    const Pixels depths = fusedDepths();
    const lvsm::Rectangle region = fusedPassesOf(blur).store.region;
    Comparison comparison(what + ", " + std::to_string(blur.kernel.size) + " taps");
    for (int i = 0; i < kFusedSize.width * kFusedSize.height * kSlices; ++i)
    {
        const int x = i % kFusedSize.width;
        const int y = i / kFusedSize.width % kFusedSize.height;
        const int slice = i / kFusedSize.width / kFusedSize.height;
        const bool written =
            x >= region.x && x < region.x + region.width && y >= region.y && y < region.y + region.height;
        glm::dvec4 expected(0);
        for (int tap = 0; tap < blur.kernel.size && written; ++tap)
        {
            const int at = x + tap - blur.kernel.size / 2;
            const bool inside = at >= map.x && at < map.x + map.width;
            expected += blur.weight(tap) *
                        (inside ? storedTexel(static_cast<double>(depths.at(at, y).x), slice) : glm::dvec4(kBorder));
        }
        for (int c = 0; c < 4; ++c)
            // Ten units of one division and a square of each texel, and of values up to 4 the rounding of a weight, a
            // product and the sum.
            comparison.expect(static_cast<double>(result.at(x, y, slice)[c]), expected[c], (40.0 + 4 * 12) / (1 << 23),
                              std::to_string(x) + ' ' + std::to_string(y) + " slice " + std::to_string(slice));
    }
    return comparison.passed();
}

} // namespace sampling
