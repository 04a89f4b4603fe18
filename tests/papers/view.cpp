#include <cmath>
#include <optional>

#include "filter.hpp"
#include "scenes.hpp"

namespace lvsm::papers
{
namespace
{

using quality::Light;
using quality::Surface;

constexpr float kSame = 0.01f; ///< how far off a receiver's depth the surface of the light's peel may lie

/// The point on a camera's ray that has a depth, by bisection: depth rises along it, and is clamped at its ends.
glm::dvec3 pointAt(const Light& camera, int x, int y, float depth)
{
    const Light::Ray ray = camera.ray(x + 0.5, y + 0.5);
    double near = 0.0, far = 100.0;
    for (int i = 0; i < 48; ++i)
    {
        const double middle = 0.5 * (near + far);
        (camera.depth(ray.origin + middle * ray.direction) < static_cast<double>(depth) ? near : far) = middle;
    }
    return ray.origin + near * ray.direction;
}

std::optional<Receiver> receiverAt(const quality::Peel& peel, const Light& light, glm::dvec3 point, int margin)
{
    const glm::dvec2 place = light.texel(point) - 0.5;
    const glm::ivec2 nearest(glm::floor(place + 0.5));
    const int last = peel.size() - 1 - margin;
    if (glm::any(glm::lessThan(nearest, glm::ivec2(margin))) || glm::any(glm::greaterThan(nearest, glm::ivec2(last))))
        return std::nullopt;
    const glm::vec2 offset(place - glm::dvec2(nearest));
    const auto depth = static_cast<float>(light.depth(point));
    const auto off = [&](const Surface& s)
    {
        return std::abs(s.depth + glm::dot(s.gradient, offset) - depth);
    };
    const Surface* best = nullptr;
    for (const Surface* s = peel.begin(nearest.x, nearest.y); s != peel.end(nearest.x, nearest.y); ++s)
    {
        if (best == nullptr || off(*s) < off(*best))
            best = s;
    }
    if (best == nullptr || off(*best) > kSame || !(best->facing > 0.0f))
        return std::nullopt;
    return Receiver{nearest.x, nearest.y, offset, *best, 0.0f, 0.0f};
}

bool isBehind(const Box& shield, const Light& light, glm::dvec3 point)
{
    constexpr double kGround = 1e-3;
    const glm::dvec2 place = light.texel(point);
    const glm::dvec3 along = light.ray(place.x, place.y).direction;
    const glm::dvec3 up = point + along * ((static_cast<double>(shield.low.y) - point.y) / along.y);
    return point.y < kGround && up.x > static_cast<double>(shield.low.x) && up.x < static_cast<double>(shield.high.x) &&
           up.z > static_cast<double>(shield.low.z) && up.z < static_cast<double>(shield.high.z);
}

View viewOf(const Setup& setup, const Light& light, const quality::Peel& peel, int pixels, int margin)
{
    const Light camera = Light::spot(setup.mesh, setup.camera.elevation, setup.camera.azimuth, pixels);
    const quality::Peel seen = depthPeel(setup.mesh, camera, pixels);
    const auto part = [&](float share)
    {
        return static_cast<int>(share * static_cast<float>(pixels));
    };
    const Crop& crop = setup.crop;
    View view{part(crop.right) - part(crop.left), part(crop.bottom) - part(crop.top), {}, {}, {}, {}};
    for (int row = part(crop.top); row < part(crop.bottom); ++row)
    {
        const int y = pixels - 1 - row;
        for (int x = part(crop.left); x < part(crop.right); ++x)
        {
            const Surface surface = seen.nearest(x, y);
            const bool nothing = surface.depth >= 1.0f;
            const glm::dvec3 point = pointAt(camera, x, y, surface.depth);
            const auto receiver = nothing ? std::nullopt : receiverAt(peel, light, point, margin);
            view.at.push_back(receiver ? static_cast<int>(view.receivers.size()) : -1);
            view.facing.push_back(nothing ? -1.0f : receiver ? receiver->surface.facing : 0.0f);
            if (!receiver)
                continue;
            view.receivers.push_back(*receiver);
            view.shielded.push_back(isBehind(setup.shield, light, point));
        }
    }
    return view;
}

} // namespace

Lit lit(const std::string& name, const Setup& setup, int mapSize, int filterWidth, int pixels)
{
    const Light light = lightOf(setup, mapSize);
    quality::Scene scene{name, depthPeel(setup.mesh, light, mapSize), true};
    View view = viewOf(setup, light, scene.peel, pixels, filterWidth / 2 + 5);
    judgeAll(scene, quality::binomialKernel(filterWidth), view.receivers);
    for (std::size_t i = 0; i < view.receivers.size(); ++i)
        view.shielded[i] = view.shielded[i] && view.receivers[i].visibility <= 1e-6f;
    return {std::move(scene), std::move(view), filterWidth};
}

Lit farther(const Lit& lit, float share)
{
    const auto move = [share](Surface& surface)
    {
        surface.depth = 1.0f - share + share * surface.depth;
        surface.gradient *= share;
    };
    const quality::Peel& peel = lit.scene.peel;
    std::vector<std::vector<Surface>> texels;
    for (int i = 0; i < peel.size() * peel.size(); ++i)
    {
        texels.emplace_back(peel.begin(i % peel.size(), i / peel.size()), peel.end(i % peel.size(), i / peel.size()));
        for (Surface& surface : texels.back())
            move(surface);
    }
    View view = lit.view;
    for (Receiver& receiver : view.receivers)
        move(receiver.surface);
    return {{lit.scene.name, quality::Peel(peel.size(), std::move(texels)), true}, std::move(view), lit.filterWidth};
}

} // namespace lvsm::papers
