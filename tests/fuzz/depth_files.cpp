// The image files that place_layers reads: whole ones with bytes changed and ends cut off, and any bytes at all. Either a
// reason comes back, or as many numbers as the image has pixels.
// Sources: examples/place_layers/depth_image.cpp
// Packages: OpenEXR stb
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "../../examples/place_layers/depth_image.hpp"
#include "bytes.hpp"

namespace
{

using namespace lvsm::fuzz;

// A file in memory, which has a name while it lives.
class MemoryFile
{
public:
    explicit MemoryFile(const std::string& content) : m_descriptor(memfd_create("lvsm", 0))
    {
        LVSM_CLAIM(write(m_descriptor, content.data(), content.size()) == static_cast<ssize_t>(content.size()));
    }
    ~MemoryFile() { close(m_descriptor); }
    MemoryFile(const MemoryFile&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

private:
    int m_descriptor;
};

std::string exr(Imf::Compression compression)
{
    const MemoryFile file("");
    {
        Imf::Header header(5, 3);
        header.compression() = compression;
        header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        const float depths[15] = {0.0f, 0.125f, 0.25f, 1.0f};
        Imf::OutputFile output(file.path().c_str(), header, 0);
        Imf::FrameBuffer buffer;
        buffer.insert("Z", Imf::Slice(Imf::FLOAT, const_cast<char*>(reinterpret_cast<const char*>(depths)),
                                      sizeof(float), 5 * sizeof(float)));
        output.setFrameBuffer(buffer);
        output.writePixels(3);
    }
    std::ifstream written(file.path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(written), {}};
}

// A PNG of 2 x 2 grey pixels of 16 bits, deflated as it is.
std::string png()
{
    const unsigned char bytes[] = {0x89, 'P', 'N', 'G', 13, 10,  26,  10,  0,   0,    0,   13,   'I', 'H',  'D',  'R',
                                   0,    0,   0,   2,   0,  0,   0,   2,   16,  0,    0,   0,    0,   0,    0,    0,
                                   0,    0,   0,   0,   21, 'I', 'D', 'A', 'T', 0x78, 1,   1,    10,  0,    0xf5, 0xff,
                                   0,    0,   0,   64,  0,  0,   128, 0,   255, 255,  0,   0,    0,   0,    0,    0,
                                   0,    0,   0,   0,   0,  0,   0,   'I', 'E', 'N',  'D', 0xae, 'B', 0x60, 0x82};
    return {reinterpret_cast<const char*>(bytes), sizeof bytes};
}

std::string whole(int kind)
{
    static const std::string files[] = {exr(Imf::NO_COMPRESSION),
                                        exr(Imf::ZIP_COMPRESSION),
                                        exr(Imf::PIZ_COMPRESSION),
                                        png(),
                                        "Pf\n3 2\n-1.0\n" + std::string(24, '\x3e'),
                                        "PF\n1 2\n1\n" + std::string(24, '\x3e'),
                                        ""};
    return files[kind];
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const int kind = bytes.between(0, 6);
    std::string content = whole(kind);
    const int changes = bytes.between(0, 12);
    for (int i = 0; i < changes && !content.empty(); ++i)
        content[bytes.raw<std::uint16_t>() % content.size()] = bytes.raw<char>();
    if (bytes.between(0, 3) == 0)
        content.resize(bytes.raw<std::uint16_t>() % (content.size() + 1));
    if (kind == 6)
        content.assign(reinterpret_cast<const char*>(data), size);

    const MemoryFile file(content);
    const auto image = lvsm::place_layers::readImage(file.path(), bytes.between(0, 1) == 1);
    if (!image)
    {
        LVSM_CLAIM(!image.error().empty());
        return 0;
    }
    LVSM_CLAIM(changes > 0 || kind == 6 || image->width == (kind < 3 ? 5 : kind == 3 ? 2 : kind == 4 ? 3 : 1));
    LVSM_CLAIM(image->width > 0 && image->height > 0);
    LVSM_CLAIM(image->values.size() ==
               static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height));
    return 0;
}
