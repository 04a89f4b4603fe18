// LVSM section 3.3: one sample whatever the number of layers, counted in the compiled wrapper.
#include <map>

#include "report.hpp"
#include "shader_compiler.hpp"

namespace lvsm::papers
{
namespace
{

std::string callOf(int layers)
{
    const std::string n = std::to_string(layers);
    return "#version 450\n#define LVSM_MAX_LAYERS " + n +
           "\n#include \"lvsm/sampling/combined.glsl\"\n"
           "layout(binding = 0) uniform sampler2DArray map;\n"
           "layout(binding = 1) buffer Values { float splits[" +
           n +
           " + 1]; float depth; float width; float result; };\n"
           "void main()\n{\n"
           "    result = lvsm_sampleLayers(map, lvsm_mapPoint(vec2(0.5), vec2(0.0), vec2(0.0), 0), depth, splits, " +
           n + ", width, width, 1e-5);\n}\n";
}

/// Samples in a function's text, with those of the functions that it calls, call by call.
class SampleCount
{
public:
    explicit SampleCount(const std::vector<std::uint32_t>& spirv)
    {
        constexpr std::uint32_t kHeader = 5, kFunction = 54, kCall = 57, kFirstSample = 87, kLastSample = 97;
        std::uint32_t function = 0;
        for (std::size_t i = kHeader; i < spirv.size(); i += spirv[i] >> 16)
        {
            const std::uint32_t operation = spirv[i] & 0xffffu;
            if (operation == kFunction)
                function = spirv[i + 2];
            if (m_first == 0)
                m_first = function;
            if (operation == kCall)
                m_calls[function].push_back(spirv[i + 3]);
            if (operation >= kFirstSample && operation <= kLastSample)
                ++m_samples[function];
        }
    }

    /// Of main, which glslang puts first.
    int ofMain() const { return of(m_first); }

private:
    int of(std::uint32_t function) const
    {
        const auto own = m_samples.find(function);
        int count = own == m_samples.end() ? 0 : own->second;
        const auto calls = m_calls.find(function);
        for (const std::uint32_t called : calls == m_calls.end() ? std::vector<std::uint32_t>() : calls->second)
            count += of(called);
        return count;
    }

    std::uint32_t m_first = 0;
    std::map<std::uint32_t, int> m_samples;
    std::map<std::uint32_t, std::vector<std::uint32_t>> m_calls;
};

} // namespace

void lvsmSamples(Report& report)
{
    for (const int layers : {2, 4, 8, 14})
    {
        support::ShaderOptions options;
        options.includeFolders = {LVSM_GLSL};
        const auto spirv = support::compileShader(callOf(layers), options);
        if (!spirv)
            return report.fail(spirv.error());
        report.add("samples", "lvsm" + std::to_string(layers), SampleCount(*spirv).ofMain());
    }
}

} // namespace lvsm::papers
