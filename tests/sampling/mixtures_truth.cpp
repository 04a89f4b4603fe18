#include "mixtures_truth.hpp"

#include <algorithm>
#include <cmath>

namespace sampling
{

using Component = lvsm::MixtureComponent<double>;

// As glsl/lvsm/passes/mixture.glsl describes it.
const std::array<PackedField, 10> kPackedFields = {{{"depth", 0, 0, 20},
                                                    {"weight", 0, 20, 12},
                                                    {"place x", 1, 0, 12},
                                                    {"place y", 1, 12, 12},
                                                    {"correlation", 1, 24, 8},
                                                    {"slope x", 2, 0, 16},
                                                    {"slope y", 2, 16, 16},
                                                    {"extent x", 3, 0, 10},
                                                    {"extent y", 3, 10, 10},
                                                    {"deviation", 3, 20, 12}}};

std::uint32_t fieldOf(const Packed& packed, const PackedField& field)
{
    return packed[static_cast<std::size_t>(field.word)] >> field.begin & ((1u << field.bits) - 1u);
}

namespace
{

constexpr double kReach = 32;

// Largest value of a field, and of signed ones the level of 0.
constexpr double kLevels[10] = {1048575, 3072, 2047, 2047, 124, 32767, 32767, 1023, 1023, 4095};

bool isSigned(int field)
{
    return field >= 2 && field <= 6;
}

Packed packedOf(const std::array<double, 10>& values)
{
    Packed packed{};
    for (int i = 0; i < 10; ++i)
    {
        const PackedField& field = kPackedFields[static_cast<std::size_t>(i)];
        const double middle = isSigned(i) ? kLevels[i] : 0;
        const double level =
            std::floor(std::clamp(values[static_cast<std::size_t>(i)], -1.0, 1.0) * kLevels[i] + middle + 0.5);
        packed[static_cast<std::size_t>(field.word)] |= static_cast<std::uint32_t>(level) << field.begin;
    }
    return packed;
}

double valueOf(const Packed& packed, int field)
{
    const double middle = isSigned(field) ? kLevels[field] : 0;
    return (static_cast<double>(fieldOf(packed, kPackedFields[static_cast<std::size_t>(field)])) - middle) /
           kLevels[field];
}

double signedRoot(double x)
{
    return x < 0 ? -std::sqrt(-x) : std::sqrt(x);
}

Packed pack(const Component& c)
{
    const glm::dvec2 slope = lvsm::componentSlope(c);
    std::array<double, 10> values{};
    values[1] = std::sqrt(c.weight);
    values[2] = c.place.x / kReach;
    values[3] = c.place.y / kReach;
    values[4] = c.spread.y / std::sqrt(std::max(c.spread.x * c.spread.z, 1e-30));
    values[5] = signedRoot(slope.x);
    values[6] = signedRoot(slope.y);
    values[7] = std::sqrt(std::sqrt(c.spread.x) / kReach);
    values[8] = std::sqrt(std::sqrt(c.spread.z) / kReach);
    values[9] = std::sqrt(std::sqrt(lvsm::componentResidual(c, slope)));
    const Packed placed = packedOf(values);
    const glm::dvec2 place = kReach * glm::dvec2(valueOf(placed, 2), valueOf(placed, 3));
    values[0] = std::clamp(c.depth + slope.x * (place.x - c.place.x) + slope.y * (place.y - c.place.y), 0.0, 1.0);
    return packedOf(values);
}

// Pairs are told apart by their prices; how near the two least are to each other, against what rounding moves them by.
bool isTie(const lvsm::Mixture<double>& mixture, const Component& added, int count)
{
    std::vector<Component> all(mixture.components, mixture.components + count);
    all.push_back(added);
    for (const Component& c : all)
    {
        if (!(c.weight > 0))
            return false;
    }
    double least = 1e30, second = 1e30, scale = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        for (std::size_t j = i + 1; j < all.size(); ++j)
        {
            const double price = lvsm::mergePrice(all[i], all[j]);
            second = std::min(second, std::max(price, least));
            least = std::min(least, price);
        }
        // A residual comes from terms as large as the variance, each of a few roundings; a coded component may be a level
        // off, which is a thousandth of what it costs.
        const double residual = lvsm::componentResidual(all[i], lvsm::componentSlope(all[i]));
        const double deviation = std::sqrt(residual + 1e-8);
        scale += all[i].weight * (1e-3 * deviation + 16.0 / (1 << 24) * all[i].variance / deviation);
    }
    return second - least < scale;
}

} // namespace

Component unpacked(const Packed& packed)
{
    const double weight = valueOf(packed, 1);
    const glm::dvec2 root(valueOf(packed, 5), valueOf(packed, 6));
    const glm::dvec2 slope(root.x * std::abs(root.x), root.y * std::abs(root.y));
    const double x = kReach * valueOf(packed, 7) * valueOf(packed, 7);
    const double y = kReach * valueOf(packed, 8) * valueOf(packed, 8);
    const double deviation = valueOf(packed, 9) * valueOf(packed, 9);
    Component c{};
    c.weight = weight * weight;
    c.place = kReach * glm::dvec2(valueOf(packed, 2), valueOf(packed, 3));
    c.depth = valueOf(packed, 0);
    c.spread = {x * x, valueOf(packed, 4) * x * y, y * y};
    const double ridge = std::max(0.5 - 0.5 * c.weight, 1.0 / 4096);
    const glm::dvec2 across(c.spread.x * slope.x + c.spread.y * slope.y, c.spread.y * slope.x + c.spread.z * slope.y);
    c.tilt = across + ridge * slope;
    c.variance = deviation * deviation + slope.x * across.x + slope.y * across.y +
                 2 * ridge * (slope.x * slope.x + slope.y * slope.y);
    return c;
}

Shape MixtureCase::coded() const
{
    const int texels = half ? 2 : 1;
    return {(depths.width + texels - 1) / texels, (depths.height + texels - 1) / texels};
}

lvsm::MixtureWindow MixtureCase::window() const
{
    return deviation > 0 ? lvsm::gaussianMixtureWindow(deviation, half) : lvsm::mixtureWindow(width, half);
}

Mixtures::Mixtures(const lvsm::Rectangle& area_) : area(area_)
{
    texels.resize(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
}

TrueMixture& Mixtures::at(int x, int y)
{
    return texels[static_cast<std::size_t>(y - area.y) * static_cast<std::size_t>(area.width) +
                  static_cast<std::size_t>(x - area.x)];
}

namespace
{

TrueMixture packedMixture(const lvsm::Mixture<double>& mixture, bool isTied)
{
    TrueMixture made;
    for (std::size_t i = 0; i < 4; ++i)
        made.packed[i] = pack(mixture.components[i]);
    made.isTied = isTied;
    return made;
}

void insert(lvsm::Mixture<double>& mixture, const Component& component, int count, bool& isTied)
{
    isTied |= isTie(mixture, component, count);
    lvsm::insertComponent(mixture, component, count);
}

} // namespace

Mixtures mixed(const MixtureCase& test, Mixtures& from, int stepX, int stepY, double share)
{
    const lvsm::Rectangle& a = from.area;
    Mixtures made({a.x + stepX, a.y + stepY, a.width - 2 * stepX, a.height - 2 * stepY});
    const int texels = test.half ? 2 : 1;
    for (int y = made.area.y; y < made.area.y + made.area.height; ++y)
    {
        for (int x = made.area.x; x < made.area.x + made.area.width; ++x)
        {
            lvsm::Mixture<double> mixture{};
            bool isTied = false;
            for (const int side : {0, -1, 1})
            {
                const TrueMixture& other = from.at(x + side * stepX, y + side * stepY);
                isTied |= other.isTied;
                const glm::dvec2 offset(side * stepX * texels, side * stepY * texels);
                for (std::size_t i = 0; i < static_cast<std::size_t>(test.count); ++i)
                    insert(mixture,
                           lvsm::moveComponent(unpacked(other.packed[i]), offset, side == 0 ? 1 - 2 * share : share),
                           test.count, isTied);
            }
            made.at(x, y) = packedMixture(mixture, isTied);
        }
    }
    return made;
}

Mixtures depthMixtures(const MixtureCase& test, const lvsm::Rectangle& area, const DepthOf& depth)
{
    const lvsm::Rectangle& map = test.map;
    const auto depthAt = [&](int x, int y)
    {
        const bool inside = x >= map.x && y >= map.y && x < map.x + map.width && y < map.y + map.height;
        return inside ? static_cast<double>(depth(x, y)) : 1.0;
    };
    Mixtures made(area);
    for (int y = area.y; y < area.y + area.height; ++y)
    {
        for (int x = area.x; x < area.x + area.width; ++x)
        {
            lvsm::Mixture<double> mixture{};
            bool isTied = false;
            if (!test.half)
                mixture.components[0] = lvsm::tapComponent(depthAt(x, y));
            for (int i = 0; i < 4 && test.half; ++i)
            {
                const glm::dvec2 place(i % 2 - 0.5, i / 2 - 0.5);
                const auto tap = lvsm::tapComponent(depthAt(2 * x + i % 2, 2 * y + i / 2));
                insert(mixture, lvsm::moveComponent(tap, place, 0.25), test.count, isTied);
            }
            made.at(x, y) = packedMixture(mixture, isTied);
        }
    }
    return made;
}

Mixtures mixedTwice(const MixtureCase& test, const Mixtures& from, const lvsm::MixingBlock& block)
{
    Mixtures made = from;
    for (int i = 0; i < 2; ++i)
    {
        const int step = block.steps[i] * block.spacing;
        const auto share = static_cast<double>(block.shares[i]);
        Mixtures across = mixed(test, made, step, 0, share);
        made = step > 0 ? mixed(test, across, 0, step, share) : made;
    }
    return made;
}

glm::uvec4 trueCode(const MixtureCase& test, const TrueMixture& mixture)
{
    lvsm::Mixture<double> all{};
    for (int i = 0; i < test.count; ++i)
        all.components[i] = unpacked(mixture.packed[static_cast<std::size_t>(i)]);
    lvsm::simplifyMixture(all, test.count);
    const auto deviation = static_cast<double>(test.window().deviation);
    if (test.count == 4)
        return lvsm::encodeMixture4(all, deviation);
    return {lvsm::encodeMixture2(all, deviation), 0u, 0u};
}

std::vector<double> windowWeights(const lvsm::MixtureWindow& window)
{
    std::vector<double> weights = window.texels > 1 ? std::vector<double>{0.5, 0.5} : std::vector<double>{1.0};
    for (int i = 0; i < window.rounds; ++i)
    {
        const auto step = static_cast<std::size_t>(window.steps[i] * window.texels);
        const auto share = static_cast<double>(window.shares[i]);
        std::vector<double> wider(weights.size() + 2 * step);
        for (std::size_t at = 0; at < weights.size(); ++at)
        {
            wider[at] += share * weights[at];
            wider[at + step] += (1 - 2 * share) * weights[at];
            wider[at + 2 * step] += share * weights[at];
        }
        weights = wider;
    }
    return weights;
}

} // namespace sampling
