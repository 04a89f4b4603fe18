#include "gallery.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>

#include "pictures.hpp"
#include "placer.hpp"
#include "progress.hpp"
#include "shading.hpp"

namespace lvsm::gallery
{
namespace
{

constexpr float kAspect = 1.5f;
// The technique that is shown while the light moves, over so large an angle.
const char* const kMoved = "lvsm4";
constexpr float kSweep = 1.2f;

View viewOf(const Camera& camera)
{
    glm::mat4 projection = glm::perspective(glm::radians(camera.fieldOfView), kAspect, 0.1f, 200.0f);
    projection[1][1] *= -1.0f; // Vulkan's y points down
    return {projection * glm::lookAt(camera.eye, camera.target, {0, 1, 0}), glm::vec4(camera.eye, 1)};
}

std::vector<const Technique*> chosen(const GalleryOptions& options)
{
    std::vector<const Technique*> result;
    for (const Technique& technique : techniques())
    {
        const auto& ids = options.techniques;
        const bool isNamed = std::find(ids.begin(), ids.end(), technique.id) != ids.end();
        if (ids.empty() ? technique.quick || options.full : isNamed)
            result.push_back(&technique);
    }
    return result;
}

int frameCount(const GalleryOptions& options)
{
    return options.full ? 16 : 5;
}

std::size_t stepsOf(const std::vector<Scene>& scenes, const GalleryOptions& options)
{
    const std::vector<const Technique*> shown = chosen(options);
    const bool isMoved =
        std::any_of(shown.begin(), shown.end(), [](const Technique* technique) { return technique->id == kMoved; });
    std::size_t steps = 0;
    for (const Scene& scene : scenes)
    {
        steps += makeLights(scene, options.mapSize, options.full).size() * (shown.size() + 1);
        steps += scene.isTurned && isMoved ? static_cast<std::size_t>(frameCount(options)) : 0;
    }
    return steps;
}

class Renderer
{
public:
    Renderer(const VulkanContext& gpu, const GalleryOptions& options, const std::filesystem::path& folder,
             std::size_t steps)
        : m_gpu(gpu), m_options(options), m_folder(folder), m_surfacePass(gpu), m_shadowPass(gpu), m_peelPass(gpu),
          m_reader(gpu), m_placer(gpu), m_truth(gpu), m_techniques(chosen(options)), m_progress(steps)
    {
        for (const Technique* technique : m_techniques)
            m_runners.push_back(std::make_unique<TechniqueRunner>(gpu, *technique));
    }

    void render(const Scene& scene, std::vector<Section>& sections)
    {
        const Buffer vertices = support::makeBufferOf(m_gpu, scene.mesh);
        const int width = m_options.size * kSupersampling;
        const int height = static_cast<int>(static_cast<float>(m_options.size) / kAspect) * kSupersampling;
        const Surface surface = m_surfacePass.draw(vertices, viewOf(scene.camera), {width, height});
        const Points seen = readPoints(m_gpu, surface);
        const Picture picture{width, height, seen[0], seen[1], seen[3]};
        for (const Light& light : makeLights(scene, m_options.mapSize, m_options.full))
        {
            sections.push_back(renderLight(scene, light, vertices, seen, picture));
            if (scene.isTurned && light.id == "directional")
                renderFrames(sections.back(), vertices, surface, picture);
        }
    }

private:
    // One scene under one light, and what is known about it before any technique runs.
    struct Subject
    {
        const Scene& scene;
        const Light& light;
        const Picture& picture;
        // The receivers: the picture's, and then those of the light's peels.
        const Surface& surface;
        Buffer lightBlock;
        LightDepths depths;
        PeelCounts peels = {};
        // By the window's name.
        std::map<std::string, Truth> truths = {};
        std::vector<bool> shielded = {};
    };

    Subject subjectOf(const Scene& scene, const Light& light, const Buffer& vertices, const Surface& surface,
                      const Picture& picture) const
    {
        return {scene,
                light,
                picture,
                surface,
                support::makeBufferOf(m_gpu, std::vector{light.block}),
                m_reader.read(m_shadowPass.draw(vertices, light), light)};
    }

    // Adds the receivers of the light's depth peels, the nearest first.
    PeelCounts addPeels(Points& receivers, const Buffer& vertices, const Light& light) const
    {
        PeelCounts counts;
        for (const Points& peel : m_peelPass.draw(vertices, light))
        {
            for (std::size_t image = 0; image < kSurfaceImages; ++image)
                receivers[image].insert(receivers[image].end(), peel[image].begin(), peel[image].end());
            counts.hidden += counts.peels > 0 ? peel[0].size() : 0;
            counts.receivers += peel[0].size();
            counts.peels += peel[0].empty() ? 0 : 1;
        }
        return counts;
    }

    Section renderLight(const Scene& scene, const Light& light, const Buffer& vertices, const Points& seen,
                        const Picture& picture)
    {
        Points receivers = seen;
        const PeelCounts peels = addPeels(receivers, vertices, light);
        const Surface surface = makeSurface(m_gpu, receivers, picture.width);
        Subject subject = subjectOf(scene, light, vertices, surface, picture);
        subject.peels = peels;
        const Truth& truth = truthOf(subject, blurWindow());
        if (scene.shield)
            subject.shielded = shieldedGround(picture, truth, light, scene.shield->box);

        Section section{&scene, light, fileName(subject, "exact"),
                        {},     peels, depthHistogram(support::readTexels<float>(m_gpu, subject.depths.linear))};
        const std::vector<glm::vec2> exact(truth.begin(), truth.end());
        writeShaded(path(section.exact), picture, truth, exact, light.isSpot());
        tell(subject, "exact");
        for (std::size_t i = 0; i < m_techniques.size(); ++i)
        {
            section.rows.push_back(renderTechnique(subject, *m_techniques[i], *m_runners[i]));
            tell(subject, m_techniques[i]->title);
        }
        return section;
    }

    Row renderTechnique(Subject& subject, const Technique& technique, const TechniqueRunner& runner)
    {
        Row row;
        row.technique = &technique;
        row.shaded = fileName(subject, technique.id);
        row.errors = fileName(subject, technique.id + "-error");

        std::optional<Texture> seen;
        if (technique.layers.placing == Placing::InView)
            seen = m_placer.countSeen(subject.lightBlock, subject.depths, subject.surface,
                                      {subject.picture.width, subject.picture.height});
        const Buffer splits = m_placer.place(technique, subject.scene, subject.light, subject.depths, seen);
        const auto visibility = runner.run(subject.light, subject.lightBlock, subject.depths, splits, subject.surface);
        const Truth& truth = truthOf(subject, *technique.window);
        const std::size_t camera = subject.picture.surface.size();
        const std::size_t all = camera + subject.peels.receivers;
        row.figures = measure(visibility, truth, 0, camera, subject.shielded);
        row.everywhere = measure(visibility, truth, camera, all);
        row.hidden = measure(visibility, truth, all - subject.peels.hidden, all);
        writeShaded(path(row.shaded), subject.picture, truth, visibility, subject.light.isSpot());
        writeErrors(path(row.errors), subject.picture, truth, visibility);
        if (technique.layerCount > 1)
        {
            row.splits = readSplits(splits, technique.layerCount);
            row.layers = fileName(subject, technique.id + "-layers");
            writeLayers(path(row.layers), subject.picture, truth, visibility);
        }
        return row;
    }

    // The light as it moves, with four layers that the device relaxes anew for each frame.
    void renderFrames(Section& section, const Buffer& vertices, const Surface& surface, const Picture& picture)
    {
        const auto layered = std::find_if(m_techniques.begin(), m_techniques.end(),
                                          [](const Technique* technique) { return technique->id == kMoved; });
        if (layered == m_techniques.end())
            return;
        const TechniqueRunner& runner = *m_runners[static_cast<std::size_t>(layered - m_techniques.begin())];
        const Scene& scene = *section.scene;
        const int count = frameCount(m_options);
        for (int i = 0; i < count; ++i)
        {
            const float angle = kSweep * (static_cast<float>(i) / static_cast<float>(count - 1) - 0.5f);
            const Light light = makeTurnedLight(scene, m_options.mapSize, angle);
            Subject subject = subjectOf(scene, light, vertices, surface, picture);
            const Buffer splits = m_placer.place(**layered, scene, light, subject.depths);
            const Differences differences = m_placer.compareWithHost((*layered)->layerCount, subject.depths);
            const std::string name = fileName(subject, "frame" + std::to_string(i));
            const Truth& truth = truthOf(subject, blurWindow());
            const auto visibility = runner.run(light, subject.lightBlock, subject.depths, splits, surface);
            writeShaded(path(name), picture, truth, visibility, light.isSpot());
            section.frames.push_back({angle, name, readSplits(splits, (*layered)->layerCount), differences.relaxed,
                                      differences.optimal, differences.optimalIsAsGood});
            tell(subject, "frame " + std::to_string(i + 1) + " of " + std::to_string(count));
        }
    }

    const Truth& truthOf(Subject& subject, const Window& window) const
    {
        auto& truth = subject.truths[window.id];
        if (truth.empty())
            truth = m_truth.find(subject.lightBlock, subject.depths, subject.surface, window);
        return truth;
    }

    void tell(const Subject& subject, const std::string& what)
    {
        m_progress.step(subject.scene.title + ", " + subject.light.title + ": " + what);
    }

    static std::string fileName(const Subject& subject, const std::string& what)
    {
        return subject.scene.id + "-" + subject.light.id + "-" + what + ".png";
    }

    std::string path(const std::string& file) const { return (m_folder / file).string(); }

    const VulkanContext& m_gpu;
    GalleryOptions m_options;
    std::filesystem::path m_folder;
    SurfacePass m_surfacePass;
    ShadowPass m_shadowPass;
    PeelPass m_peelPass;
    DepthReader m_reader;
    Placer m_placer;
    TruthFinder m_truth;
    std::vector<const Technique*> m_techniques;
    std::vector<std::unique_ptr<TechniqueRunner>> m_runners;
    Progress m_progress;
};

} // namespace

std::vector<Section> renderGallery(const VulkanContext& gpu, const std::vector<Scene>& scenes,
                                   const GalleryOptions& options, const std::filesystem::path& folder)
{
    Renderer renderer(gpu, options, folder, stepsOf(scenes, options));
    std::vector<Section> sections;
    for (const Scene& scene : scenes)
        renderer.render(scene, sections);
    return sections;
}

} // namespace lvsm::gallery
