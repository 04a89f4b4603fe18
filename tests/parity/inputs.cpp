#include "inputs.hpp"

#include "domains.hpp"

#include <cfloat>
#include <cmath>
#include <cstring>

namespace parity
{
namespace
{

std::uint32_t bitsOf(float value)
{
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

std::uint32_t encode(double value, Scale scale)
{
    if (scale == Scale::Integer)
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
    return bitsOf(static_cast<float>(value));
}

// A number in [0,1) that depends on two counters only.
double hashed(std::uint32_t index, std::uint32_t word)
{
    std::uint64_t x = (static_cast<std::uint64_t>(index) << 32 | word) + 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * std::ldexp(1.0, -53);
}

// Additive recurrence with the square root of a prime for each word: low discrepancy in every word and pair of words.
double lowDiscrepancy(int index, int word)
{
    static const int primes[kWords] = {2,  3,  5,  7,  11, 13, 17, 19, 23, 29, 31, 37,
                                       41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89};
    const double x = (index + 0.5) * std::sqrt(static_cast<double>(primes[word]));
    return x - std::floor(x);
}

double between(const Slot& slot, double u)
{
    if (slot.scale == Scale::Logarithmic)
        return slot.lo * std::pow(slot.hi / slot.lo, u);
    const double value = slot.lo + (slot.hi - slot.lo) * u;
    return slot.scale == Scale::Integer ? std::floor(value + 0.5) : value;
}

double edge(const Slot& slot, double u)
{
    return slot.edges[static_cast<std::size_t>(u * static_cast<double>(slot.edges.size()))];
}

// The combination of edges that index numbers.
double edgeOfCombination(const Domain& domain, int index, int word)
{
    std::size_t rest = static_cast<std::size_t>(index);
    for (int i = 0; i < word; ++i)
        rest /= domain.slots[static_cast<std::size_t>(i)].edges.size();
    const Slot& slot = domain.slots[static_cast<std::size_t>(word)];
    return slot.edges[rest % slot.edges.size()];
}

} // namespace

std::vector<Words> domainInputs(const std::string& name)
{
    const Domain* const found = findDomain(name);
    if (found == nullptr)
        return {};
    const Domain& domain = *found;
    const int used = static_cast<int>(domain.slots.size());
    double combinations = 1.0;
    for (const Slot& slot : domain.slots)
        combinations *= static_cast<double>(slot.edges.size());
    const bool all = combinations <= kInputs / 2;
    const int edgeInputs = all ? static_cast<int>(combinations) : kInputs / 4;

    std::vector<Words> inputs(kInputs, Words{});
    for (int i = 0; i < kInputs; ++i)
    {
        const std::uint32_t index = static_cast<std::uint32_t>(i);
        double values[kWords] = {};
        for (int word = 0; word < used; ++word)
        {
            const Slot& slot = domain.slots[static_cast<std::size_t>(word)];
            const double u = hashed(index, static_cast<std::uint32_t>(word));
            if (i < edgeInputs)
                values[word] = all ? edgeOfCombination(domain, i, word) : edge(slot, u);
            else if (u < 0.125)
                values[word] = edge(slot, 8.0 * u);
            else
                values[word] = between(slot, lowDiscrepancy(i, word));
        }
        if (domain.relate != nullptr)
            domain.relate(values);
        for (int word = 0; word < used; ++word)
            inputs[index][static_cast<std::size_t>(word)] =
                encode(values[word], domain.slots[static_cast<std::size_t>(word)].scale);
    }
    return inputs;
}

std::vector<Words> hostileInputs()
{
    const float extremes[] = {0.0f,     -0.0f, FLT_MAX, -FLT_MAX, FLT_MIN, -FLT_MIN, 1.0e-45f, -1.0e-45f,
                              1.0e-40f, 1.0f,  -1.0f,   0.5f,     1.0e19f, -1.0e19f, 2.0e38f,  1.0e-20f};
    std::vector<Words> inputs(kInputs);
    for (std::uint32_t i = 0; i < kInputs; ++i)
    {
        for (std::uint32_t word = 0; word < kWords; ++word)
        {
            std::uint32_t bits = static_cast<std::uint32_t>(hashed(i, 2 * word) * 4294967296.0);
            const bool finite = (bits & 0x7F800000u) != 0x7F800000u;
            const double pick = hashed(i, 2 * word + 1);
            if (pick < 0.25)
                bits = bitsOf(extremes[static_cast<int>(pick * 64.0)]);
            inputs[i][word] = pick < 0.25 || finite ? bits : bits & ~0x40000000u;
        }
    }
    return inputs;
}

} // namespace parity
