// The rows of functions.def, ready to run in C++ and to be written into a shader.
#ifndef LVSM_PARITY_ROWS_HPP
#define LVSM_PARITY_ROWS_HPP

#include "inputs.hpp"
#include "interval.hpp"

#include <array>
#include <string>
#include <vector>

namespace parity
{

constexpr int kMaxLayers = 8;
constexpr int kSplits = kMaxLayers + 1;
// Most numbers that a result has: those of four components.
constexpr int kResults = 40;

template <typename T>
using Result = std::array<T, kResults>;

struct Row
{
    std::string function;
    std::string kind;
    std::string arguments;
    std::string domain;
    double low;
    double high;
    Result<double> (*inDouble)(const Words&);
    Result<float> (*inFloat)(const Words&);
    Result<Interval> (*inInterval)(const Words&);
};

const std::vector<Row>& rows();

// Null where there is no such row.
const Row* findRow(const std::string& function);

} // namespace parity

#endif
