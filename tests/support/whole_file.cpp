#include "whole_file.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace lvsm::support
{

std::optional<std::string> writeWholeFile(const std::string& path, const std::string& text)
{
    namespace fs = std::filesystem;
    const fs::path target(path);
    const fs::path partial(path + ".partial");
    std::error_code error;
    if (target.has_parent_path())
        fs::create_directories(target.parent_path(), error);
    std::ofstream file(partial, std::ios::binary);
    file << text;
    file.close();
    if (!file)
    {
        fs::remove(partial, error);
        return "cannot write '" + path + "'";
    }
    fs::rename(partial, target, error);
    if (!error)
        return std::nullopt;
    std::error_code ignored;
    fs::remove(partial, ignored);
    return "cannot write '" + path + "': " + error.message();
}

} // namespace lvsm::support
