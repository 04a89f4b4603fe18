#ifndef LVSM_GALLERY_SHADERS_HPP
#define LVSM_GALLERY_SHADERS_HPP

#include <string>
#include <vector>

#include "gpu.hpp"
#include "shader_compiler.hpp"

namespace lvsm::gallery
{

using support::Buffer;
using support::Kernel;
using support::Texture;
using support::VulkanContext;

/// Compiles a file of the gallery's shader folder; throws with the compiler's log.
support::Shader compile(const std::string& file, support::ShaderStage stage, const std::string& preamble = "");
/// Compiles text that includes the gallery's files; throws with the compiler's log.
support::Shader compileText(const std::string& text, support::ShaderStage stage, const std::string& preamble);

/// Bindings 0, 1, 2, ... of a layout.
std::vector<support::Binding> bindingsOf(const std::vector<vk::DescriptorType>& types);

/// One invocation for each texel of a kernel's groups of 16 x 16, in each of `layers`.
void runOver(const Kernel& kernel, const std::vector<support::Binding>& bindings, const support::Shape& size,
             int layers = 1);

} // namespace lvsm::gallery

#endif
