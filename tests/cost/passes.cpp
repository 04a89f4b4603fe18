// The compute passes that make a map, each with its settings as constants.
#include "kernels.hpp"

#include "shader_text.hpp"

namespace cost
{
namespace
{

struct Format
{
    const char* name;
    double bytes;
};

constexpr Format kR32f{"r32f", 4.0};
constexpr Format kRg16{"rg16", 4.0};
constexpr Format kRg32f{"rg32f", 8.0};
constexpr Format kRgba8{"rgba8", 4.0};
constexpr Format kRgba16{"rgba16", 8.0};
constexpr Format kRgba32f{"rgba32f", 16.0};
constexpr Format kFormats[] = {kR32f, kRg16, kRg32f, kRgba8, kRgba16, kRgba32f};
constexpr double kDepthBytes = 4.0;
constexpr int kWidths[] = {3, 7, 15, 25};

// What a store pass holds for a depth.
struct Stored
{
    const char* name;
    Format format;
    const char* expression;
    const char* largest;
};

constexpr Stored kStored[] = {
    {"ESM", kR32f, "vec4(lvsm_occluderTerm(depth, 80.0))", "LVSM_LARGEST_FP32"},
    {"VSM", kRg16, "vec4(lvsm_depthMoments(depth), 0.0, 0.0)", "1.0"},
    {"two layers", kRgba16, "lvsm_storedLayers(depth, slice)", "1.0"},
    {"two layers 8-bit", kRgba8,
     "lvsm_packLayers(lvsm_compactMoments(lvsm_storedLayer(depth, 2 * slice)), "
     "lvsm_compactMoments(lvsm_storedLayer(depth, 2 * slice + 1)))",
     "1.0"},
    {"EVSM2", kRg32f, "vec4(lvsm_exponentialMoments(depth, vec2(42.0, 0.0)).xy, 0.0, 0.0)", "LVSM_LARGEST_FP32"},
    {"EVSM4", kRgba32f, "lvsm_exponentialMoments(depth, vec2(42.0, 10.0))", "LVSM_LARGEST_FP32"},
    {"MSM4", kRgba32f, "lvsm_depthMoments4(depth)", "1.0"},
    {"MSM4 16-bit", kRgba16, "lvsm_encodeMoments4(lvsm_depthMoments4(depth))", "1.0"},
    {"layered MSM4 16-bit", kRgba16,
     "lvsm_encodeMoments4(lvsm_layerMoments4(depth, vec2(lvsm_splits[slice / 4][slice % 4], "
     "lvsm_splits[(slice + 1) / 4][(slice + 1) % 4])))",
     "1.0"},
    {"four sines 8-bit", kRgba8, "lvsm_encodeFourier(lvsm_fourierSines(depth, 4 * slice + 1, 16))", "1.0"},
    {"trigonometric 16-bit", kRgba16, "lvsm_trigonometricMoments(depth)", "1.0"},
};

std::string bindings(const std::string& prefix, const std::string& source)
{
    return "#define " + prefix + '_' + source + " layout(binding = 2)\n#define " + prefix +
           "_TARGET layout(binding = 3)\n#define " + prefix + "_BLOCK layout(std140, binding = 4)\n";
}

// A pass as a text, with macros in front of it.
std::string passText(const std::string& glslFolder, const std::string& pass, const std::string& macros)
{
    return withIncludes("#version 450\n#extension GL_EXT_control_flow_attributes : require\n" + macros + "#include \"" +
                            pass + ".comp\"\n",
                        glslFolder);
}

std::string storeMacros(const Stored& stored)
{
    return bindings("LVSM_STORE", "DEPTHS") + "#define LVSM_STORE(depth, slice) " + stored.expression +
           "\n#define LVSM_STORE_LARGEST " + stored.largest + "\n#define LVSM_STORE_FORMAT " + stored.format.name +
           '\n';
}

Kernel pass(const std::string& name, const std::string& text, double readBytes, double writtenBytes)
{
    Kernel kernel{"pass", name, unrolled(text)};
    kernel.readBytes = readBytes;
    kernel.writtenBytes = writtenBytes;
    return kernel;
}

Kernel store(const std::string& glslFolder, const Stored& stored)
{
    const std::string text = passText(glslFolder, "store", storeMacros(stored));
    return pass(std::string("store ") + stored.name, specialised(text, "lvsm_Store", "#define lvsm_layerCount 8\n"),
                kDepthBytes, stored.format.bytes);
}

// One direction, whose taps are fetched in pairs. The second loop, which only texels near the edge run, has no turns.
Kernel blur(const std::string& glslFolder, int width, const Format& format)
{
    const std::string text =
        passText(glslFolder, "blur",
                 bindings("LVSM_BLUR", "SOURCE") + "#define LVSM_BLUR_FETCHES " + std::to_string((width + 1) / 2) +
                     "\n#define LVSM_BLUR_FORMAT " + format.name + '\n');
    return pass("blur " + std::to_string(width) + ' ' + format.name,
                specialised(text, "lvsm_Blur", "#define lvsm_fetchCount 0\n"), format.bytes, format.bytes);
}

// Both loads of a row's threads: each wave runs both.
Kernel fused(const std::string& glslFolder, const Stored& stored, int width)
{
    std::string text =
        passText(glslFolder, "fused", storeMacros(stored) + "#define LVSM_FUSED_BLOCK layout(std140, binding = 5)\n");
    text = specialised(text, "lvsm_Store", "#define lvsm_layerCount 8\n");
    text = replaced(text, "int i = thread; i < 64 + 2 * lvsm_reach; i += 64",
                    "int i = thread, turn = 0; turn < 2; i += 64, ++turn");
    text = specialised(text, "lvsm_Fused",
                       "#define lvsm_sliceCount 1\n#define lvsm_reach " + std::to_string(width / 2) + '\n');
    return pass(std::string("fused ") + stored.name + ' ' + std::to_string(width), text, kDepthBytes,
                stored.format.bytes);
}

// A texel of a level of even size, which is the mean of 2 x 2.
Kernel mip(const std::string& glslFolder, const Format& format)
{
    std::string text =
        passText(glslFolder, "mip", bindings("LVSM_MIP", "SOURCE") + "#define LVSM_MIP_FORMAT " + format.name + '\n');
    text = specialised(text, "lvsm_Mip",
                       "#define lvsm_before ivec4(0, 0, 1024, 1024)\n#define lvsm_region ivec4(0, 0, 512, 512)\n");
    text = replaced(text, "int y = first.y; y <= last.y; ++y", "int j = 0, y = first.y; j < 2; ++j, ++y");
    text = replaced(text, "int x = first.x; x <= last.x; ++x", "int i = 0, x = first.x; i < 2; ++i, ++x");
    return pass(std::string("mip ") + format.name, text, 4.0 * format.bytes, format.bytes);
}

// From four filtered moments to a code. The library has the function and no pass for it.
Kernel code(const std::string& glslFolder, const Format& format, const std::string& expression, int bits)
{
    const std::string text = withIncludes("#version 450\n#extension GL_EXT_control_flow_attributes : require\n"
                                          "#include \"lvsm/lvsm.glsl\"\n",
                                          glslFolder) +
                             "layout(local_size_x = 8, local_size_y = 8) in;\n"
                             "layout(binding = 2) uniform sampler2DArray moments;\n"
                             "layout(binding = 3, " +
                             format.name +
                             ") uniform writeonly image2DArray target;\n"
                             "void main()\n{\n    ivec3 texel = ivec3(gl_GlobalInvocationID);\n"
                             "    imageStore(target, texel, " +
                             expression + ");\n}\n";
    return pass("code MSM4 quantised " + std::to_string(bits) + "-bit", text, kRgba32f.bytes, format.bytes);
}

} // namespace

std::vector<Kernel> passKernels(const std::string& glslFolder)
{
    std::vector<Kernel> kernels;
    for (const Stored& stored : kStored)
        kernels.push_back(store(glslFolder, stored));
    for (const int width : kWidths)
    {
        for (const Format& format : kFormats)
            kernels.push_back(blur(glslFolder, width, format));
    }
    for (const Stored& stored : kStored)
    {
        const std::string name = stored.name;
        for (const int width : kWidths)
        {
            if (name == "VSM" || name == "MSM4 16-bit" || name == "two layers 8-bit")
                kernels.push_back(fused(glslFolder, stored, width));
        }
    }
    for (const Format& format : kFormats)
        kernels.push_back(mip(glslFolder, format));
    const std::string moments = "texelFetch(moments, texel, 0)";
    kernels.push_back(code(glslFolder, kRgba16, "lvsm_quantiseMoments4(" + moments + ", LVSM_MOMENT4_BIAS_FP32)", 64));
    kernels.push_back(code(glslFolder, kRg16,
                           "vec4(vec2(lvsm_packQuantised4(lvsm_quantiseMoments4(" + moments +
                               ", LVSM_MOMENT4_BIAS_FP32))) / 65535.0, 0.0, 0.0)",
                           32));
    return kernels;
}

} // namespace cost
