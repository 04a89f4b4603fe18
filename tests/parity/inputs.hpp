// The inputs of a row: a named domain, and arbitrary finite bit patterns.
#ifndef LVSM_PARITY_INPUTS_HPP
#define LVSM_PARITY_INPUTS_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace parity
{

constexpr int kWords = 24;
constexpr int kInputs = 65536;

// One input as a shader reads it: floats and integers as their bits.
using Words = std::array<std::uint32_t, kWords>;

// The inputs of a named domain: combinations of edge values first, then a low-discrepancy fill that still holds edges.
// Empty where no domain has that name.
std::vector<Words> domainInputs(const std::string& name);

// Arbitrary finite bit patterns, with the extreme values among them.
std::vector<Words> hostileInputs();

} // namespace parity

#endif
