#include "gallery.hpp"

#include <cstdio>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "pictures.hpp"
#include "raster.hpp"

namespace lvsm::gallery
{
namespace
{

using Type = vk::DescriptorType;

constexpr float kAspect = 1.5f;
constexpr vk::Format kVec4 = vk::Format::eR32G32B32A32Sfloat;

View viewOf(const Camera& camera)
{
    glm::mat4 projection = glm::perspective(glm::radians(camera.fieldOfView), kAspect, 0.1f, 200.0f);
    projection[1][1] *= -1.0f; // Vulkan's y points down
    return {projection * glm::lookAt(camera.eye, camera.target, {0, 1, 0}), glm::vec4(camera.eye, 1)};
}

class Progress
{
public:
    explicit Progress(std::size_t steps) : m_steps(steps) {}

    void step(const Scene& scene, const Light& light, const std::string& what)
    {
        ++m_done;
        std::fprintf(stderr, "[%3zu %%] %s, %s: %s\n", 100 * m_done / m_steps, scene.title.c_str(), light.title.c_str(),
                     what.c_str());
    }

private:
    std::size_t m_steps;
    std::size_t m_done = 0;
};

class Renderer
{
public:
    Renderer(const VulkanContext& gpu, const GalleryOptions& options, const std::filesystem::path& folder,
             std::size_t sceneCount)
        : m_gpu(gpu), m_options(options), m_folder(folder),
          m_shadowPass(gpu, "shadow.frag", {vk::Format::eR32Sfloat}, true),
          m_surfacePass(gpu, "surface.frag", {kVec4, kVec4, kVec4, kVec4}, false),
          m_exact(gpu, compile("exact.comp", support::ShaderStage::Compute),
                  bindingsOf({Type::eUniformBuffer, Type::eCombinedImageSampler, Type::eCombinedImageSampler,
                              Type::eCombinedImageSampler, Type::eCombinedImageSampler, Type::eStorageImage})),
          m_sampler(support::makeSampler(gpu)), m_progress(sceneCount * 2 * (techniques().size() + 1))
    {
        for (const Technique& technique : techniques())
        {
            m_runners.push_back(std::make_unique<TechniqueRunner>(gpu, technique));
        }
    }

    void render(const Scene& scene, std::vector<Section>& sections)
    {
        const Buffer vertices = support::makeBufferOf(m_gpu, scene.mesh);
        const int width = m_options.size * kSupersampling;
        const int height = static_cast<int>(static_cast<float>(m_options.size) / kAspect) * kSupersampling;
        const std::vector<Texture> surface = m_surfacePass.draw(vertices, viewOf(scene.camera), {width, height}, 0.0f);
        Picture picture{width, height, support::readTexels<glm::vec4>(m_gpu, surface[0]),
                        support::readTexels<glm::vec4>(m_gpu, surface[1]),
                        support::readTexels<glm::vec4>(m_gpu, surface[3])};
        for (const Light& light : makeLights(scene))
        {
            sections.push_back(renderLight(scene, light, vertices, surface, picture));
        }
    }

private:
    // One scene under one light, and what is known about it before any technique runs.
    struct Subject
    {
        const Scene& scene;
        const Light& light;
        const Picture& picture;
        const Texture& positions;
        const Buffer& lightBlock;
        const Texture& depthMap;
        const std::vector<float>& depths;
        const Truth& truth;
        const std::vector<bool>& shielded;
    };

    Section renderLight(const Scene& scene, const Light& light, const Buffer& vertices,
                        const std::vector<Texture>& surface, const Picture& picture)
    {
        const Buffer lightBlock = support::makeBufferOf(m_gpu, std::vector{light.block});
        const View lightView{light.block.viewProjection, light.block.position};
        const std::vector<Texture> maps =
            m_shadowPass.draw(vertices, lightView, {m_options.mapSize, m_options.mapSize}, 1.0f, &lightBlock);
        const std::vector<float> depths = support::readTexels<float>(m_gpu, maps[0]);
        const Truth truth = exactVisibility(lightBlock, surface, maps[0]);
        const std::vector<bool> shielded =
            scene.shield ? shieldedGround(picture, truth, light, scene.shield->box) : std::vector<bool>();

        Section section{&scene, light, fileName(scene, light, "exact"), {}};
        const std::vector<glm::vec2> exact(truth.begin(), truth.end());
        writeShaded(path(section.exact), picture, truth, exact, light.isSpot());
        m_progress.step(scene, light, "exact");

        const Subject subject{scene, light, picture, surface[0], lightBlock, maps[0], depths, truth, shielded};
        for (std::size_t i = 0; i < m_runners.size(); ++i)
        {
            section.rows.push_back(renderTechnique(subject, techniques()[i], *m_runners[i]));
            m_progress.step(scene, light, techniques()[i].title);
        }
        return section;
    }

    Row renderTechnique(const Subject& subject, const Technique& technique, const TechniqueRunner& runner) const
    {
        const auto fileOf = [&](const std::string& suffix)
        {
            return fileName(subject.scene, subject.light, technique.id + suffix);
        };
        const bool layered = technique.layerCount > 1;
        Row row;
        row.technique = &technique;
        row.shaded = fileOf("");
        row.errors = fileOf("-error");
        if (layered)
            row.splits = placeSplits(subject.depths, subject.depthMap.size, technique.layerCount);

        const TechniqueBlock block = parameters(technique, subject.light, row.splits);
        const auto visibility = runner.run(subject.lightBlock, block, subject.depthMap, subject.positions);
        row.figures = measure(visibility, subject.truth, subject.shielded);
        writeShaded(path(row.shaded), subject.picture, subject.truth, visibility, subject.light.isSpot());
        writeErrors(path(row.errors), subject.picture, subject.truth, visibility);
        if (layered)
        {
            row.layers = fileOf("-layers");
            writeLayers(path(row.layers), subject.picture, subject.truth, visibility);
        }
        return row;
    }

    Truth exactVisibility(const Buffer& lightBlock, const std::vector<Texture>& surface, const Texture& depthMap) const
    {
        using namespace support;
        const Texture result = makeTexture(m_gpu, surface[0].size, kVec4);
        runOver(m_exact,
                {uniformAt(0, lightBlock), sampledAt(1, surface[0].array, m_sampler),
                 sampledAt(2, surface[1].array, m_sampler), sampledAt(3, surface[2].array, m_sampler),
                 sampledAt(4, depthMap.array, m_sampler), storageAt(5, result.array)},
                result.size);
        return support::readTexels<glm::vec4>(m_gpu, result);
    }

    static std::string fileName(const Scene& scene, const Light& light, const std::string& what)
    {
        return scene.id + "-" + light.id + "-" + what + ".png";
    }

    std::string path(const std::string& file) const { return (m_folder / file).string(); }

    const VulkanContext& m_gpu;
    GalleryOptions m_options;
    std::filesystem::path m_folder;
    RasterPass m_shadowPass;
    RasterPass m_surfacePass;
    Kernel m_exact;
    vk::raii::Sampler m_sampler;
    std::vector<std::unique_ptr<TechniqueRunner>> m_runners;
    Progress m_progress;
};

} // namespace

std::vector<Section> renderGallery(const VulkanContext& gpu, const std::vector<Scene>& scenes,
                                   const GalleryOptions& options, const std::filesystem::path& folder)
{
    Renderer renderer(gpu, options, folder, scenes.size());
    std::vector<Section> sections;
    for (const Scene& scene : scenes)
        renderer.render(scene, sections);
    return sections;
}

} // namespace lvsm::gallery
