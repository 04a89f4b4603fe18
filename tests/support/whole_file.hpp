#ifndef LVSM_TESTS_SUPPORT_WHOLE_FILE_HPP
#define LVSM_TESTS_SUPPORT_WHOLE_FILE_HPP

#include <optional>
#include <string>

namespace lvsm::support
{

/// Writes a file all or nothing, and makes its folder; the reason if that fails, and then what was there stays.
std::optional<std::string> writeWholeFile(const std::string& path, const std::string& text);

} // namespace lvsm::support

#endif
