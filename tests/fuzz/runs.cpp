// The runs of an image that the host functions read: inside it, one after another, all of it where all is asked for.
#include <lvsm/runs.hpp>

#include "bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lvsm::fuzz;
    using lvsm::detail::kRun;
    Bytes bytes(data, size);
    const int width = bytes.between(1, 4000);
    const int height = bytes.between(1, 300);
    const int maxSamples = bytes.raw<std::int32_t>() >> bytes.between(0, 31);
    long place = -1, texels = 0;
    lvsm::detail::forEachRun(width, height, maxSamples,
                             [&](int x, int y, int count)
                             {
                                 LVSM_CLAIM(x >= 0 && y >= 0 && y < height && count >= 1 && count <= kRun);
                                 LVSM_CLAIM(x + count <= width);
                                 const long first = static_cast<long>(y) * width + x;
                                 LVSM_CLAIM(first > place || maxSamples > 0);
                                 place = first + count - 1;
                                 texels += count;
                             });
    const long all = static_cast<long>(width) * height;
    LVSM_CLAIM(texels >= 1 && texels <= all);
    LVSM_CLAIM(maxSamples > 0 || texels == all);
    return 0;
}
