#ifndef LVSM_TESTS_SUPPORT_SHADER_COMPILER_HPP
#define LVSM_TESTS_SUPPORT_SHADER_COMPILER_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "result.hpp"

namespace lvsm::support
{

enum class ShaderStage
{
    Vertex,
    Fragment,
    Compute
};
enum class ShaderLanguage
{
    Glsl,
    Hlsl
};

struct ShaderOptions
{
    ShaderStage stage = ShaderStage::Compute;
    ShaderLanguage language = ShaderLanguage::Glsl;
    std::string entryPoint = "main";
    /// Lines put before the text (in GLSL after `#version`), such as "#define CALL f(x)\n".
    std::string preamble;
    /// Where `#include` looks, after the folder of the including file. Empty: `#include` is an error.
    std::vector<std::string> includeFolders;
    /// What errors call the text.
    std::string name = "shader";
};

/// Compiles GLSL or HLSL with glslang to SPIR-V for Vulkan 1.1; the error is the compiler's log.
Result<std::vector<std::uint32_t>> compileShader(const std::string& text, const ShaderOptions& options);

/// Compiles HLSL text with the command `dxc` to SPIR-V for Vulkan 1.1, warnings being errors. The command prints its own
/// log; the error names the text.
Result<std::vector<std::uint32_t>> compileWithDxc(const std::string& dxc, const std::string& text,
                                                  const ShaderOptions& options);

/// Compiles a file; its own folder comes first among the include folders.
Result<std::vector<std::uint32_t>> compileShaderFile(const std::string& path, ShaderOptions options);

} // namespace lvsm::support

#endif
