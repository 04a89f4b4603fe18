// ESM figures 7, 8 and 9: how many depth tests a filtered map is worth, what it leaks, and what it does far away.
#include <algorithm>
#include <cmath>

#include <lvsm/esm.hpp>
#include <lvsm/pcf.hpp>

#include "esm_map.hpp"
#include "filter.hpp"
#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

constexpr float kThreshold = 0.02f;
constexpr int kSize = 512;
constexpr std::size_t kEvery = 11; ///< one receiver of so many is looked at

/// Depth of the receiver's own surface in the texel nearest to a place beside it.
float ownDepthAt(const quality::Peel& peel, const Receiver& r, glm::ivec2 texel)
{
    return ownDepth(peel, r.surface, r.x, r.y, glm::clamp(texel, 0, peel.size() - 1) - glm::ivec2(r.x, r.y));
}

/// A depth test of four texels, each with the receiver's own surface there.
float bilinearTest(const quality::Peel& peel, const Receiver& r, glm::vec2 place)
{
    const glm::ivec2 low(glm::floor(place));
    glm::vec4 lit;
    for (int i = 0; i < 4; ++i)
    {
        const glm::ivec2 texel = glm::clamp(low + glm::ivec2(i % 2, i / 2), 0, peel.size() - 1);
        lit[i] = depthTest(peel.nearest(texel.x, texel.y).depth, ownDepthAt(peel, r, texel), quality::kSameDepth);
    }
    return bilinearVisibility(lit, place - glm::vec2(low));
}

/// Places that share a window of weights evenly, across one axis, from its middle: the more, the finer.
std::vector<float> quantiles(const std::vector<double>& weights, int count)
{
    std::vector<float> places;
    double below = 0.0;
    std::size_t texel = 0;
    for (int i = 0; i < count; ++i)
    {
        const double wanted = (i + 0.5) / count;
        while (texel + 1 < weights.size() && below + weights[texel] < wanted)
            below += weights[texel++];
        const double at = static_cast<double>(texel) + (wanted - below) / weights[texel];
        places.push_back(static_cast<float>(at - 0.5 * static_cast<double>(weights.size())));
    }
    return places;
}

float tests(const quality::Peel& peel, const Receiver& r, const std::vector<float>& across,
            const std::vector<float>& down)
{
    float sum = 0.0f;
    for (const float y : down)
    {
        for (const float x : across)
            sum += bilinearTest(peel, r, placeOf(r) + glm::vec2(x, y));
    }
    return sum / static_cast<float>(across.size() * down.size());
}

std::vector<double> box(int width)
{
    return std::vector<double>(static_cast<std::size_t>(width), 1.0 / width);
}

std::vector<Receiver> some(const View& view)
{
    std::vector<Receiver> chosen;
    for (std::size_t i = 0; i < view.receivers.size(); i += kEvery)
    {
        const Receiver& r = view.receivers[i];
        const int margin = kSize / 16;
        if (std::min(r.x, r.y) > margin && std::max(r.x, r.y) < kSize - margin)
            chosen.push_back(r);
    }
    return chosen;
}

double rmse(const std::vector<float>& some, const std::vector<float>& truth)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < some.size(); ++i)
        sum += static_cast<double>((some[i] - truth[i]) * (some[i] - truth[i]));
    return std::sqrt(sum / static_cast<double>(some.size()));
}

/// What receivers get, and what they get half a texel on: the difference is what flickers when something moves.
struct Seen
{
    std::vector<float> here, beside;

    template <typename Judge>
    Seen(const std::vector<Receiver>& all, const Judge& judge)
    {
        for (Receiver r : all)
        {
            here.push_back(judge(r));
            r.offset.x += 0.5f;
            beside.push_back(judge(r));
        }
    }

    std::vector<float> change() const
    {
        std::vector<float> change;
        for (std::size_t i = 0; i < here.size(); ++i)
            change.push_back(beside[i] - here[i]);
        return change;
    }
};

/// Figure 7: the fewest depth tests, spread evenly over a window, that err as little as an ESM, and flicker as little.
void testsToMatch(Report& report, const std::string& name, const quality::Peel& peel, const std::vector<Receiver>& all,
                  const std::vector<double>& window, const Seen& esm)
{
    constexpr int kExact = 24;
    const auto testing = [&](int count)
    {
        const auto places = quantiles(window, count);
        return Seen(all, [&](const Receiver& r) { return tests(peel, r, places, places); });
    };
    const Seen truth = testing(kExact);
    const double error = rmse(esm.here, truth.here), flicker = rmse(esm.change(), truth.change());
    report.add("esm_figure7", name + "_rmse", error);
    report.add("esm_figure7", name + "_flicker", flicker);
    int asExact = 0, asCalm = 0;
    for (const int count : {10, 9, 8, 7, 6, 5, 4, 3, 2, 1})
    {
        const Seen pcf = testing(count);
        asExact = rmse(pcf.here, truth.here) <= error ? count * count : asExact;
        asCalm = rmse(pcf.change(), truth.change()) <= flicker ? count * count : asCalm;
    }
    report.add("esm_figure7", name + "_as_exact", asExact);
    report.add("esm_figure7", name + "_as_calm", asCalm);
}

void figure7(Report& report, const Lit& scene)
{
    constexpr int kFootprint = 6;
    const quality::Peel& peel = scene.scene.peel;
    const EsmMap plain(scene.scene, 1), blurred(scene.scene, 5);
    std::vector<Receiver> all;
    for (const Receiver& r : some(scene.view))
    {
        if (!violatesThreshold(blurred.occluder(r), r.depth(), EsmMap::kExponent, kThreshold))
            all.push_back(r);
    }
    const Mips mips(plain.terms());
    const float level = std::log2(static_cast<float>(kFootprint));
    testsToMatch(report, "trilinear", peel, all, box(kFootprint),
                 Seen(all, [&](const Receiver& r)
                      { return exponentialShadow(mips.sample(placeOf(r), level), r.depth(), EsmMap::kExponent); }));
    testsToMatch(report, "convolved", peel, all, quality::binomialKernel(5),
                 Seen(all, [&](const Receiver& r) { return blurred.visibility(r); }));
}

/// Figure 9: footprints of 32 x 3 texels. Pixels in full shadow that come out lit.
void figure9(Report& report, const Lit& scene)
{
    constexpr float kLong = 32.0f, kShort = 3.2f, kVisible = 0.1f;
    constexpr int kTaps = 10;
    const quality::Peel& peel = scene.scene.peel;
    const EsmMap plain(scene.scene, 1);
    const Mips mips(plain.terms());
    const auto judge = [](float occluder, const Receiver& r)
    {
        return exponentialShadow(occluder, r.depth(), EsmMap::kExponent);
    };
    double shadowed = 0.0, trilinear = 0.0, fallback = 0.0, anisotropic = 0.0;
    const auto across = quantiles(box(32), 32);
    for (const Receiver& r : some(scene.view))
    {
        if (tests(peel, r, across, {-1.0f, 0.0f, 1.0f}) > 0.0f)
            continue;
        const float occluder = mips.sample(placeOf(r), std::log2(kLong));
        float sum = 0.0f;
        for (const float x : quantiles(box(32), kTaps))
            sum += mips.sample(placeOf(r) + glm::vec2(x, 0.0f), std::log2(kShort));
        const bool fails = violatesThreshold(occluder, r.depth(), EsmMap::kExponent, kThreshold);
        ++shadowed;
        trilinear += judge(occluder, r) > kVisible ? 1.0 : 0.0;
        fallback += (fails ? plain.fallback(r) : judge(occluder, r)) > kVisible ? 1.0 : 0.0;
        anisotropic += judge(sum / kTaps, r) > kVisible ? 1.0 : 0.0;
    }
    report.add("esm_figure9", "trilinear", trilinear / shadowed);
    report.add("esm_figure9", "fallback", fallback / shadowed);
    report.add("esm_figure9", "anisotropic", anisotropic / shadowed);
}

/// Figures 1 and 8: the yard under 5 x 5, by ESM, CSM and VSM.
void figure8(Report& report)
{
    const Lit scene = lit("yard", yard(), kSize, 5, 400);
    Panels panels = panelsOf(scene.view, 3);
    int panel = 0;
    for (const auto& [name, technique] :
         {std::pair<std::string, quality::Technique>("esm", techniqueNamed("ESM r32f 80")),
          {"csm", quality::csm(16, 1.0f, true)},
          {"vsm", layered({})}})
    {
        const auto visibility = visibilities(scene, technique);
        const ViewErrors errors = errorsOf(scene.view, visibility);
        report.add("esm_figure8", name, errors.rmse);
        report.add("esm_figure8", name + "_bleed", errors.bleed);
        report.add("esm_figure8", name + "_contact", errors.contact);
        shade(panels, panel++, scene.view, visibility);
    }
    report.picture("esm-figure8", panels);

    // How much of the ESM's squared error is where the window holds a depth beyond the receiver.
    constexpr float kBeyond = 0.004f;
    const EsmMap map(scene.scene, 5);
    double beyond = 0.0, all = 0.0;
    for (const Receiver& r : scene.view.receivers)
    {
        const auto error = static_cast<double>(map.visibility(r) - r.visibility);
        all += error * error;
        beyond += map.greatest(r) > r.depth() + kBeyond ? error * error : 0.0;
    }
    report.add("esm_figure8", "beyond", beyond / all);
}

} // namespace

void esmFiltering(Report& report)
{
    const Lit scene = lit("yard", yard(), kSize, 5, 300);
    figure7(report, scene);
    figure8(report);
    figure9(report, scene);
}

} // namespace lvsm::papers
