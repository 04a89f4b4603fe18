#include "shader_text.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace cost
{
namespace
{

using Path = std::filesystem::path;

// from: the folder of the file that the text is of.
std::string resolved(const std::string& text, const Path& folder, const Path& from, std::set<std::string>& seen)
{
    static const std::regex include("#include \"(.*)\"\\s*");
    std::istringstream lines(text);
    std::string whole;
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
    {
        if (!std::regex_match(line, match, include))
        {
            whole += line.rfind("#version", 0) == 0 && !seen.empty() ? "\n" : line + '\n';
            continue;
        }
        const Path path =
            std::filesystem::exists(from / match[1].str()) ? from / match[1].str() : folder / match[1].str();
        if (!seen.insert(path.lexically_normal().string()).second)
            continue;
        std::ifstream file(path);
        if (!file)
            throw std::runtime_error("cannot read " + path.string());
        whole += resolved({std::istreambuf_iterator<char>(file), {}}, folder, path.parent_path(), seen);
    }
    return whole;
}

} // namespace

std::string withIncludes(const std::string& text, const std::string& folder)
{
    std::set<std::string> seen;
    return resolved(text, folder, Path(folder) / "lvsm/passes", seen);
}

std::string unrolled(const std::string& text)
{
    return std::regex_replace(text, std::regex("\\n( *)for \\("), "\n$1[[unroll]] for (");
}

std::string specialised(const std::string& text, const std::string& block, const std::string& constants)
{
    const std::size_t begin = text.find("uniform " + block + '\n');
    const std::size_t end = begin == std::string::npos ? begin : text.find("};", begin);
    if (end == std::string::npos)
        throw std::runtime_error("there is no block " + block);
    return text.substr(0, end + 3) + constants + text.substr(end + 3);
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    if (at == std::string::npos)
        throw std::runtime_error("there is no " + what);
    return text.replace(at, what.size(), by);
}

} // namespace cost
