// Times of the papers' techniques on a Vulkan device, by the library's own passes and wrappers: for ratios within a run.
// A time is the processor's, of all threads, which on a software device is the work that is done; the least of several
// runs in turns. Geometry is left out: it is the same for all.
#include <cstdio>
#include <ctime>
#include <limits>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "frame.hpp"
#include "whole_file.hpp"

namespace lvsm::papers
{
namespace
{

double processorMilliseconds(const std::function<void()>& work)
{
    const auto now = []
    {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    };
    const double before = now();
    work();
    return now() - before;
}

/// What is measured in turns, so that what else the machine does meets all of it alike.
class Race
{
public:
    Race(const support::VulkanContext& context, nlohmann::ordered_json& values, std::string item)
        : m_context(context), m_values(values), m_item(std::move(item))
    {
    }

    /// A frame, and its shading alone.
    void add(const std::string& name, const Way& way, const FrameOptions& options)
    {
        const auto frame = std::make_shared<Frame>(m_context, way, options);
        add(name + "_map", [frame] { frame->makeMap(); });
        add(name + "_shade", [frame] { frame->shade(); });
    }
    void add(const std::string& name, std::function<void()> work) { m_entries.push_back({name, std::move(work)}); }

    void run(int rounds)
    {
        std::fprintf(stderr, "%s\n", m_item.c_str());
        std::map<std::string, double> least;
        for (int round = 0; round < rounds; ++round)
        {
            for (const auto& [name, work] : m_entries)
            {
                const double time = processorMilliseconds(work);
                const auto found = least.try_emplace(name, time).first;
                found->second = std::min(found->second, time);
            }
        }
        for (const auto& [name, work] : m_entries)
            m_values[m_item][name] = least[name];
        m_entries.clear();
    }

private:
    struct Entry
    {
        std::string name;
        std::function<void()> work;
    };
    const support::VulkanContext& m_context;
    nlohmann::ordered_json& m_values;
    std::string m_item;
    std::vector<Entry> m_entries;
};

// The papers' viewports; the project does not tell its own.
constexpr vk::Extent2D kLvsmView(1920, 1200), kEsmView(800, 800), kProjectView(1920, 1080);

FrameOptions options(vk::Extent2D view, int mapSize, int blur, bool levels)
{
    FrameOptions made;
    made.view = view;
    made.mapSize = mapSize;
    made.blur = blur;
    made.levels = levels;
    return made;
}

/// LVSM figure 9, with transitions, levels and anisotropy; and section 6's claim of one sample without.
void layers(const support::VulkanContext& context, nlohmann::ordered_json& values, int rounds)
{
    for (const int size : {256, 512, 1024, 2048})
    {
        Race race(context, values, "time_layers" + std::to_string(size));
        FrameOptions full = options(kLvsmView, size, 1, true);
        full.anisotropic = true;
        race.add("vsm", vsm(), full);
        for (const int count : {2, 4, 8, 14})
            race.add("lvsm" + std::to_string(count), lvsm(count, true), full);
        race.run(rounds);
    }
    Race race(context, values, "time_single");
    race.add("vsm", vsm(), options(kLvsmView, 1024, 1, false));
    for (const int count : {2, 4, 8, 14})
        race.add("lvsm" + std::to_string(count), lvsm(count, false), options(kLvsmView, 1024, 1, false));
    race.run(2 * rounds);
}

/// LVSM figures 8 and 10.
void storage(const support::VulkanContext& context, nlohmann::ordered_json& values, int rounds)
{
    Race race(context, values, "time_storage");
    for (const int count : {2, 4, 8})
    {
        race.add("lvsm" + std::to_string(count), lvsm(count, true), options(kLvsmView, 1024, 1, true));
        race.add("csm" + std::to_string(2 * count), csm(2 * count), options(kLvsmView, 1024, 1, true));
    }
    race.add("evsm4", evsm4(), options(kLvsmView, 1024, 1, true));
    race.run(rounds);
}

/// ESM tables 1 and 2.
void exponential(const support::VulkanContext& context, nlohmann::ordered_json& values, int rounds)
{
    for (const int size : {512, 1024, 2048})
    {
        for (const int width : {1, 3, 7})
        {
            Race race(context, values, "time_esm" + std::to_string(size) + "_" + std::to_string(width));
            race.add("threshold", esm(false), options(kEsmView, size, width, true));
            race.add("z_max", esm(true), options(kEsmView, size, width, true));
            race.add("vsm", vsm(), options(kEsmView, size, width, true));
            race.add("csm", csm(16), options(kEsmView, size, width, true));
            race.run(rounds);
        }
    }
    for (const int size : {128, 256, 512, 1024})
    {
        for (const int width : {1, 3, 5})
        {
            const FrameOptions square = options(kEsmView, size, width, true);
            Race race(context, values, "time_tests" + std::to_string(size) + "_" + std::to_string(width));
            race.add("threshold", esm(false), square);
            race.add("z_max", esm(true), square);
            race.run(rounds);
        }
    }
}

/// The project's two tables.
void project(const support::VulkanContext& context, nlohmann::ordered_json& values, int rounds)
{
    const auto pcf = [](const std::string& width, const std::string& deviation)
    {
        return ofDepths("lvsm_samplePcf(map, at, depth, vec2(0.0), " + width + ", " + deviation + ", 0.001)");
    };
    for (const int size : {512, 1024, 2048})
    {
        Race race(context, values, "time_project" + std::to_string(size));
        FrameOptions blurred = options(kProjectView, size, 9, false), plain = options(kProjectView, size, 1, false);
        blurred.paired = true;
        FrameOptions full = blurred;
        full.levels = full.anisotropic = true;
        race.add("basic",
                 ofDepths("lvsm_depthTest(lvsm_fetchSlice(map, at, 0, floor(at.uv * lvsm_mapArraySize(map))).x, "
                          "depth, 0.001)"),
                 plain);
        race.add("pcf2", pcf("1.0", "0.0"), plain);
        race.add("pcf3", pcf("3.0", "0.0"), plain);
        race.add("pcf3_gauss", pcf("3.0", "2.0"), plain);
        race.add("pcf9_gauss", pcf("9.0", "2.0"), plain);
        race.add("vsm", vsm(), plain);
        race.add("vsm_pcf3", vsmNineSamples(), plain);
        race.add("vsm_9", vsm(), blurred);
        race.add("evsm", evsm4(), plain);
        race.add("evsm_9", evsm4(), blurred);
        race.add("evsm_full", evsm4(), full);
        race.run(rounds);
    }
    Race race(context, values, "time_blurs");
    constexpr int kSize = 1024;
    race.add("one_pass3", onePassBlur(context, kSize, 1));
    race.add("one_pass5", onePassBlur(context, kSize, 2));
    for (const auto& [name, taps, paired] : {std::tuple("five", 5, false),
                                             {"seven", 7, false},
                                             {"nine", 9, false},
                                             {"nine_linear", 9, true},
                                             {"none", 1, false}})
    {
        FrameOptions blur = options(kEsmView, kSize, taps, false);
        blur.paired = paired;
        race.add(name, evsm4(), blur);
    }
    race.run(rounds);
}

} // namespace
} // namespace lvsm::papers

int main(int argc, char** argv)
{
    std::string output = "build/reports/papers_times.json", device;
    int rounds = 3;
    CLI::App app("Times of the papers' techniques on a Vulkan device");
    app.add_option("--output", output, "Where the times go, as JSON, in milliseconds")->capture_default_str();
    app.add_option("--device", device, "Part of the device's name");
    app.add_option("--rounds", rounds, "How often each is run; the least counts")->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    auto opened = lvsm::support::VulkanDevice::open({device, false});
    if (!opened)
    {
        std::fprintf(stderr, "lvsm_papers_time: %s\n", opened.error().c_str());
        return 77;
    }
    try
    {
        using namespace lvsm::papers;
        nlohmann::ordered_json values;
        values["run"]["device"] = opened->name().device;
        for (const auto part : {layers, storage, exponential, project})
            part(opened->context(), values, rounds);
        if (const auto problem = lvsm::support::writeWholeFile(output, values.dump(1) + '\n'))
            throw std::runtime_error(*problem);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "lvsm_papers_time: %s\n", error.what());
        return 1;
    }
    return 0;
}
