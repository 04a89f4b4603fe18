#include "shaders.hpp"

#include <stdexcept>

namespace lvsm::gallery
{
namespace
{

support::Shader orThrow(support::Result<std::vector<std::uint32_t>> compiled)
{
    if (!compiled)
        throw std::runtime_error("a shader does not compile:\n" + compiled.error());
    return {std::move(*compiled)};
}

support::ShaderOptions options(support::ShaderStage stage, const std::string& preamble)
{
    support::ShaderOptions result;
    result.stage = stage;
    result.preamble = preamble;
    result.includeFolders = {LVSM_GALLERY_SHADERS, LVSM_GLSL};
    return result;
}

} // namespace

support::Shader compile(const std::string& file, support::ShaderStage stage, const std::string& preamble)
{
    return orThrow(
        support::compileShaderFile(std::string(LVSM_GALLERY_SHADERS) + "/" + file, options(stage, preamble)));
}

support::Shader compileText(const std::string& text, support::ShaderStage stage, const std::string& preamble)
{
    return orThrow(support::compileShader(text, options(stage, preamble)));
}

std::vector<support::Binding> bindingsOf(const std::vector<vk::DescriptorType>& types)
{
    std::vector<support::Binding> bindings;
    for (const vk::DescriptorType type : types)
        bindings.push_back({static_cast<std::uint32_t>(bindings.size()), type});
    return bindings;
}

void runOver(const Kernel& kernel, const std::vector<support::Binding>& bindings, const support::Shape& size,
             int layers)
{
    const auto groups = [](int texels)
    {
        return static_cast<std::uint32_t>((texels + 15) / 16);
    };
    kernel.run(bindings, groups(size.width), groups(size.height), static_cast<std::uint32_t>(layers));
}

} // namespace lvsm::gallery
