// lvsm_pass_times: how long a device takes to make a map of mixtures, beside four moments that are stored and blurred by
// passes/fused and passes/blur over as many texels. Prints the times and their ratios, and writes them as JSON.
#include <lvsm/passes_fused.hpp>
#include <lvsm/passes_mixture.hpp>

#include <gpu.hpp>
#include <shader_compiler.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace
{

using namespace lvsm::support;

struct Dispatch
{
    Kernel kernel;
    std::vector<Binding> bindings;
    lvsm::GroupCount groups;
};

// Everything that a map's passes need, and the passes.
struct Making
{
    std::string name;
    std::vector<Texture> textures;
    std::vector<Buffer> buffers;
    std::vector<Dispatch> dispatches;
    double milliseconds = 1e30;
};

class Device
{
public:
    Device(VulkanContext& context, std::string folder, int size)
        : m_context(context), m_folder(std::move(folder)), m_size(size), m_whole{0, 0, size, size},
          m_sampler(makeSampler(context)), m_nearest(makeSampler(context, vk::Filter::eNearest)),
          m_queries(context.device, vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, 2))
    {
        // Slanted ground under leaves: what merges and what does not.
        std::vector<float> depths;
        for (int i = 0; i < size * size; ++i)
        {
            const int x = i % size, y = i / size;
            const std::uint32_t hash =
                (static_cast<std::uint32_t>(x / 3) * 73856093u ^ static_cast<std::uint32_t>(y / 2) * 19349663u) *
                2654435761u;
            const float ground = 0.5f + 0.3f * static_cast<float>(x + y) / static_cast<float>(2 * size);
            depths.push_back(hash >> 30 == 0 && y < size / 2 ? 0.2f + static_cast<float>(hash >> 8 & 255u) / 1024.0f
                                                             : ground);
        }
        m_depths = makeTexture(context, Shape{size, size}, vk::Format::eR32Sfloat, depths.data(), depths.size() * 4);
    }

    Making moments(int width) const
    {
        Making making{"MSM4, fused and blurred, width " + std::to_string(width), {}, {}, {}, 1e30};
        const auto passes =
            lvsm::fusedPasses(lvsm::binomialKernel(width), nullptr, 0, 0, m_whole, m_whole, glm::vec4(1));
        for (int i = 0; i < 2; ++i)
            making.textures.push_back(makeTexture(m_context, Shape{m_size, m_size}, vk::Format::eR16G16B16A16Unorm));
        making.buffers.push_back(makeBufferOf(m_context, std::vector{passes.store.block}));
        making.buffers.push_back(makeBufferOf(m_context, std::vector{passes.fused}));
        making.buffers.push_back(makeBufferOf(m_context, std::vector{passes.down.block}));
        add(making, "fused.comp",
            "#define LVSM_STORE(depth, slice) lvsm_encodeMoments4(lvsm_depthMoments4(depth))\n"
            "#define LVSM_STORE_LARGEST 1.0\n#define LVSM_STORE_FORMAT rgba16\n",
            {sampledAt(0, m_depths.flat, m_nearest), storageAt(1, making.textures[0].array),
             uniformAt(2, making.buffers[0]), uniformAt(3, making.buffers[1])},
            passes.store.groups);
        add(making, "blur.comp", "#define LVSM_BLUR_FORMAT rgba16\n",
            {sampledAt(0, making.textures[0].array, m_sampler), storageAt(1, making.textures[1].array),
             uniformAt(2, making.buffers[2])},
            passes.down.groups);
        return making;
    }

    Making mixtures(int count, int width, bool half) const
    {
        Making making{"K = " + std::to_string(count) + ", width " + std::to_string(width) + (half ? ", half" : ""),
                      {},
                      {},
                      {},
                      1e30};
        // At half resolution a texel of the map is two of the depths.
        const auto passes = lvsm::mixturePasses(half ? width / 4 * 2 + 1 : width, half, m_whole, m_whole);
        for (int i = 0; i < passes.count; ++i)
        {
            const bool isLast = i + 1 == passes.count;
            const int coded = half ? m_size / 2 : m_size;
            const Shape shape = isLast ? Shape{coded, coded} : Shape{passes.between.width, passes.between.height, 4};
            const bool isTwo = isLast && count == 2;
            making.textures.push_back(
                makeTexture(m_context, shape, isTwo ? vk::Format::eR32G32Uint : vk::Format::eR32G32B32A32Uint));
            making.buffers.push_back(makeBufferOf(m_context, std::vector{passes.passes[i].block}));
            const std::size_t at = static_cast<std::size_t>(i);
            add(making, "mixture.comp",
                "#define LVSM_MIXTURE_COUNT " + std::to_string(count) + "\n" +
                    (i > 0 ? "#define LVSM_MIXTURE_FROM_MIXTURES\n" : "") +
                    (isLast ? "" : "#define LVSM_MIXTURE_TO_MIXTURES\n"),
                {sampledAt(0, i > 0 ? making.textures[at - 1].array : m_depths.flat, m_nearest),
                 storageAt(1, making.textures[at].array), uniformAt(2, making.buffers[at])},
                passes.passes[i].groups);
        }
        return making;
    }

    // The least of what it took so far and of once more.
    void time(Making& making) const
    {
        stamp(0);
        for (const Dispatch& d : making.dispatches)
            d.kernel.run(d.bindings, static_cast<std::uint32_t>(d.groups.x), static_cast<std::uint32_t>(d.groups.y), 1);
        stamp(1);
        const auto ticks = m_queries
                               .getResults<std::uint64_t>(0, 2, 2 * sizeof(std::uint64_t), sizeof(std::uint64_t),
                                                          vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait)
                               .second;
        const double period = static_cast<double>(m_context.physical.getProperties().limits.timestampPeriod);
        making.milliseconds = std::min(making.milliseconds, static_cast<double>(ticks[1] - ticks[0]) * period * 1e-6);
    }

private:
    void stamp(std::uint32_t index) const
    {
        submit(m_context,
               [&](vk::raii::CommandBuffer& commands)
               {
                   commands.resetQueryPool(*m_queries, index, 1);
                   commands.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *m_queries, index);
               });
    }

    void add(Making& making, const std::string& file, const std::string& macros, const std::vector<Binding>& bindings,
             const lvsm::GroupCount& groups) const
    {
        ShaderOptions options;
        options.preamble = macros;
        options.name = m_folder + "/lvsm/passes/" + file;
        options.includeFolders = {m_folder};
        const auto spirv = compileShaderFile(options.name, options);
        if (!spirv)
            throw std::runtime_error(spirv.error());
        making.dispatches.push_back({Kernel(m_context, {*spirv, "main"}, bindings), bindings, groups});
    }

    VulkanContext& m_context;
    std::string m_folder;
    int m_size;
    lvsm::Rectangle m_whole;
    Texture m_depths;
    vk::raii::Sampler m_sampler;
    vk::raii::Sampler m_nearest;
    vk::raii::QueryPool m_queries;
};

void measure(VulkanContext& context, const std::string& folder, int size, int repeats, const std::string& output)
{
    const Device device(context, folder, size);
    std::ofstream json(output);
    json << "{\n \"device\": \"" << context.name.device << "\",\n \"size\": " << size << ",\n \"rows\": [";
    const char* separator = "\n";
    for (const int width : {7, 15})
    {
        std::vector<Making> all;
        all.push_back(device.moments(width));
        for (const int count : {2, 4})
        {
            for (const bool half : {false, true})
                all.push_back(device.mixtures(count, width, half));
        }
        for (int i = 0; i < repeats; ++i)
        {
            for (Making& making : all)
                device.time(making);
        }
        for (const Making& making : all)
        {
            const double ratio = making.milliseconds / all[0].milliseconds;
            std::printf("%-40s %9.2f ms  %6.2f of MSM4\n", making.name.c_str(), making.milliseconds, ratio);
            json << separator << "  {\"name\": \"" << making.name << "\", \"ms\": " << making.milliseconds
                 << ", \"of_moments\": " << ratio << "}";
            separator = ",\n";
        }
    }
    json << "\n ]\n}\n";
    if (!json)
        throw std::runtime_error("cannot write " + output);
}

} // namespace

int main(int argc, char** argv)
{
    std::string folder, output = "pass_times.json", name = "llvmpipe";
    int size = 512, repeats = 5;
    CLI::App app("Times the passes that make a map of mixtures beside those of four moments.");
    app.add_option("--glsl", folder, "folder that holds lvsm/lvsm.glsl")->required();
    app.add_option("--device", name, "part of the device's name");
    app.add_option("--size", size, "of the map in texels, even")->check(CLI::Range(64, 4096));
    app.add_option("--repeats", repeats, "of which the least time counts")->check(CLI::PositiveNumber);
    app.add_option("--output", output, "file for the times as JSON");
    CLI11_PARSE(app, argc, argv);
    auto device = VulkanDevice::open({name, false});
    if (!device)
    {
        std::printf("skip %s: %s\n", name.c_str(), device.error().c_str());
        return 77;
    }
    try
    {
        measure(device->context(), folder, size, repeats, output);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "lvsm_pass_times: %s\n", error.what());
        return 1;
    }
}
