// lvsm_sampling: runs the sampling wrappers, or the ready passes, in one form on every device.
#include "checks.hpp"

#include <shader_compiler.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <map>

namespace sampling
{
namespace
{

[[noreturn]] void fail(const std::string& message)
{
    std::fprintf(stderr, "lvsm_sampling: %s\n", message.c_str());
    std::exit(1);
}

lvsm::support::ShaderOptions optionsOf(const Form& form, vk::ShaderStageFlagBits stage, const std::string& entryPoint,
                                       const std::string& macros)
{
    using lvsm::support::ShaderStage;
    lvsm::support::ShaderOptions options;
    options.stage = stage == vk::ShaderStageFlagBits::eVertex     ? ShaderStage::Vertex
                    : stage == vk::ShaderStageFlagBits::eFragment ? ShaderStage::Fragment
                                                                  : ShaderStage::Compute;
    options.language = form.isHlsl() ? lvsm::support::ShaderLanguage::Hlsl : lvsm::support::ShaderLanguage::Glsl;
    options.entryPoint = entryPoint;
    options.preamble = macros;
    options.includeFolders = {form.isHlsl() ? form.hlslFolder : form.glslFolder};
    return options;
}

} // namespace

Shader compile(const Form& form, const std::string& path, vk::ShaderStageFlagBits stage, const std::string& entryPoint,
               const std::string& macros)
{
    // Every device runs the same.
    static std::map<std::string, Shader> compiled;
    const std::string key = form.name + path + entryPoint + macros;
    if (const auto found = compiled.find(key); found != compiled.end())
        return found->second;
    lvsm::support::ShaderOptions options = optionsOf(form, stage, entryPoint, macros);
    options.name = path;
    const auto spirv = form.name == "dxc"
                           ? lvsm::support::compileWithDxc(form.dxc, "#include \"" + path + "\"\n", options)
                           : lvsm::support::compileShaderFile(path, options);
    if (!spirv)
        fail(spirv.error());
    return compiled[key] = {*spirv, entryPoint};
}

} // namespace sampling

namespace
{

constexpr int kSkipped = 77;

using Check = bool (*)(sampling::VulkanContext&, const sampling::Form&);

const std::map<std::string, Check> kChecks = {{"wrappers", sampling::checkWrappers},
                                              {"borders", sampling::checkBorders},
                                              {"atlas", sampling::checkAtlas},
                                              {"cube", sampling::checkCube},
                                              {"esm_of_blurred_map", sampling::checkBlurredEsm},
                                              {"blur", sampling::checkBlur},
                                              {"lit_ground_at_edge", sampling::checkLitGround},
                                              {"store_examples_in_their_format", sampling::checkStoreExamples},
                                              {"store", sampling::checkStore},
                                              {"place", sampling::checkPlacing},
                                              {"levels", sampling::checkLevels},
                                              {"steps", sampling::checkSteps},
                                              {"depths", sampling::checkDepths},
                                              {"mixtures", sampling::checkMixtures},
                                              {"mixture_windows", sampling::checkMixtureWindows},
                                              {"mixture_wrappers", sampling::checkMixtureWrappers},
                                              {"fused", sampling::checkFused}};

int runOnDevices(Check check, const sampling::Form& form, const std::vector<std::string>& devices)
{
    int ran = 0;
    bool passed = true;
    for (const std::string& name : devices)
    {
        auto device = lvsm::support::VulkanDevice::open({name, true});
        if (!device)
        {
            std::printf("skip %s: %s\n", name.c_str(), device.error().c_str());
            continue;
        }
        std::printf("%s\n", device->name().device.c_str());
        ++ran;
        passed = check(device->context(), form) && passed;
        if (!device->validationMessages().empty())
        {
            std::printf("FAIL the validation layer had something to say\n");
            passed = false;
        }
    }
    return ran == 0 ? kSkipped : passed ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    sampling::Form form;
    std::string what;
    std::vector<std::string> devices = {"llvmpipe", "SwiftShader"};
    CLI::App app("Runs what reads and writes textures, and compares with the library's C++ functions.");
    app.add_option("what", what, "what to check")->required()->check(CLI::IsMember(kChecks));
    app.add_option("form", form.name, "combined or separate (GLSL), glslang or dxc (HLSL)")
        ->required()
        ->check(CLI::IsMember({"combined", "separate", "glslang", "dxc"}));
    app.add_option("--glsl", form.glslFolder, "folder that holds lvsm/lvsm.glsl")->required();
    app.add_option("--hlsl", form.hlslFolder, "folder that holds lvsm/lvsm.hlsli")->required();
    app.add_option("--kernels", form.kernelFolder, "folder of the shaders that call the wrappers")->required();
    app.add_option("--dxc", form.dxc, "the DirectX Shader Compiler");
    app.add_option("--devices", devices, "parts of device names");
    CLI11_PARSE(app, argc, argv);

    if (form.name == "dxc" && form.dxc.empty())
    {
        std::printf("skip: no dxc\n");
        return kSkipped;
    }
    try
    {
        return runOnDevices(kChecks.at(what), form, devices);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "lvsm_sampling: %s\n", error.what());
        return 1;
    }
}
