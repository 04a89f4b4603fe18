#include "judge.hpp"

#include "kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <sstream>

namespace parity
{
namespace
{

constexpr int kOutcomeLimit = 512;

// A sum of four whose terms are quartered after it, which another order allows; config.glsl says so of LVSM_PRECISE.
bool mayOverflow(const Row& row, const Words& words)
{
    if (row.function != "neighbourhoodMoments")
        return false;
    float moments[8];
    std::memcpy(moments, words.data(), sizeof moments);
    return std::any_of(std::begin(moments), std::end(moments), [](float m) { return std::abs(m) > 0x1p126f; });
}

// Results under the smallest normal number may be flushed, wherever they come from.
bool isWithin(double answer, const Allowed& allowed, double slack)
{
    const double more = lvsm::kTiny<double> + slack * std::max(1.0, std::abs(allowed.expected));
    return answer >= allowed.lo - more && answer <= allowed.hi + more;
}

} // namespace

std::vector<Words> thinnedInputs(const Row& row, std::size_t every)
{
    std::vector<Words> thinned;
    for (const std::vector<Words>& all : {domainInputs(row.domain), hostileInputs()})
    {
        for (std::size_t i = 0; i < all.size(); i += every)
            thinned.push_back(all[i]);
    }
    return thinned;
}

Judge::Judge(const Row& row, Order order, std::size_t every)
    : m_row(row), m_order(order), m_components(componentCount(row.kind)), m_inputs(thinnedInputs(row, every))
{
    Interval::order = order;
    for (std::size_t i = 0; i < m_inputs.size() / 2; ++i)
        allow(m_inputs[i]);
    Interval::order = Order::AsWritten;
}

void Judge::allow(const Words& words)
{
    const Result<double> expected = m_row.inDouble(words);
    Result<double> lo = expected;
    Result<double> hi = expected;
    const bool followed = enumerateOutcomes(kOutcomeLimit,
                                            [&]
                                            {
                                                const Result<Interval> result = m_row.inInterval(words);
                                                for (std::size_t c = 0; c < static_cast<std::size_t>(m_components); ++c)
                                                {
                                                    lo[c] = std::min(lo[c], result[c].lo());
                                                    hi[c] = std::max(hi[c], result[c].hi());
                                                }
                                            });
    m_undecided += followed ? 0 : 1;
    for (std::size_t c = 0; c < static_cast<std::size_t>(m_components); ++c)
    {
        const double infinity = std::numeric_limits<double>::infinity();
        m_allowed.push_back(followed ? Allowed{expected[c], lo[c], hi[c]} : Allowed{expected[c], -infinity, infinity});
    }
}

std::vector<Verdict> Judge::judge(const std::vector<float>& results) const
{
    // Of 1 or of the result where that is larger: a sum's terms may be as large.
    const double slack = m_order == Order::Any ? kOtherOrder : 0.0;
    std::vector<Verdict> verdicts(2);
    verdicts[0].domain = m_row.domain;
    verdicts[1].domain = "hostile";
    std::vector<double> tolerances;
    double worst = -1.0;
    std::size_t tight = 0;
    const std::size_t components = static_cast<std::size_t>(m_components);
    for (std::size_t i = 0; i < m_inputs.size(); ++i)
    {
        const bool hostile = i * components >= m_allowed.size();
        if (m_order == Order::Any && mayOverflow(m_row, m_inputs[i]))
            continue;
        Verdict& verdict = verdicts[hostile ? 1 : 0];
        ++verdict.inputs;
        for (std::size_t c = 0; c < components; ++c)
        {
            const double answer = static_cast<double>(results[i * components + c]);
            const bool finite = std::isfinite(answer);
            bool accepted = finite && answer >= m_row.low && answer <= m_row.high;
            verdict.nonFinite += finite ? 0 : 1;
            if (hostile)
            {
                const double excess = std::max(m_row.low - answer, answer - m_row.high);
                if (!accepted && (excess > verdict.worstError || verdict.outside == 0))
                {
                    verdict.worstError = excess;
                    verdict.worstInput = i;
                    verdict.expected = answer < m_row.low ? m_row.low : m_row.high;
                    verdict.answered = answer;
                }
            }
            else
            {
                const Allowed& allowed = m_allowed[i * components + c];
                accepted = accepted && isWithin(answer, allowed, slack);
                const double error = std::abs(answer - allowed.expected);
                const double tolerance =
                    (answer < allowed.expected ? allowed.expected - allowed.lo : allowed.hi - allowed.expected) +
                    slack * std::max(1.0, std::abs(allowed.expected));
                tight += allowed.hi - allowed.lo <= 1.0e-3 * std::max(1.0, std::abs(allowed.expected)) ? 1 : 0;
                tolerances.push_back(std::min(tolerance, m_row.high - m_row.low));
                const double badness = accepted ? error : HUGE_VAL;
                if (badness > worst)
                {
                    worst = badness;
                    verdict.worstError = error;
                    verdict.tolerance = std::min(tolerance, m_row.high - m_row.low);
                    verdict.worstInput = i;
                    verdict.expected = allowed.expected;
                    verdict.answered = answer;
                }
            }
            verdict.outside += accepted ? 0 : 1;
        }
    }
    std::nth_element(tolerances.begin(), tolerances.begin() + static_cast<std::ptrdiff_t>(tolerances.size() / 2),
                     tolerances.end());
    verdicts[0].tightShare = static_cast<double>(tight) / static_cast<double>(tolerances.size());
    verdicts[0].medianTolerance = tolerances[tolerances.size() / 2];
    return verdicts;
}

std::string describeInput(const Words& words)
{
    std::size_t used = words.size();
    while (used > 1 && words[used - 1] == 0)
        --used;
    std::ostringstream text;
    text.precision(9);
    for (std::size_t i = 0; i < used; ++i)
    {
        float value;
        std::memcpy(&value, &words[i], sizeof value);
        const std::int32_t integer = static_cast<std::int32_t>(words[i]);
        text << (i == 0 ? "" : " ");
        if (std::abs(integer) < 1000000 && integer != 0)
            text << integer << 'i';
        else
            text << value;
    }
    return text.str();
}

} // namespace parity
