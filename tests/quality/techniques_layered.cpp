#include <algorithm>

#include <lvsm/plane.hpp>

#include "layer_splits.hpp"
#include "techniques.hpp"

namespace lvsm::quality
{
namespace
{

/// Of depths that are counted from the far end.
glm::vec2 mirrored(const glm::vec2& moments)
{
    return {1.0f - moments.x, 1.0f - 2.0f * moments.x + moments.y};
}

glm::vec2 mirroredInterval(const glm::vec2& interval)
{
    return {1.0f - interval.y, 1.0f - interval.x};
}

/// Two moments a layer, in the basis for few bits where the format is unorm8.
class Layers : public Estimator
{
public:
    Layers(Splits splits, Format format) : m_splits(std::move(splits)), m_compact(format == Format::Unorm8) {}

    void store(const Surface& nearest, float* texel) const override
    {
        for (int i = 0; i < m_splits.count(); ++i)
        {
            const glm::vec2 slope = ownSlope(nearest) / m_splits.length(i);
            const float warped = layerWarp(nearest.depth, m_splits.interval(i));
            const bool inside = warped > 0.0f && warped < 1.0f;
            const glm::vec2 moments = inside ? depthMomentsSloped(warped, slope.x, slope.y) : depthMoments(warped);
            const glm::vec2 kept = m_compact ? compactMoments(moments) : moments;
            texel[2 * i] = kept.x;
            texel[2 * i + 1] = kept.y;
        }
    }

protected:
    /// Of a layer, or of all in front of the first, or of all behind the last.
    glm::vec2 moments(const Query& q, int layer) const
    {
        if (layer < 0)
            return glm::vec2(1.0f);
        if (layer >= m_splits.count())
            return glm::vec2(0.0f);
        const glm::vec2 kept(q.texel[2 * layer], q.texel[2 * layer + 1]);
        return m_compact ? expandMoments(kept) : kept;
    }

    float minVariance(const Query& q, float length) const
    {
        return std::max(q.slopeVariance, q.storedVariance * length * length);
    }

    Splits m_splits;

private:
    bool m_compact;
};

class PaperLayers : public Layers
{
public:
    using Layers::Layers;
    float visibility(const Query& q) const override
    {
        const int layer = m_splits.layerOf(q.depth);
        return layeredVisibility(moments(q, layer), q.depth, m_splits.interval(layer),
                                 minVariance(q, m_splits.length(layer)));
    }
};

class BracketedLayers : public Layers
{
public:
    using Layers::Layers;
    float visibility(const Query& q) const override
    {
        const int layer = m_splits.layerOf(q.depth);
        return bracketedVisibility(moments(q, layer - 1), moments(q, layer), moments(q, layer + 1), q.depth,
                                   m_splits.interval(layer), minVariance(q, m_splits.length(layer)));
    }
};

class BoundedLayers : public Layers
{
public:
    BoundedLayers(Splits splits, Format format, BoundedForm form = &bracketedBoundedVisibility)
        : Layers(std::move(splits), format), m_form(form)
    {
    }

    float visibility(const Query& q) const override
    {
        const int layer = m_splits.layerOf(q.depth);
        return m_form(moments(q, layer - 1), moments(q, layer), moments(q, layer + 1), q.depth,
                      m_splits.interval(layer), minVariance(q, m_splits.length(layer)));
    }
    float least(const Query& q) const override
    {
        const int layer = m_splits.layerOf(q.depth);
        return 1.0f - m_form(mirrored(moments(q, layer + 1)), mirrored(moments(q, layer)),
                             mirrored(moments(q, layer - 1)), 1.0f - q.depth,
                             mirroredInterval(m_splits.interval(layer)), minVariance(q, m_splits.length(layer)));
    }

private:
    BoundedForm m_form;
};

/// The union of the layers that the receiver's plane reaches, judged relative to it; reads the four neighbours too.
class PlaneLayers : public Layers
{
public:
    PlaneLayers(Splits splits, Format format, PlaneForm form = &planeBracketedVisibility)
        : Layers(std::move(splits), format), m_form(form)
    {
    }

    float visibility(const Query& q) const override { return bound(q, false); }
    float least(const Query& q) const override { return 1.0f - bound(q, true); }

private:
    /// What is lit at most, or in the mirror.
    float bound(const Query& q, bool isMirrored) const
    {
        const float variance = planeVariance(q.gradient, q.deviation);
        const float reach = std::sqrt(variance);
        const int first = m_splits.layerOf(q.depth - reach);
        const int last = m_splits.layerOf(q.depth + reach);
        const float begin = m_splits.interval(first).x;
        const float length = m_splits.interval(last).y - begin;

        glm::vec2 own = moments(q, first);
        float merged = m_splits.length(first);
        float ownCovariance = covariance(q, first) * merged / length;
        for (int i = first + 1; i <= last; ++i)
        {
            own = mergeLayers(own, moments(q, i), merged, m_splits.length(i));
            merged += m_splits.length(i);
            ownCovariance += covariance(q, i) * m_splits.length(i) / length;
        }
        const glm::vec3 covariances(covariance(q, first - 1), ownCovariance, covariance(q, last + 1));
        const glm::vec2 interval(begin, begin + length);
        if (isMirrored)
        {
            return m_form(mirrored(moments(q, last + 1)), mirrored(own), mirrored(moments(q, first - 1)),
                          glm::vec3(covariances.z, covariances.y, covariances.x), 1.0f - q.depth,
                          mirroredInterval(interval), variance, minVariance(q, length), q.contact);
        }
        return m_form(moments(q, first - 1), own, moments(q, last + 1), covariances, q.depth, interval, variance,
                      minVariance(q, length), q.contact);
    }

    PlaneForm m_form;

    float covariance(const Query& q, int layer) const
    {
        if (layer < 0 || layer >= m_splits.count())
            return 0.0f;
        const auto mean = [&](int dx, int dy)
        {
            return q.sample(dx, dy, 2 * layer);
        };
        return planeCovariance(glm::vec4(mean(1, 0), mean(-1, 0), mean(0, 1), mean(0, -1)), q.gradient, q.deviation);
    }
};

template <typename E>
Technique layered(const std::string& estimate, int count, Format format, Placement placement, const std::string& cost)
{
    const std::string name =
        "LVSM-" + std::to_string(count) + " " + nameOf(format) + " " + estimate + ", " + nameOf(placement);
    const std::string of = cost.empty() ? cost : "LVSM-" + (count == 2 ? std::string("2") : "N") + " " + cost;
    return {name,
            false,
            2 * count * bitsOf(format),
            2 * count,
            format,
            true,
            [=](const Map& map) { return std::make_unique<E>(Splits(map, count, placement), format); },
            of};
}

Technique plane(int count, Placement placement)
{
    Technique technique = layered<PlaneLayers>("plane", count, Format::Unorm8, placement, "plane 8-bit");
    technique.contact = true;
    technique.variants = placement == Placement::Optimal;
    return technique;
}

} // namespace

Technique planeForm(const std::string& name, PlaneForm form)
{
    Technique technique = plane(8, Placement::Optimal);
    technique.name = name;
    technique.variants = false;
    technique.prepare = [form](const Map& map)
    {
        return std::make_unique<PlaneLayers>(Splits(map, 8, Placement::Optimal), Format::Unorm8, form);
    };
    return technique;
}

Technique boundedForm(const std::string& name, BoundedForm form)
{
    Technique technique = layered<BoundedLayers>("", 8, Format::Unorm8, Placement::Uniform, "bounded 8-bit");
    technique.name = name;
    technique.prepare = [form](const Map& map)
    {
        return std::make_unique<BoundedLayers>(Splits(map, 8, Placement::Uniform), Format::Unorm8, form);
    };
    return technique;
}

std::vector<Technique> layeredTechniques()
{
    std::vector<Technique> all;
    for (const int count : {2, 4, 8})
    {
        all.push_back(layered<PaperLayers>("paper", count, Format::Unorm16, Placement::Uniform, ""));
        all.back().estimate = "LVSM one placed layer";
        for (const Placement placement : {Placement::Uniform, Placement::Optimal})
        {
            const bool fixedSplit = count == 2 && placement == Placement::Uniform;
            all.push_back(layered<BracketedLayers>("bracketed", count, Format::Unorm16, placement,
                                                   fixedSplit ? "bracketed" : "bracketed and placed"));
        }
        all.push_back(layered<BoundedLayers>("bounded", count, Format::Unorm16, Placement::Uniform, "bounded"));
    }
    for (const int count : {2, 4, 8, 16})
    {
        all.push_back(
            layered<BracketedLayers>("bracketed", count, Format::Unorm8, Placement::Uniform, "bracketed 8-bit"));
        all.push_back(layered<BoundedLayers>("bounded", count, Format::Unorm8, Placement::Uniform, "bounded 8-bit"));
        all.push_back(plane(count, Placement::Uniform));
        all.push_back(plane(count, Placement::Optimal));
    }
    return all;
}

} // namespace lvsm::quality
