#include "shaders.hpp"

#include <stdexcept>

namespace lvsm::gallery
{
namespace
{

support::Shader compileFile(const std::string& path, support::ShaderStage stage, const std::string& preamble)
{
    support::ShaderOptions options;
    options.stage = stage;
    options.preamble = preamble;
    options.includeFolders = {LVSM_GALLERY_SHADERS, LVSM_GLSL};
    auto compiled = support::compileShaderFile(path, options);
    if (!compiled)
        throw std::runtime_error("a shader does not compile:\n" + compiled.error());
    return {std::move(*compiled)};
}

} // namespace

support::Shader compile(const std::string& file, support::ShaderStage stage, const std::string& preamble)
{
    return compileFile(std::string(LVSM_GALLERY_SHADERS) + "/" + file, stage, preamble);
}

support::Shader compilePass(const std::string& file, const std::string& preamble)
{
    return compileFile(std::string(LVSM_GLSL) + "/lvsm/passes/" + file, support::ShaderStage::Compute, preamble);
}

std::string define(const std::string& name, const std::string& value)
{
    return "#define " + name + " " + value + "\n";
}

std::vector<support::Binding> bindingsOf(const std::vector<vk::DescriptorType>& types)
{
    std::vector<support::Binding> bindings;
    for (const vk::DescriptorType type : types)
        bindings.push_back({static_cast<std::uint32_t>(bindings.size()), type});
    return bindings;
}

void runPass(const Kernel& kernel, const std::vector<support::Binding>& bindings, const GroupCount& groups)
{
    kernel.run(bindings, static_cast<std::uint32_t>(groups.x), static_cast<std::uint32_t>(groups.y),
               static_cast<std::uint32_t>(groups.z));
}

void runOver(const Kernel& kernel, const std::vector<support::Binding>& bindings, const support::Shape& size)
{
    runPass(kernel, bindings, {(size.width + 15) / 16, (size.height + 15) / 16, 1});
}

} // namespace lvsm::gallery
