// The checks of this folder. Each runs shaders of one form on a device and compares with the library's C++ functions.
#ifndef LVSM_SAMPLING_CHECKS_HPP
#define LVSM_SAMPLING_CHECKS_HPP

#include <gpu.hpp>

#include <string>

namespace sampling
{

using namespace lvsm::support;

// How a shader is written and compiled.
struct Form
{
    // combined or separate (GLSL), glslang or dxc (HLSL).
    std::string name;
    std::string glslFolder;
    std::string hlslFolder;
    std::string kernelFolder;
    std::string dxc;

    bool isHlsl() const { return name == "glslang" || name == "dxc"; }
};

// Compiles a file. macros: lines to put in front. Ends the program with the compiler's log where that fails.
Shader compile(const Form& form, const std::string& path, vk::ShaderStageFlagBits stage, const std::string& entryPoint,
               const std::string& macros);

// Random numbers in [0,1), the same everywhere.
class Random
{
public:
    float next();

private:
    std::uint32_t m_state = 1;
};

// Counts what differs, and prints the first of it.
class Comparison
{
public:
    explicit Comparison(std::string what) : m_what(std::move(what)) {}
    void expect(double answer, double expected, double tolerance, const std::string& where);
    // Prints the worst error; false where one was over its tolerance, or nothing was compared.
    bool passed() const;

private:
    std::string m_what;
    long m_count = 0;
    long m_failures = 0;
    double m_worst = 0.0;
};

bool checkWrappers(VulkanContext& context, const Form& form);
bool checkBorders(VulkanContext& context, const Form& form);
bool checkAtlas(VulkanContext& context, const Form& form);
bool checkCube(VulkanContext& context, const Form& form);
bool checkBlurredEsm(VulkanContext& context, const Form& form);
bool checkBlur(VulkanContext& context, const Form& form);
bool checkLitGround(VulkanContext& context, const Form& form);
bool checkStore(VulkanContext& context, const Form& form);
bool checkDepths(VulkanContext& context, const Form& form);
bool checkMixtures(VulkanContext& context, const Form& form);
bool checkMixtureWindows(VulkanContext& context, const Form& form);
bool checkMixtureWrappers(VulkanContext& context, const Form& form);
bool checkFused(VulkanContext& context, const Form& form);
bool checkStoreExamples(VulkanContext& context, const Form& form);
bool checkLevels(VulkanContext& context, const Form& form);
bool checkSteps(VulkanContext& context, const Form& form);
bool checkPlacing(VulkanContext& context, const Form& form);

} // namespace sampling

#endif
