#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "gallery.hpp"
#include "model.hpp"
#include "whole_file.hpp"

namespace
{

namespace fs = std::filesystem;
using namespace lvsm::gallery;
namespace support = lvsm::support;

constexpr int kFailed = 1;
constexpr int kVerdictsDoNotHold = 3;
// What CTest and others take for "skipped".
constexpr int kNoDevice = 77;

constexpr float kModelHeight = 1.0f;
constexpr float kModelWidth = 1.3f;

struct CommandLine
{
    GalleryOptions gallery;
    std::string model = "/usr/share/glmark2/models/bunny.obj";
    std::string device;
    std::string output = "build/gallery";
    std::string report;
    std::vector<std::string> scenes;
    unsigned treeSeed = 11;
    bool validation = false;
};

void write(const fs::path& path, const std::string& text)
{
    if (const auto problem = support::writeWholeFile(path.string(), text))
        throw std::runtime_error(*problem);
}

/// A folder that becomes the output all at once, or leaves no trace.
class PendingFolder
{
public:
    explicit PendingFolder(const fs::path& target)
        : m_target(target), m_pending(target.string() + ".partial"), m_old(target.string() + ".old")
    {
        // Whoever was stopped within publish() left the last whole page there.
        if (!fs::exists(m_target) && fs::exists(m_old))
            fs::rename(m_old, m_target);
        fs::remove_all(m_pending);
        fs::create_directories(m_pending);
    }
    PendingFolder(const PendingFolder&) = delete;
    PendingFolder& operator=(const PendingFolder&) = delete;
    ~PendingFolder()
    {
        std::error_code ignored;
        fs::remove_all(m_pending, ignored);
    }

    const fs::path& path() const { return m_pending; }

    void publish()
    {
        fs::remove_all(m_old);
        if (fs::exists(m_target))
            fs::rename(m_target, m_old);
        fs::rename(m_pending, m_target);
        fs::remove_all(m_old);
    }

private:
    fs::path m_target;
    fs::path m_pending;
    fs::path m_old;
};

int complain(const std::string& message, int status)
{
    std::fprintf(stderr, "lvsm_gallery: %s\n", message.c_str());
    return status;
}

std::vector<Scene> scenesOf(const CommandLine& arguments, const Mesh& model)
{
    std::vector<Scene> scenes{makeBench(arguments.treeSeed),
                              makePlanes(),
                              makeBlocks(),
                              makeFoliage(),
                              makeYard(),
                              makeSlope(),
                              makeUserModel(model, fs::path(arguments.model).filename().string())};
    const auto isLeftOut = [&](const Scene& scene)
    {
        const auto& ids = arguments.scenes;
        return !ids.empty() && std::find(ids.begin(), ids.end(), scene.id) == ids.end();
    };
    scenes.erase(std::remove_if(scenes.begin(), scenes.end(), isLeftOut), scenes.end());
    return scenes;
}

int makeGallery(const CommandLine& arguments)
{
    const fs::path output = fs::absolute(arguments.output).lexically_normal();
    const fs::path report =
        arguments.report.empty() ? output.parent_path() / "reports" / "gallery.json" : fs::path(arguments.report);

    const auto model = loadModel(arguments.model, kModelHeight, kModelWidth);
    if (!model)
        return complain(model.error(), kFailed);
    support::DeviceOptions deviceOptions;
    deviceOptions.name = arguments.device;
    deviceOptions.validation = arguments.validation;
    auto device = support::VulkanDevice::open(deviceOptions);
    if (!device)
        return complain(device.error(), kNoDevice);
    std::fprintf(stderr, "rendering on %s\n", device->name().device.c_str());

    PendingFolder folder(output);
    const std::vector<Scene> scenes = scenesOf(arguments, *model);
    const auto sections = renderGallery(device->context(), scenes, arguments.gallery, folder.path());
    const auto verdicts = judge(sections);
    write(folder.path() / "index.html",
          pageText(sections, verdicts, {device->name().device, arguments.gallery.mapSize}));
    folder.publish();
    write(report, reportText(sections));
    std::fprintf(stderr, "wrote %s and %s\n", (output / "index.html").c_str(), report.c_str());

    if (!device->validationMessages().empty())
        return complain("the validation layer complained", kFailed);
    int status = 0;
    for (const Verdict& verdict : verdicts)
    {
        std::fprintf(stderr, "%s %s\n", verdict.holds ? "holds:" : "DOES NOT HOLD:", verdict.sentence.c_str());
        if (!verdict.holds && verdict.isRequired)
            status = kVerdictsDoNotHold;
    }
    return status;
}

} // namespace

int main(int argc, char** argv)
{
    CommandLine arguments;
    CLI::App app("Renders the shadow techniques side by side and writes a page with pictures and figures.");
    app.add_option("MODEL", arguments.model, "Model that stands on the ground: any file that Assimp reads")
        ->capture_default_str();
    app.add_option("--size", arguments.gallery.size, "Width of the pictures in pixels")
        ->check(CLI::Range(48, 4096))
        ->capture_default_str();
    app.add_option("--map-size", arguments.gallery.mapSize, "Texels along each side of the shadow map")
        ->check(CLI::Range(32, 8192))
        ->capture_default_str();
    app.add_flag("--full,!--quick", arguments.gallery.full, "All techniques, scenes and frames (default: --quick)");
    app.add_option("--technique", arguments.gallery.techniques, "Identifier of a technique to show, and no others");
    app.add_option("--scene", arguments.scenes, "Identifier of a scene to show, and no others");
    app.add_option("--tree", arguments.treeSeed, "Seed that the tree over the bench grows from")->capture_default_str();
    app.add_option("--device", arguments.device,
                   "Part of the Vulkan device's name (default: $LVSM_VULKAN_DEVICE, or Mesa's lavapipe)");
    app.add_option("--output", arguments.output, "Folder to write, replaced as a whole")
        ->take_last()
        ->capture_default_str();
    app.add_option("--report", arguments.report,
                   "File for the figures (default: reports/gallery.json beside the folder)");
    app.add_flag("--validation", arguments.validation, "Fail where the Vulkan validation layer complains");
    CLI11_PARSE(app, argc, argv);
    try
    {
        return makeGallery(arguments);
    }
    catch (const std::exception& error)
    {
        return complain(error.what(), kFailed);
    }
}
