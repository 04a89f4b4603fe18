#include "page_text.hpp"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace lvsm::gallery
{

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        switch (c)
        {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

std::string fixed(double value, int decimals)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string percent(double share)
{
    return fixed(100.0 * share, 2);
}

std::string cssColour(glm::vec3 colour)
{
    char text[32];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(colour.r * 255.0f + 0.5f),
                  static_cast<unsigned>(colour.g * 255.0f + 0.5f), static_cast<unsigned>(colour.b * 255.0f + 0.5f));
    return text;
}

std::string readText(const std::string& path)
{
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace lvsm::gallery
