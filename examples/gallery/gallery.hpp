#ifndef LVSM_GALLERY_GALLERY_HPP
#define LVSM_GALLERY_GALLERY_HPP

#include <filesystem>
#include <string>
#include <vector>

#include "page.hpp"
#include "shaders.hpp"

namespace lvsm::gallery
{

struct GalleryOptions
{
    /// Width of the pictures in pixels; they are three wide to two high.
    int size = 640;
    int mapSize = 512;
    /// All techniques, and not only those that are quick.
    bool full = false;
    /// Identifiers of the only techniques to show; empty shows all.
    std::vector<std::string> techniques;
};

/// Renders every scene under every light with every technique, tells stderr how far it is, and writes the pictures
/// into `folder`. The sections point into `scenes`.
std::vector<Section> renderGallery(const VulkanContext& gpu, const std::vector<Scene>& scenes,
                                   const GalleryOptions& options, const std::filesystem::path& folder);

} // namespace lvsm::gallery

#endif
