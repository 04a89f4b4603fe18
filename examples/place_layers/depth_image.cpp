#include "depth_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <set>
#include <sstream>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <lvsm/depth.hpp>
#include <stb_image.h>

namespace lvsm::place_layers
{
namespace
{

using support::Failure;
using support::Result;

constexpr int kMostPixels = 1 << 28;
constexpr std::size_t kMostBytes = 2147483647;

bool areTooMany(double width, double height)
{
    return width < 1 || height < 1 || width * height > kMostPixels;
}

Result<Image> readPng(std::istream& file, bool asLuminance)
{
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(std::min<std::size_t>(bytes.size(), kMostBytes));
    Image image;
    int channels = 0;
    image.hasEightBits = stbi_is_16_bit_from_memory(data, size) == 0;
    const std::unique_ptr<stbi_us, void (*)(void*)> texels(
        stbi_load_16_from_memory(data, size, &image.width, &image.height, &channels, asLuminance ? 1 : 0),
        stbi_image_free);
    if (!texels)
        return Failure{stbi_failure_reason() != nullptr ? stbi_failure_reason() : "its pixels are broken"};
    // stb does not miss what a PNG ends with.
    if (bytes.compare(1, 3, "PNG") == 0 && bytes.rfind("IEND\xAE\x42\x60\x82") == std::string::npos)
        return Failure{"the file is truncated"};
    const auto step = static_cast<std::size_t>(asLuminance ? 1 : channels);
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t i = 0; i < count; ++i)
        image.values.push_back(static_cast<float>(texels.get()[i * step]) / 65535.0f);
    return image;
}

// Z, as renderers name depth, in whatever layer; a grey image's only channel, or red.
std::string depthChannel(const Imf::ChannelList& channels)
{
    std::string found, name;
    int count = 0;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel, ++count)
    {
        name = channel.name();
        if (name == "Z" || (name.size() > 2 && name.compare(name.size() - 2, 2, ".Z") == 0))
            return name;
        if (name == "Y" || (name == "R" && found.empty()))
            found = name;
    }
    return count == 1 ? name : found;
}

Result<Image> readExr(const std::string& path)
{
    // OpenEXR throws what it has to say.
    try
    {
        Imf::InputFile file(path.c_str(), 1);
        const Imath::Box2i window = file.header().dataWindow();
        const double width = static_cast<double>(window.max.x) - window.min.x + 1;
        const double height = static_cast<double>(window.max.y) - window.min.y + 1;
        if (areTooMany(width, height))
            return Failure{"it has no pixels, or more than 2^28"};
        if (!file.isComplete())
            return Failure{"the file is truncated"};
        const std::string name = depthChannel(file.header().channels());
        const Imf::Channel* const channel = file.header().channels().findChannel(name);
        if (channel == nullptr || channel->xSampling != 1 || channel->ySampling != 1)
            return Failure{"it has no channel Z, Y or R at full resolution"};

        Image image{static_cast<int>(width), static_cast<int>(height), {}, false};
        image.values.resize(static_cast<std::size_t>(width * height));
        const std::size_t row = sizeof(float) * static_cast<std::size_t>(image.width);
        Imf::FrameBuffer buffer;
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, image.values.data(), window, sizeof(float), row));
        file.setFrameBuffer(buffer);
        file.readPixels(window.min.y, window.max.y);
        return image;
    }
    catch (const std::exception& error)
    {
        return Failure{error.what()};
    }
}

float floatOf(const unsigned char* bytes, bool isLittleEndian)
{
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i)
        bits |= static_cast<std::uint32_t>(bytes[i]) << (isLittleEndian ? 8 * i : 24 - 8 * i);
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// "Pf" or, of three colours, "PF"; width and height; a scale, negative where bytes begin with the least; the last row
// first.
Result<Image> readPfm(std::istream& file)
{
    std::string kind;
    double width = 0, height = 0, scale = 0;
    if (!(file >> kind >> width >> height >> scale) || scale == 0 || areTooMany(width, height))
        return Failure{"its header is no PFM header"};
    file.get(); // the one white space before the numbers
    Image image{static_cast<int>(width), static_cast<int>(height), {}, false};
    const std::size_t row = static_cast<std::size_t>(image.width);
    const std::size_t bytesOfPixel = kind == "PF" ? 12 : 4;
    const std::size_t size = row * static_cast<std::size_t>(image.height) * bytesOfPixel;
    // Asked before any memory is: a broken header can name any size.
    const std::streamoff begin = file.tellg();
    file.seekg(0, std::ios::end);
    if (static_cast<std::size_t>(file.tellg() - begin) < size)
        return Failure{"the file is truncated"};
    file.seekg(begin);
    std::vector<unsigned char> bytes(size);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
        return Failure{"the file is truncated"};
    for (int y = image.height - 1; y >= 0; --y)
    {
        const unsigned char* const begin = bytes.data() + static_cast<std::size_t>(y) * row * bytesOfPixel;
        for (std::size_t x = 0; x < row; ++x)
            image.values.push_back(floatOf(begin + x * bytesOfPixel, scale < 0));
    }
    return image;
}

float linearDepth(float value, const DepthMeaning& meaning)
{
    if (!meaning.nearDistance)
        return meaning.isReversed ? 1.0f - value : value;
    if (meaning.isReversed)
        return lvsm::linearDepthReversed(value, *meaning.nearDistance, *meaning.farDistance);
    if (meaning.isProjected)
        return lvsm::linearDepth(value, *meaning.nearDistance, *meaning.farDistance);
    return lvsm::linstep(value, *meaning.nearDistance, *meaning.farDistance);
}

} // namespace

Result<Image> readImage(const std::string& path, bool asLuminance)
{
    std::ifstream file(path, std::ios::binary);
    char magic[4] = {};
    file.read(magic, sizeof magic);
    if (!file)
        return Failure{"cannot read '" + path + "': it is not there, not readable, or empty"};
    file.seekg(0);
    const bool isPfm = magic[0] == 'P' && (magic[1] == 'f' || magic[1] == 'F');
    const bool isExr = std::memcmp(magic, "\x76\x2f\x31\x01", 4) == 0;
    Result<Image> image = isPfm ? readPfm(file) : isExr ? readExr(path) : readPng(file, asLuminance);
    if (!image)
        return Failure{"cannot read '" + path + "': " + image.error()};
    return image;
}

Result<Depths> linearDepths(Image image, const DepthMeaning& meaning)
{
    Depths depths;
    depths.image = std::move(image);
    const bool areDistances = meaning.nearDistance && !meaning.isProjected && !meaning.isReversed;
    const float lowest = areDistances ? *meaning.nearDistance : 0.0f;
    const float highest = areDistances ? *meaning.farDistance : 1.0f;
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (float& value : depths.image.values)
    {
        if (!std::isfinite(value))
        {
            value = std::numeric_limits<float>::quiet_NaN();
            ++depths.ignored;
            continue;
        }
        depths.beyond += value < lowest || value > highest ? 1 : 0;
        least = std::min(least, value);
        most = std::max(most, value);
        value = linearDepth(value, meaning);
        depths.least = std::min(depths.least, value);
        depths.most = std::max(depths.most, value);
    }
    std::ostringstream text;
    if (least > most)
        text << "no pixel is finite";
    else if (depths.beyond > 0 && !areDistances)
        text << depths.beyond << " pixels are outside [0,1], from " << least << " to " << most
             << (meaning.nearDistance ? ", and projected depths are not"
                                      : ": where they are distances, give --near and --far");
    else if (depths.least == depths.most)
        text << "every pixel has the depth " << depths.least << ", and there is nothing to place layers by";
    if (!text.str().empty())
        return Failure{text.str()};
    return depths;
}

std::size_t distinctDepths(const Image& depths, std::size_t limit)
{
    std::set<float> seen;
    for (const float depth : depths.values)
    {
        if (!std::isnan(depth) && seen.size() < limit)
            seen.insert(depth);
    }
    return seen.size();
}

} // namespace lvsm::place_layers
