// Judges what a language answered: against the double-precision function, within what Vulkan allows it.
#ifndef LVSM_PARITY_JUDGE_HPP
#define LVSM_PARITY_JUDGE_HPP

#include "rows.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace parity
{

// What is allowed of one component of one result.
struct Allowed
{
    double expected;
    double lo;
    double hi;
};

// The worst result of a domain: the one furthest from the expected one, an unaccepted one before all others.
struct Verdict
{
    std::string domain;
    std::size_t inputs = 0;
    std::size_t nonFinite = 0;
    std::size_t outside = 0;
    double worstError = 0.0;
    double tolerance = 0.0;
    double medianTolerance = 0.0;
    double tightShare = 1.0; // of the results: those whose tolerance is under a thousandth of the result, or of 1
    std::size_t worstInput = 0;
    double expected = 0.0;
    double answered = 0.0;

    // Where few tolerances are tight, the row says too little to count.
    bool passed() const { return nonFinite == 0 && outside == 0 && tightShare >= 0.25; }
};

// One in so many inputs of a row: of its domain first, then of the hostile ones.
std::vector<Words> thinnedInputs(const Row& row, std::size_t every);

// The inputs of a row, from its domain and the hostile one, with what is allowed of each.
class Judge
{
public:
    // order: what the language and its compiler make of sums.
    Judge(const Row& row, Order order, std::size_t every = 1);

    const std::vector<Words>& inputs() const { return m_inputs; }

    // Inputs whose decisions are too many to follow; only the range of their results is checked.
    std::size_t undecided() const { return m_undecided; }

    // results: componentCount floats for each input. One verdict for the domain, one for the hostile inputs.
    std::vector<Verdict> judge(const std::vector<float>& results) const;

private:
    void allow(const Words& words);

    const Row& m_row;
    Order m_order;
    int m_components;
    std::vector<Words> m_inputs;    // those of the domain first
    std::vector<Allowed> m_allowed; // for each component of the domain's
    std::size_t m_undecided = 0;
};

// An input's words as numbers, to print.
std::string describeInput(const Words& words);

} // namespace parity

#endif
