// What a fuzzer's bytes say: numbers of any size, counts in a range, images.
#ifndef LVSM_TESTS_FUZZ_BYTES_HPP
#define LVSM_TESTS_FUZZ_BYTES_HPP

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace lvsm::fuzz
{

class Bytes
{
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    // Past the end there are zeros.
    template <typename T>
    T raw()
    {
        T value{};
        const std::size_t count = sizeof value < size_ ? sizeof value : size_;
        std::memcpy(&value, data_, count);
        data_ += count;
        size_ -= count;
        return value;
    }

    int between(int low, int high)
    {
        return low + static_cast<int>(raw<std::uint16_t>() % static_cast<unsigned>(high - low + 1));
    }

    // A number in [0,1], in 255ths, mostly; else one of the size that the byte after it says, or any bits.
    template <typename T>
    T number()
    {
        const auto byte = raw<std::uint8_t>();
        if (byte < 192)
            return static_cast<T>(byte) / static_cast<T>(191);
        if (byte < 240)
            return std::ldexp(static_cast<T>(raw<std::int8_t>()), raw<std::int8_t>());
        return raw<T>();
    }

    template <typename T>
    std::vector<T> numbers(int count)
    {
        std::vector<T> values;
        for (int i = 0; i < count; ++i)
            values.push_back(number<T>());
        return values;
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

// Holds in every build, and stops the fuzzer at the input.
inline void claim(bool holds, const char* what)
{
    if (!holds)
    {
        std::fprintf(stderr, "does not hold: %s\n", what);
        std::abort();
    }
}

#define LVSM_CLAIM(condition) ::lvsm::fuzz::claim(condition, #condition)

// From 0 to 1 and not decreasing.
template <typename T>
bool areSplits(const std::vector<T>& splits)
{
    bool valid = splits.front() == T(0) && splits.back() == T(1);
    for (std::size_t i = 1; i < splits.size(); ++i)
        valid = valid && splits[i - 1] <= splits[i];
    return valid;
}

template <typename T>
bool areAlike(const std::vector<T>& a, const std::vector<T>& b)
{
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

} // namespace lvsm::fuzz

// What libFuzzer calls: the target for float or for double.
#define LVSM_FUZZ(target) \
    extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) \
    { \
        ::lvsm::fuzz::Bytes bytes(data, size); \
        if (bytes.between(0, 1) == 0) \
            target<float>(bytes); \
        else \
            target<double>(bytes); \
        return 0; \
    }

#endif
