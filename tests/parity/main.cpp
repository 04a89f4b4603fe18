// lvsm_parity: runs the rows of functions.def in one language and compares them with the double-precision functions.
#include "judge.hpp"
#include "kernel.hpp"
#include "wgpu.hpp"

#include <shader_compiler.hpp>
#include <vulkan_device.hpp>
#include <whole_file.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace
{

using namespace parity;
using lvsm::support::VulkanDevice;

constexpr int kSkipped = 77;

// The one-file versions run at another size of the arrays, so that no function counts on the default one.
const std::string kOtherMaxLayers = "#define LVSM_MAX_LAYERS 12\n";

struct Options
{
    std::string function;
    std::string language;
    std::string glslFolder;
    std::string hlslFolder;
    std::string singleFolder;
    std::string dxc;
    std::string wgsl;
    std::string report;
    std::vector<std::string> devices = {"llvmpipe", "SwiftShader"};
};

// One way from a row to SPIR-V.
struct Shader
{
    std::string compiler;
    std::string source;
    std::vector<std::uint32_t> spirv;
};

// Where a row has run, and what came of it.
struct Run
{
    std::string compiler;
    std::string source;
    std::string device;
    std::vector<Verdict> verdicts;
};

std::string readFile(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

[[noreturn]] void fail(const std::string& message)
{
    std::fprintf(stderr, "lvsm_parity: %s\n", message.c_str());
    std::exit(1);
}

Shader compile(const Row& row, const Options& options, const std::string& compiler, bool single)
{
    const bool glsl = options.language == "glsl";
    lvsm::support::ShaderOptions shaderOptions;
    shaderOptions.language = glsl ? lvsm::support::ShaderLanguage::Glsl : lvsm::support::ShaderLanguage::Hlsl;
    shaderOptions.name = row.function;
    if (!single)
        shaderOptions.includeFolders = {glsl ? options.glslFolder : options.hlslFolder};
    const std::string extension = glsl ? "glsl" : "hlsli";
    const std::string library = single ? kOtherMaxLayers + readFile(options.singleFolder + "/lvsm_all." + extension)
                                       : "#include \"lvsm/lvsm." + extension + "\"\n";
    const std::string text = glsl ? glslKernel(row, library) : hlslKernel(row, library);
    const auto spirv = compiler == "dxc" ? lvsm::support::compileWithDxc(options.dxc, text, shaderOptions)
                                         : lvsm::support::compileShader(text, shaderOptions);
    if (!spirv)
        fail(compiler + " on " + row.function + ":\n" + spirv.error());
    return {compiler, single ? "single" : "include", *spirv};
}

std::vector<Shader> compileAll(const Row& row, const Options& options)
{
    std::vector<Shader> shaders;
    for (const bool single : {false, true})
    {
        shaders.push_back(compile(row, options, "glslang", single));
        if (options.language == "hlsl" && !options.dxc.empty())
            shaders.push_back(compile(row, options, "dxc", single));
    }
    return shaders;
}

std::vector<float> runOnHost(const Row& row, const Judge& judge)
{
    std::vector<float> results;
    for (const Words& input : judge.inputs())
    {
        const Result<float> result = row.inFloat(input);
        results.insert(results.end(), result.begin(), result.begin() + componentCount(row.kind));
    }
    return results;
}

std::vector<float> runOnDevice(VulkanDevice& device, const Row& row, const Judge& judge, const Shader& shader)
{
    const std::size_t numbers = judge.inputs().size() * static_cast<std::size_t>(componentCount(row.kind));
    const std::vector<Words>& inputs = judge.inputs();
    lvsm::support::ComputeJob job;
    job.spirv = &shader.spirv;
    job.input = inputs.data();
    job.inputBytes = inputs.size() * sizeof(Words);
    job.outputBytes = numbers * sizeof(float);
    job.groupCount = static_cast<std::uint32_t>(inputs.size() / kGroupSize);
    const auto bytes = device.run(job);
    if (!bytes)
        fail(device.name().device + ": " + bytes.error());
    std::vector<float> results(numbers);
    std::memcpy(results.data(), bytes->data(), bytes->size());
    return results;
}

// False where a verdict fails. Prints the worst input either way.
bool print(const Row& row, const Judge& judge, const Run& run)
{
    bool passed = true;
    for (const Verdict& verdict : run.verdicts)
    {
        std::printf("%s %-8s %-7s %-7s %-11s %-18s %zu inputs: ", verdict.passed() ? "ok  " : "FAIL",
                    row.function.c_str(), run.compiler.c_str(), run.source.c_str(), run.device.c_str(),
                    verdict.domain.c_str(), verdict.inputs);
        if (verdict.domain != "hostile")
            std::printf("worst error %.3g of %.3g allowed (median allowed %.3g, %.0f%% tight); ", verdict.worstError,
                        verdict.tolerance, verdict.medianTolerance, 100.0 * verdict.tightShare);
        std::printf("%zu not finite, %zu outside", verdict.nonFinite, verdict.outside);
        if (verdict.domain != "hostile" || !verdict.passed())
            std::printf("; expected %.9g, got %.9g for (%s)", verdict.expected, verdict.answered,
                        describeInput(judge.inputs()[verdict.worstInput]).c_str());
        std::printf("\n");
        passed = passed && verdict.passed();
    }
    return passed;
}

void writeReport(const Row& row, const std::vector<Run>& runs, const Options& options)
{
    nlohmann::json list = nlohmann::json::array();
    for (const Run& run : runs)
    {
        for (const Verdict& verdict : run.verdicts)
            list.push_back({{"function", row.function},
                            {"language", options.language},
                            {"compiler", run.compiler},
                            {"source", run.source},
                            {"device", run.device},
                            {"domain", verdict.domain},
                            {"inputs", verdict.inputs},
                            {"worst_error", verdict.worstError},
                            {"tolerance", verdict.tolerance},
                            {"median_tolerance", verdict.medianTolerance},
                            {"tight_share", verdict.tightShare},
                            {"non_finite", verdict.nonFinite},
                            {"outside", verdict.outside}});
    }
    if (const auto problem = lvsm::support::writeWholeFile(options.report, list.dump(1) + '\n'))
        fail(*problem);
}

// The verdicts of every device, compiler and source; empty where no device is there.
std::vector<Run> runShaders(const Row& row, const Judge& judge, const Options& options, bool& silent)
{
    std::vector<Run> runs;
    std::vector<Shader> shaders;
    for (const std::string& name : options.devices)
    {
        auto device = VulkanDevice::open({name, true});
        if (!device)
        {
            std::printf("skip %s: %s\n", name.c_str(), device.error().c_str());
            continue;
        }
        if (shaders.empty())
            shaders = compileAll(row, options);
        for (const Shader& shader : shaders)
            runs.push_back(
                {shader.compiler, shader.source, name, judge.judge(runOnDevice(*device, row, judge, shader))});
        silent = silent && device->validationMessages().empty();
    }
    return runs;
}

// WGSL's, whose arrays have the size that its user writes into the file.
std::vector<Run> runWgsl(const Row& row, const Judge& judge, const Options& options)
{
    const std::string maxLayers = "const LVSM_MAX_LAYERS: i32 = 8;";
    std::string library = readFile(options.singleFolder + "/lvsm_all.wgsl");
    const std::size_t at = library.find(maxLayers);
    if (at == std::string::npos)
        fail("lvsm_all.wgsl has no " + maxLayers);
    library.replace(at, maxLayers.size(), "const LVSM_MAX_LAYERS: i32 = 12;");
    const std::size_t numbers = judge.inputs().size() * static_cast<std::size_t>(componentCount(row.kind));
    const auto results = runWithWgpu(options.wgsl, wgslKernel(row, library), judge.inputs(), numbers, options.devices);
    if (!results)
        fail(row.function + ": " + results.error());
    std::vector<Run> runs;
    for (const auto& [device, numbersOfDevice] : *results)
        runs.push_back({"naga", "single", device, judge.judge(numbersOfDevice)});
    return runs;
}

void listRows()
{
    for (const Row& row : rows())
        std::printf("%s\n", row.function.c_str());
}

int runRow(const Row& row, const Options& options)
{
    // What an earlier run wrote says nothing about this one.
    if (!options.report.empty())
        std::filesystem::remove(options.report);
    const Judge judge(row, options.language == "wgsl" ? Order::Any : Order::AsWritten);
    if (judge.inputs().size() < 2 * static_cast<std::size_t>(kInputs))
        fail("row " + row.function + " names a domain that is not defined: " + row.domain);

    bool passed = true;
    std::vector<Run> runs;
    if (options.language == "cpp")
        runs.push_back({"c++", "include", "host", judge.judge(runOnHost(row, judge))});
    else if (options.language == "wgsl")
        runs = runWgsl(row, judge, options);
    else
        runs = runShaders(row, judge, options, passed);
    if (runs.empty())
        return kSkipped;
    if (!passed)
        std::printf("FAIL the validation layer had something to say\n");
    if (judge.undecided() > 0)
        std::printf("note %zu inputs with too many decisions to follow: only their range is checked\n",
                    judge.undecided());
    for (const Run& run : runs)
        passed = print(row, judge, run) && passed;
    if (judge.undecided() * 100 > judge.inputs().size())
    {
        std::printf("FAIL more than 1%% of the inputs are undecided\n");
        passed = false;
    }
    if (!options.report.empty())
        writeReport(row, runs, options);
    return passed ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app("Compares a function of the library in one language with its double-precision C++ version.");
    app.add_option("function", options.function, "a row of functions.def")->required();
    app.add_option("--language", options.language, "cpp, glsl, hlsl or wgsl")
        ->required()
        ->check(CLI::IsMember({"cpp", "glsl", "hlsl", "wgsl"}));
    app.add_option("--glsl", options.glslFolder, "folder that holds lvsm/lvsm.glsl");
    app.add_option("--hlsl", options.hlslFolder, "folder that holds lvsm/lvsm.hlsli");
    app.add_option("--single", options.singleFolder, "folder of the one-file lvsm_all.glsl, .hlsli and .wgsl");
    app.add_option("--dxc", options.dxc, "the DirectX Shader Compiler; without it HLSL is compiled by glslang alone");
    app.add_option("--wgsl", options.wgsl, "the command that runs WGSL, tests/support/wgsl");
    app.add_option("--report", options.report, "JSON file to write");
    app.add_option("--devices", options.devices, "parts of device names");
    app.add_flag_callback(
        "--list",
        []
        {
            listRows();
            throw CLI::Success();
        },
        "print the names of all rows");
    CLI11_PARSE(app, argc, argv);

    const Row* row = findRow(options.function);
    if (row == nullptr)
        fail("no row in functions.def is named " + options.function);
    try
    {
        return runRow(*row, options);
    }
    catch (const std::out_of_range&)
    {
        fail("row " + row->function + " reads beyond the " + std::to_string(kWords) + " words that an input has");
    }
}
