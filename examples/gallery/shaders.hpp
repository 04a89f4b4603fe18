#ifndef LVSM_GALLERY_SHADERS_HPP
#define LVSM_GALLERY_SHADERS_HPP

#include <string>
#include <vector>

#include <lvsm/passes.hpp>

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
/// Compiles a compute shader of the library's folder passes; throws with the compiler's log.
support::Shader compilePass(const std::string& file, const std::string& preamble);

/// A line that defines a macro.
std::string define(const std::string& name, const std::string& value = "");

/// What the bindings of a layout need to be known by: the types at 0, 1, 2, ...
std::vector<support::Binding> bindingsOf(const std::vector<vk::DescriptorType>& types);

/// Runs one of the library's passes.
void runPass(const Kernel& kernel, const std::vector<support::Binding>& bindings, const GroupCount& groups);

/// One invocation for each pixel, in groups of 16 x 16.
void runOver(const Kernel& kernel, const std::vector<support::Binding>& bindings, const support::Shape& size);

} // namespace lvsm::gallery

#endif
