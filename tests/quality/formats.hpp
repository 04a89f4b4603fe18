// The formats a shadow map is stored in: what a value becomes when it is written and read back.
#ifndef LVSM_TESTS_QUALITY_FORMATS_HPP
#define LVSM_TESTS_QUALITY_FORMATS_HPP

#include <lvsm/moments.hpp>

#include <glm/gtc/packing.hpp>

namespace lvsm::quality
{

enum class Format
{
    Unorm8,
    Unorm16,
    Fp16,
    Fp32
};

constexpr int bitsOf(Format format)
{
    return format == Format::Unorm8 ? 8 : format == Format::Fp32 ? 32 : 16;
}

constexpr const char* nameOf(Format format)
{
    constexpr const char* names[] = {"unorm8", "unorm16", "fp16", "fp32"};
    return names[static_cast<int>(format)];
}

/// Largest rounding error of a depth.
constexpr float depthErrorOf(Format format)
{
    constexpr float errors[] = {kDepthErrorUnorm8<float>, kDepthErrorUnorm16<float>, kDepthErrorFp16<float>,
                                kDepthErrorFp32<float>};
    return errors[static_cast<int>(format)];
}

inline float stored(float value, Format format)
{
    const auto unorm = [value](float steps)
    {
        return std::floor(detail::clamp(value, 0.0f, 1.0f) * steps + 0.5f) / steps;
    };
    switch (format)
    {
    case Format::Unorm8:
        return unorm(255.0f);
    case Format::Unorm16:
        return unorm(65535.0f);
    case Format::Fp16:
        return glm::unpackHalf1x16(glm::packHalf1x16(value));
    case Format::Fp32:
        break;
    }
    return value;
}

} // namespace lvsm::quality

#endif
