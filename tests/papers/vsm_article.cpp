// The article on VSM: its floors and light bleeding reductions for three lights, on the projected depth that it stores.
#include <algorithm>
#include <functional>

#include <lvsm/moments.hpp>

#include "report.hpp"
#include "techniques_of_papers.hpp"

namespace lvsm::papers
{
namespace
{

/// What gl_FragCoord.z is of a linear depth in [0,1], and how fast it changes.
struct Projection
{
    float first, length;       ///< distance of depth 0 from the light, and from there to depth 1
    float nearPlane, farPlane; ///< 0: parallel, over all of farPlane

    float operator()(float depth) const
    {
        const float distance = first + length * depth;
        if (nearPlane == 0.0f)
            return distance / farPlane;
        return farPlane * (distance - nearPlane) / (distance * (farPlane - nearPlane));
    }

    float slope(float depth) const
    {
        const float distance = first + length * depth;
        if (nearPlane == 0.0f)
            return length / farPlane;
        return length * farPlane * nearPlane / (distance * distance * (farPlane - nearPlane));
    }
};

struct ArticleLight
{
    const char* name;
    bool spot;
    Projection projection;
    float minVariance;
    float reduction;
};

// The article names neither planes nor distances: near and far are those that tutorials take, the room three units away.
constexpr ArticleLight kLights[] = {{"directional", false, {8.0f, 6.0f, 0.0f, 25.0f}, 0.000002f, 0.6f},
                                    {"spot", true, {2.0f, 6.0f, 0.1f, 50.0f}, 0.0000004f, 0.9997f},
                                    {"point", true, {2.0f, 6.0f, 0.1f, 25.0f}, 0.000009f, 0.997f}};

/// As the article has it: moments of projected depth with their slope, its floor and its reduction.
class Article : public quality::Estimator
{
public:
    explicit Article(const ArticleLight& light) : m_light(light) {}

    void store(const quality::Surface& nearest, float* texel) const override
    {
        const glm::vec2 slope = nearest.gradient * m_light.projection.slope(nearest.depth);
        const float z = nearest.depth < 1.0f ? m_light.projection(nearest.depth) : 1.0f;
        const glm::vec2 moments = depthMomentsSloped(z, slope.x, slope.y);
        texel[0] = moments.x;
        texel[1] = moments.y;
    }

    float visibility(const quality::Query& q) const override
    {
        const float bound =
            chebyshevUpperBound(glm::vec2(q.texel[0], q.texel[1]), m_light.projection(q.depth), m_light.minVariance);
        return reduceLightBleeding(bound, m_light.reduction);
    }

private:
    ArticleLight m_light;
};

void add(Report& report, const std::string& name, const ViewErrors& errors)
{
    report.add("article", name, errors.rmse);
    report.add("article", name + "_bleed", errors.bleed);
    report.add("article", name + "_dark", errors.dark);
    report.add("article", name + "_penumbra", errors.penumbra);
}

} // namespace

void vsmArticle(Report& report)
{
    constexpr float kReduction = 0.1f;
    for (const ArticleLight& light : kLights)
    {
        const Lit scene = lit("room", room(light.spot), 512, 7, 400);
        const quality::Technique theirs{
            light.name, true, 64, 2, quality::Format::Fp32, true, quality::fixed<Article>(light)};
        const auto visibility = visibilities(scene, theirs);
        ArticleLight less = light;
        less.reduction = kReduction;
        quality::Technique unreduced = theirs;
        unreduced.prepare = quality::fixed<Article>(less);
        add(report, light.name + std::string("_less"), errorsOf(scene.view, visibilities(scene, unreduced)));
        auto ours = visibilities(scene, techniqueNamed("VSM rg32f"));
        for (float& value : ours)
            value = reduceLightBleeding(value, kReduction);
        add(report, light.name, errorsOf(scene.view, visibility));
        add(report, std::string(light.name) + "_ours", errorsOf(scene.view, ours));
        Panels panels = panelsOf(scene.view, 3);
        shade(panels, 0, scene.view, truths(scene.view));
        shade(panels, 1, scene.view, visibility);
        shade(panels, 2, scene.view, ours);
        report.picture(std::string("article-") + light.name, panels);
    }
}

} // namespace lvsm::papers
