#include "shader_compiler.hpp"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include <unistd.h>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace lvsm::support
{
namespace
{

namespace fs = std::filesystem;

std::optional<std::string> readFile(const fs::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return std::nullopt;
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

class FolderIncluder : public glslang::TShader::Includer
{
public:
    explicit FolderIncluder(const std::vector<std::string>& folders) : m_folders(folders) {}

    IncludeResult* includeLocal(const char* header, const char* includer, std::size_t) override
    {
        if (IncludeResult* found = open(fs::path(includer).parent_path() / header))
            return found;
        return includeSystem(header, includer, 0);
    }

    IncludeResult* includeSystem(const char* header, const char*, std::size_t) override
    {
        for (const std::string& folder : m_folders)
        {
            if (IncludeResult* found = open(fs::path(folder) / header))
                return found;
        }
        return nullptr;
    }

    void releaseInclude(IncludeResult* result) override
    {
        if (result == nullptr)
            return;
        delete static_cast<std::string*>(result->userData);
        delete result;
    }

private:
    static IncludeResult* open(const fs::path& path)
    {
        auto text = readFile(path);
        if (!text)
            return nullptr;
        auto owned = std::make_unique<std::string>(std::move(*text));
        const char* data = owned->data();
        const std::size_t size = owned->size();
        return new IncludeResult(path.string(), data, size, owned.release());
    }

    const std::vector<std::string>& m_folders;
};

struct GlslangProcess
{
    GlslangProcess() { glslang::InitializeProcess(); }
    ~GlslangProcess() { glslang::FinalizeProcess(); }
};

EShLanguage stageOf(ShaderStage stage)
{
    switch (stage)
    {
    case ShaderStage::Vertex:
        return EShLangVertex;
    case ShaderStage::Fragment:
        return EShLangFragment;
    case ShaderStage::Compute:
        break;
    }
    return EShLangCompute;
}

std::string dxcProfile(ShaderStage stage)
{
    switch (stage)
    {
    case ShaderStage::Vertex:
        return "vs_6_0";
    case ShaderStage::Fragment:
        return "ps_6_0";
    case ShaderStage::Compute:
        break;
    }
    return "cs_6_0";
}

std::string fullPreamble(const ShaderOptions& options)
{
    const bool needsExtension = options.language == ShaderLanguage::Glsl && !options.includeFolders.empty();
    return (needsExtension ? "#extension GL_GOOGLE_include_directive : require\n" : "") + options.preamble;
}

} // namespace

Result<std::vector<std::uint32_t>> compileShader(const std::string& text, const ShaderOptions& options)
{
    static const GlslangProcess process;
    const bool hlsl = options.language == ShaderLanguage::Hlsl;
    const EShLanguage stage = stageOf(options.stage);
    const std::string preamble = fullPreamble(options);
    const char* strings[] = {text.c_str()};
    const char* names[] = {options.name.c_str()};

    glslang::TShader shader(stage);
    shader.setStringsWithLengthsAndNames(strings, nullptr, names, 1);
    shader.setPreamble(preamble.c_str());
    shader.setEntryPoint(options.entryPoint.c_str());
    shader.setSourceEntryPoint(options.entryPoint.c_str());
    shader.setEnvInput(hlsl ? glslang::EShSourceHlsl : glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);

    auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    if (hlsl)
        messages = static_cast<EShMessages>(messages | EShMsgReadHlsl | EShMsgHlslOffsets);

    FolderIncluder folders(options.includeFolders);
    glslang::TShader::ForbidIncluder forbidden;
    const bool includes = !options.includeFolders.empty();
    glslang::TShader::Includer& includer = includes ? static_cast<glslang::TShader::Includer&>(folders) : forbidden;
    if (!shader.parse(GetDefaultResources(), 100, false, messages, includer))
        return Failure{shader.getInfoLog()};

    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages))
        return Failure{program.getInfoLog()};

    // HLSL needs the optimizer's legalization passes; GLSL is kept as written.
    glslang::SpvOptions spvOptions;
    spvOptions.disableOptimizer = !hlsl;
    std::vector<std::uint32_t> words;
    glslang::GlslangToSpv(*program.getIntermediate(stage), words, &spvOptions);
    return words;
}

Result<std::vector<std::uint32_t>> compileWithDxc(const std::string& dxc, const std::string& text,
                                                  const ShaderOptions& options)
{
    const fs::path folder = fs::temp_directory_path() / ("lvsm_dxc_" + std::to_string(getpid()));
    fs::create_directories(folder);
    const std::string input = (folder / "shader.hlsl").string();
    const std::string output = (folder / "shader.spv").string();
    std::ofstream(input) << options.preamble << text;
    std::string command = "'" + dxc + "' -T " + dxcProfile(options.stage) + " -E " + options.entryPoint +
                          " -spirv -WX -fspv-target-env=vulkan1.1";
    for (const std::string& include : options.includeFolders)
        command += " -I '" + include + "'";
    command += " -Fo '" + output + "' '" + input + "'";
    const int status = std::system(command.c_str());
    const auto bytes = status == 0 ? readFile(output) : std::nullopt;
    fs::remove_all(folder);
    if (!bytes || bytes->empty())
        return Failure{"dxc failed on " + options.name};
    std::vector<std::uint32_t> words(bytes->size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes->data(), bytes->size());
    return words;
}

Result<std::vector<std::uint32_t>> compileShaderFile(const std::string& path, ShaderOptions options)
{
    const auto text = readFile(path);
    if (!text)
        return Failure{"cannot read the shader " + path};
    options.name = path;
    options.includeFolders.insert(options.includeFolders.begin(), fs::path(path).parent_path().string());
    return compileShader(*text, options);
}

} // namespace lvsm::support
