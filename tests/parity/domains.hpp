// The named domains of functions.def: what values each word of an input takes.
#ifndef LVSM_PARITY_DOMAINS_HPP
#define LVSM_PARITY_DOMAINS_HPP

#include <string>
#include <vector>

namespace parity
{

enum class Scale
{
    Linear,
    Logarithmic,
    Integer
};

// The values that one word of an input takes.
struct Slot
{
    std::vector<double> edges;
    double lo;
    double hi;
    Scale scale = Scale::Linear;
};

// relate gives the words values that depend on each other, such as the moments of a distribution.
struct Domain
{
    std::vector<Slot> slots;
    void (*relate)(double* words) = nullptr;
};

// Null where no domain has that name.
const Domain* findDomain(const std::string& name);

} // namespace parity

#endif
