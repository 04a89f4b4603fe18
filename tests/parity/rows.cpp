#include "rows.hpp"

#include <lvsm/lvsm.hpp>

#include <cfloat>
#include <cstring>

namespace parity
{
namespace
{

// What functions.def calls its arguments.
template <typename T>
class Arguments
{
public:
    explicit Arguments(const Words& words) : m_words(words)
    {
        for (int i = 0; i < kResults; ++i)
        {
            splits[i] = real(i);
            weights[i] = real(kResults + i);
        }
    }

    T real(int word) const
    {
        float value;
        std::memcpy(&value, &m_words[static_cast<std::size_t>(word)], sizeof value);
        if constexpr (std::is_same_v<T, Interval>)
            return Interval::argument(value);
        else
            return static_cast<T>(value);
    }

    int integer(int word) const { return static_cast<int>(m_words[static_cast<std::size_t>(word)]); }

    T splits[kResults];
    T weights[kResults];

private:
    const Words& m_words;
};

template <typename T>
void store(Result<T>& result, T value)
{
    result[0] = value;
}

template <typename T>
void store(Result<T>& result, int value)
{
    result[0] = static_cast<T>(value);
}

template <typename T, int N, typename U>
void store(Result<T>& result, const glm::vec<N, U>& value)
{
    for (int i = 0; i < N; ++i)
        result[static_cast<std::size_t>(i)] = static_cast<T>(value[i]);
}

template <typename T>
void storeSplits(Result<T>& result, const T* splits)
{
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = splits[i];
}

#define A(i) in.real(i)
#define I(i) in.integer(i)
#define N(i) std::min(in.integer(i), kMaxLayers)
#define V2(i) glm::vec<2, T>(A(i), A((i) + 1))
#define V3(i) glm::vec<3, T>(A(i), A((i) + 1), A((i) + 2))
#define V4(i) glm::vec<4, T>(A(i), A((i) + 1), A((i) + 2), A((i) + 3))
#define IV2(i) glm::vec<2, int>(I(i), I((i) + 1))

#define STORE_Float(name, arguments) store(result, static_cast<T>(lvsm::name<T> arguments))
#define STORE_Vec2(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Vec4(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Int(name, arguments) store(result, lvsm::name arguments)
#define STORE_IVec2(name, arguments) store(result, lvsm::name arguments)
#define STORE_Splits(name, arguments) \
    lvsm::name arguments; \
    storeSplits(result, in.splits)

#define FUNCTION(name, kind, arguments, domain, low, high) \
    template <typename T> \
    Result<T> run_##name(const Words& words) \
    { \
        [[maybe_unused]] Arguments<T> in(words); \
        [[maybe_unused]] T* const splits = in.splits; \
        [[maybe_unused]] T* const weights = in.weights; \
        Result<T> result{}; \
        STORE_##kind(name, arguments); \
        return result; \
    }
#include "functions.def"
#undef FUNCTION

} // namespace

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

int componentCount(const std::string& kind)
{
    if (kind == "Vec2" || kind == "IVec2")
        return 2;
    if (kind == "Vec4")
        return 4;
    return kind == "Splits" ? kResults : 1;
}

} // namespace parity
