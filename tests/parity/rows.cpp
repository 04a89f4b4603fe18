#include "run_row.hpp"

namespace parity
{

const std::vector<Row>& rows()
{
    static const std::vector<Row> all = {
#define FUNCTION(name, kind, arguments, domain, low, high) \
    {#name, #kind, #arguments, #domain, low, high, run_##name<double>, run_##name<float>, run_##name<Interval>},
#include "functions.def"
#undef FUNCTION
    };
    return all;
}

const Row* findRow(const std::string& function)
{
    for (const Row& row : rows())
    {
        if (row.function == function)
            return &row;
    }
    return nullptr;
}

} // namespace parity
