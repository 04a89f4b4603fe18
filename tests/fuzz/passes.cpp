// What the host gives the passes: regions inside the map, as many groups as cover them, blocks in their ranges, for maps
// and regions of any place and size that a texture has, and options of any bits.
#include <lvsm/passes_fused.hpp>
#include <lvsm/passes_mip.hpp>
#include <lvsm/passes_mixture.hpp>
#include <lvsm/passes_place.hpp>
#include <lvsm/passes_step.hpp>

#include "bytes.hpp"

namespace
{

using namespace lvsm;
using namespace lvsm::fuzz;

bool isInside(const Rectangle& r, const Rectangle& outer)
{
    return r.width >= 0 && r.height >= 0 && r.x >= outer.x && r.y >= outer.y &&
           r.x + r.width <= outer.x + outer.width && r.y + r.height <= outer.y + outer.height;
}

// As many groups as cover an extent, and not one more. side: of a group, in texels that are the spacing apart.
bool cover(int groups, int extent, int side, int spacing = 1)
{
    return groups % spacing == 0 && groups * side >= extent && (groups - spacing) * side < extent;
}

void blur(Bytes& bytes, const Rectangle& map, const Rectangle& region)
{
    const bool paired = bytes.between(0, 1) == 1;
    const int size = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    const auto width = bytes.number<float>();
    const int kind = bytes.between(0, 2);
    const BlurKernel kernel = kind == 0   ? binomialKernel(size, paired)
                              : kind == 1 ? gaussianKernel(size, width, paired)
                                          : boxKernel(width, paired);
    LVSM_CLAIM(kernel.size >= 1 && kernel.size <= kMaxFilterSize);
    LVSM_CLAIM(kernel.fetchCount >= 1 && kernel.fetchCount <= kMaxBlurFetches);
    float sum = 0;
    for (int i = 0; i < kernel.fetchCount; ++i)
        sum += kernel.taps[i][1];
    LVSM_CLAIM(sum > 0.999f && sum < 1.001f);

    const std::vector<float> splits = bytes.numbers<float>(kMaxStoredLayers + 1);
    const int layers = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    const FusedPasses passes = fusedPasses(kernel, splits.data(), layers, 0.0f, map, region, glm::vec4(1));
    const Rectangle& made = passes.store.region;
    LVSM_CLAIM(made.width * made.height == 0 || isInside(made, map));
    LVSM_CLAIM(passes.store.block.layerCount >= 0 && passes.store.block.layerCount <= kMaxStoredLayers);
    LVSM_CLAIM(cover(passes.store.groups.x, made.width, kFusedGroupWidth));
    LVSM_CLAIM(cover(passes.store.groups.y, made.height, kFusedGroupHeight));
    LVSM_CLAIM(passes.down.region.width * passes.down.region.height == 0 || isInside(passes.down.region, made));
    LVSM_CLAIM(cover(passes.down.groups.x, passes.down.region.width, kPassGroupSize));
}

void levels(Bytes& bytes, const Rectangle& map)
{
    const int count = levelCount(map);
    const Rectangle last = levelRectangle(map, count - 1);
    LVSM_CLAIM(count >= 1 && last.width == 1 && last.height == 1);
    const int level = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    if (level < 1)
        return;
    const Pass<MipBlock> pass = mipPass(map, level);
    LVSM_CLAIM(cover(pass.groups.x, pass.region.width, kPassGroupSize));
    LVSM_CLAIM(pass.region.width >= 1 && pass.region.height >= 1);
}

void mix(Bytes& bytes, const Rectangle& map, const Rectangle& region)
{
    const int width = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    const bool half = bytes.between(0, 1) == 1;
    const bool isDrawn = bytes.between(0, 1) == 1;
    const MixturePasses made =
        isDrawn ? mixtureDraws(width, half, map, region) : mixturePasses(width, half, map, region);
    LVSM_CLAIM(made.count >= 1 && made.count <= (isDrawn ? 2 * kMaxMixtureRounds : 3));
    LVSM_CLAIM(made.deviation >= 0.0f && made.deviation < 64.0f);
    for (int i = 0; i < made.count; ++i)
    {
        const Pass<MixingBlock>& pass = made.passes[i];
        LVSM_CLAIM(i + 1 == made.count || isInside(pass.region, made.between));
        LVSM_CLAIM(isDrawn || pass.block.steps[0] + pass.block.steps[1] <= kMaxMixtureHalo);
        LVSM_CLAIM(cover(pass.groups.x, pass.region.width, kPassGroupSize, pass.block.spacing));
        LVSM_CLAIM(cover(pass.groups.y, pass.region.height, kPassGroupSize, pass.block.spacing));
    }
}

void place(Bytes& bytes, const Rectangle& map)
{
    const int layers = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    const int most = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    OptimalOptions<float> optimal;
    optimal.minLength = bytes.number<float>();
    const PlacePass pass = optimalPass(layers, map, optimal);
    LVSM_CLAIM(pass.block.layerCount >= 1 && pass.block.layerCount <= kMaxStoredLayers);
    LVSM_CLAIM(pass.block.leastBins >= 1 && pass.block.leastBins * pass.block.layerCount <= kMaxOptimalBins);
    LVSM_CLAIM(cover(pass.groups.x, map.width, kPlaceGroupTexels));

    RelaxOptions<float> options;
    options.splitsPerIteration = bytes.between(0, 3);
    const PlaceStep step = placeStep(layers, most, map, bytes.raw<std::int32_t>(), options);
    LVSM_CLAIM(step.block.layerCount >= 1 && step.block.layerCount < 4 * step.stateWidth);
    LVSM_CLAIM(step.slices >= 1 && 2 * step.slices <= step.block.layerCount + 1);
    std::vector<float> state(static_cast<std::size_t>(8 * step.stateWidth));
    startPlaceState(layers, most, state.data());
    state.resize(state.size() / 2);
    LVSM_CLAIM(areSplits(state));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    // At half resolution a map lies at even texels.
    const Rectangle map{2 * bytes.between(0, 8192), 2 * bytes.between(0, 8192), bytes.between(1, 16384),
                        bytes.between(1, 16384)};
    const Rectangle region{bytes.between(0, 32768), bytes.between(0, 32768), bytes.between(0, 16384),
                           bytes.between(0, 16384)};
    blur(bytes, map, region);
    levels(bytes, map);
    mix(bytes, map, region);
    place(bytes, map);
    return 0;
}
