// A row of functions.def as a function: run_NAME<T>(words) calls lvsm::NAME<T> with what the words hold.
#ifndef LVSM_PARITY_RUN_ROW_HPP
#define LVSM_PARITY_RUN_ROW_HPP

#include "rows.hpp"

#include <lvsm/lvsm.hpp>

#include <cfloat>
#include <cstring>

namespace parity
{

// What functions.def calls its arguments. Throws std::out_of_range where a row reads a word that an input does not have: a
// shader would read the next input's.
template <typename T>
class Arguments
{
public:
    explicit Arguments(const Words& words) : m_words(words)
    {
        for (int i = 0; i < kSplits; ++i)
        {
            splits[i] = real(i);
            weights[i] = real(kSplits + i);
        }
    }

    T real(int word) const
    {
        const std::uint32_t stored = bits(word);
        float value;
        std::memcpy(&value, &stored, sizeof value);
        if constexpr (std::is_same_v<T, Interval>)
            return Interval::argument(value);
        else
            return static_cast<T>(value);
    }

    int integer(int word) const { return static_cast<int>(bits(word)); }

    std::uint32_t bits(int word) const { return m_words.at(static_cast<std::size_t>(word)); }

    glm::vec<2, T> two(int word) const { return {real(word), real(word + 1)}; }

    glm::vec<3, T> three(int word) const { return {real(word), real(word + 1), real(word + 2)}; }

    lvsm::MixtureComponent<T> component(int word) const
    {
        return {real(word), two(word + 1), real(word + 3), three(word + 4), two(word + 7), real(word + 9)};
    }

    lvsm::MixtureComponent<T> tap(int word) const
    {
        lvsm::MixtureComponent<T> tap = noComponent();
        tap.weight = real(word);
        tap.place = two(word + 1);
        tap.depth = real(word + 3);
        return tap;
    }

    lvsm::MixturePlane<T> plane(int word) const
    {
        return {real(word), two(word + 1), real(word + 3), two(word + 4), real(word + 6)};
    }

    lvsm::Mixture<T> twoComponents(int word) const
    {
        return {{component(word), component(word + 10), noComponent(), noComponent()}};
    }

    // Weight, place and depth of each, then the spread, tilt and variance of all.
    lvsm::Mixture<T> fourComponents(int word) const
    {
        lvsm::Mixture<T> mixture;
        for (int i = 0; i < lvsm::kMaxComponents; ++i)
        {
            const int own = word + 4 * i;
            mixture.components[i] = {real(own),        two(own + 1),   real(own + 3),
                                     three(word + 16), two(word + 19), real(word + 21)};
        }
        return mixture;
    }

    T splits[kSplits];
    T weights[kSplits];

private:
    static lvsm::MixtureComponent<T> noComponent()
    {
        const T zero = T(0);
        return {zero, {zero, zero}, zero, {zero, zero, zero}, {zero, zero}, zero};
    }

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

// Numbers of a result, one after another.
template <typename T>
class Writer
{
public:
    explicit Writer(Result<T>& result) : m_result(result) {}

    Writer& operator<<(T value)
    {
        m_result[m_next++] = value;
        return *this;
    }

    template <int N>
    Writer& operator<<(const glm::vec<N, T>& value)
    {
        for (int i = 0; i < N; ++i)
            *this << value[i];
        return *this;
    }

    Writer& operator<<(const lvsm::MixtureComponent<T>& c)
    {
        return *this << c.weight << c.place << c.depth << c.spread << c.tilt << c.variance;
    }

    Writer& operator<<(const lvsm::MixturePlane<T>& p)
    {
        return *this << p.weight << p.place << p.depth << p.slope << p.deviation;
    }

private:
    Result<T>& m_result;
    std::size_t m_next = 0;
};

template <typename T>
void store(Result<T>& result, const lvsm::MixtureComponent<T>& component)
{
    Writer<T>(result) << component;
}

template <typename T>
void store(Result<T>& result, const lvsm::MixturePlane<T>& plane)
{
    Writer<T>(result) << plane;
}

template <typename T>
void store(Result<T>& result, const lvsm::Mixture<T>& mixture)
{
    Writer<T> writer(result);
    for (const lvsm::MixtureComponent<T>& component : mixture.components)
        writer << component;
}

template <typename T>
void store(Result<T>& result, const lvsm::MixturePlanes<T>& m)
{
    Writer<T>(result) << m.planes[0] << m.planes[1] << m.planes[2] << m.planes[3];
}

// Halves of each word: a float holds 16 bits exactly.
template <typename T, int N>
void storeHalves(Result<T>& result, const glm::vec<N, std::uint32_t>& code)
{
    Writer<T> writer(result);
    for (int i = 0; i < N; ++i)
        writer << static_cast<T>(static_cast<int>(code[i] & 0xFFFFu))
               << static_cast<T>(static_cast<int>(code[i] >> 16));
}

template <typename T>
void storeSplits(Result<T>& result, const T* splits)
{
    for (std::size_t i = 0; i < kSplits; ++i)
        result[i] = splits[i];
}

#define A(i) in.real(i)
#define I(i) in.integer(i)
#define N(i) std::min(in.integer(i), kMaxLayers)
#define V2(i) glm::vec<2, T>(A(i), A((i) + 1))
#define V3(i) glm::vec<3, T>(A(i), A((i) + 1), A((i) + 2))
#define V4(i) glm::vec<4, T>(A(i), A((i) + 1), A((i) + 2), A((i) + 3))
#define IV2(i) glm::vec<2, int>(I(i), I((i) + 1))
#define UV2(i) glm::vec<2, std::uint32_t>(in.bits(i), in.bits((i) + 1))
#define UV4(i) glm::vec<4, std::uint32_t>(in.bits(i), in.bits((i) + 1), in.bits((i) + 2), in.bits((i) + 3))
#define TAP(i) in.tap(i)
#define COMPONENT(i) in.component(i)
#define PLANE(i) in.plane(i)
#define MIXTURE2(i) in.twoComponents(i)
#define MIXTURE4(i) in.fourComponents(i)

#define STORE_Float(name, arguments) store(result, static_cast<T>(lvsm::name<T> arguments))
#define STORE_Vec2(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Vec4(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Int(name, arguments) store(result, lvsm::name arguments)
#define STORE_IVec2(name, arguments) store(result, lvsm::name arguments)
#define STORE_UVec2(name, arguments) storeHalves(result, lvsm::name<T> arguments)
#define STORE_UVec4(name, arguments) storeHalves(result, lvsm::name<T> arguments)
#define STORE_Component(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Plane(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Planes(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Mixture(name, arguments) store(result, lvsm::name<T> arguments)
#define STORE_Inserted(name, arguments) \
    lvsm::Mixture<T> mixture = MIXTURE2(0); \
    lvsm::name arguments; \
    store(result, mixture)
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

} // namespace parity

#endif
