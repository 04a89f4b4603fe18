// What is done to the text of a shader so that the compiler's figures are those of what runs.
#ifndef LVSM_COST_SHADER_TEXT_HPP
#define LVSM_COST_SHADER_TEXT_HPP

#include <string>

namespace cost
{

// The text with its files in place of #include, each once. folder: holds what paths begin with.
std::string withIncludes(const std::string& text, const std::string& folder);

// The text with every loop asked to be unrolled: the compiler takes any other for eight turns.
std::string unrolled(const std::string& text);

// The text with members of a uniform block made constants. block: its name. constants: lines "#define member value".
std::string specialised(const std::string& text, const std::string& block, const std::string& constants);

// The text with one place changed, which has to be there.
std::string replaced(std::string text, const std::string& what, const std::string& by);

} // namespace cost

#endif
