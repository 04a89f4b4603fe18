#include "gallery.hpp"

#include <cstdio>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "pictures.hpp"
#include "raster.hpp"

namespace lvsm::gallery {
namespace {

using Type = vk::DescriptorType;

constexpr float kAspect = 1.5f;
constexpr vk::Format kVec4 = vk::Format::eR32G32B32A32Sfloat;

View viewOf(const Camera& camera) {
  glm::mat4 projection = glm::perspective(glm::radians(camera.fieldOfView), kAspect, 0.1f, 200.0f);
  projection[1][1] *= -1.0f;  // Vulkan's y points down
  return {projection * glm::lookAt(camera.eye, camera.target, {0, 1, 0}), camera.eye};
}

class Progress {
 public:
  explicit Progress(std::size_t steps) : steps_(steps) {}

  void step(const Scene& scene, const Light& light, const std::string& what) {
    ++done_;
    std::fprintf(stderr, "[%3zu %%] %s, %s: %s\n", 100 * done_ / steps_, scene.title.c_str(), light.title.c_str(),
                 what.c_str());
  }

 private:
  std::size_t steps_;
  std::size_t done_ = 0;
};

class Renderer {
 public:
  Renderer(const VulkanContext& gpu, const GalleryOptions& options, const std::filesystem::path& folder,
           std::size_t sceneCount)
      : gpu_(gpu),
        options_(options),
        folder_(folder),
        shadowPass_(gpu, "shadow.frag", {vk::Format::eR32Sfloat}, true),
        surfacePass_(gpu, "surface.frag", {kVec4, kVec4, kVec4, kVec4}, false),
        exact_(gpu, compile("exact.comp", support::ShaderStage::Compute),
               {Type::eUniformBuffer, Type::eCombinedImageSampler, Type::eCombinedImageSampler,
                Type::eCombinedImageSampler, Type::eCombinedImageSampler, Type::eStorageImage}),
        progress_(sceneCount * 2 * (techniques().size() + 1)) {
    for (const Technique& technique : techniques()) {
      runners_.push_back(std::make_unique<TechniqueRunner>(gpu, technique));
    }
  }

  void render(const Scene& scene, std::vector<Section>& sections) {
    const Buffer vertices = uploadMesh(gpu_, scene.mesh);
    const auto width = static_cast<std::uint32_t>(options_.size * kSupersampling);
    const auto height = static_cast<std::uint32_t>(static_cast<float>(options_.size) / kAspect) * kSupersampling;
    const std::vector<Image> surface = surfacePass_.draw(vertices, viewOf(scene.camera), {width, height}, 0.0f);
    Picture picture{static_cast<int>(width), static_cast<int>(height), readImage<glm::vec4>(gpu_, surface[0]),
                    readImage<glm::vec4>(gpu_, surface[1]), readImage<glm::vec4>(gpu_, surface[3])};
    for (const Light& light : makeLights(scene)) {
      sections.push_back(renderLight(scene, light, vertices, surface, picture));
    }
  }

 private:
  Section renderLight(const Scene& scene, const Light& light, const Buffer& vertices,
                      const std::vector<Image>& surface, const Picture& picture) {
    const Buffer lightBlock = makeUniform(gpu_, light.block);
    const auto mapSize = static_cast<std::uint32_t>(options_.mapSize);
    const View lightView{light.block.viewProjection, glm::vec3(light.block.position)};
    const std::vector<Image> maps = shadowPass_.draw(vertices, lightView, {mapSize, mapSize}, 1.0f, &lightBlock);
    const Image& depthMap = maps[0];
    const Truth truth = exactVisibility(lightBlock, surface, depthMap);
    const std::vector<bool> shielded =
        scene.shield ? shieldedGround(picture, truth, light, scene.shield->box) : std::vector<bool>();

    Section section{&scene, light, fileName(scene, light, "exact"), {}};
    writeShaded(path(section.exact), picture, truth, std::vector<glm::vec2>(truth.begin(), truth.end()),
                light.isSpot());
    progress_.step(scene, light, "exact");

    const std::vector<float> depths = readImage<float>(gpu_, depthMap);
    for (std::size_t i = 0; i < runners_.size(); ++i) {
      const Technique& technique = techniques()[i];
      Row row{&technique, {}, fileName(scene, light, technique.id), fileName(scene, light, technique.id + "-error"),
              {}, {}};
      if (technique.layerCount > 1) row.splits = placeSplits(depths, depthMap.extent, technique.layerCount);
      const auto visibility =
          runners_[i]->run(lightBlock, parameters(technique, light, row.splits), depthMap, surface[0]);
      row.figures = measure(visibility, truth, shielded);
      writeShaded(path(row.shaded), picture, truth, visibility, light.isSpot());
      writeErrors(path(row.errors), picture, truth, visibility);
      if (technique.layerCount > 1) {
        row.layers = fileName(scene, light, technique.id + "-layers");
        writeLayers(path(row.layers), picture, truth, visibility);
      }
      section.rows.push_back(std::move(row));
      progress_.step(scene, light, technique.title);
    }
    return section;
  }

  Truth exactVisibility(const Buffer& lightBlock, const std::vector<Image>& surface, const Image& depthMap) const {
    using Usage = vk::ImageUsageFlagBits;
    const Image result = makeImage(gpu_, kVec4, surface[0].extent, 1, Usage::eStorage | Usage::eTransferSrc);
    exact_.run({Uniform{lightBlock}, Sampled{surface[0]}, Sampled{surface[1]}, Sampled{surface[2]}, Sampled{depthMap},
                Storage{result}},
               result.extent);
    return readImage<glm::vec4>(gpu_, result);
  }

  static std::string fileName(const Scene& scene, const Light& light, const std::string& what) {
    return scene.id + "-" + light.id + "-" + what + ".png";
  }

  std::string path(const std::string& file) const { return (folder_ / file).string(); }

  const VulkanContext& gpu_;
  GalleryOptions options_;
  std::filesystem::path folder_;
  RasterPass shadowPass_;
  RasterPass surfacePass_;
  Kernel exact_;
  std::vector<std::unique_ptr<TechniqueRunner>> runners_;
  Progress progress_;
};

}  // namespace

std::vector<Section> renderGallery(const VulkanContext& gpu, const std::vector<Scene>& scenes,
                                   const GalleryOptions& options, const std::filesystem::path& folder) {
  Renderer renderer(gpu, options, folder, scenes.size());
  std::vector<Section> sections;
  for (const Scene& scene : scenes) renderer.render(scene, sections);
  return sections;
}

}  // namespace lvsm::gallery
