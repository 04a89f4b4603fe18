// The papers' scenes, built anew from what their text and figures say of them.
#ifndef LVSM_TESTS_PAPERS_SCENES_HPP
#define LVSM_TESTS_PAPERS_SCENES_HPP

#include "depth_peel.hpp"
#include "truth.hpp"

namespace lvsm::papers
{

using quality::Receiver;

/// Elevation and azimuth in degrees, of a light or a camera.
struct Direction
{
    float elevation;
    float azimuth;
};

/// Part of a camera's picture, in shares of its width and height from the upper left corner.
struct Crop
{
    float left, top, right, bottom;
};

struct Box
{
    glm::vec3 low, high;
};

struct Setup
{
    quality::Mesh mesh;
    Direction light;
    bool spot;
    Direction camera;
    Crop crop;
    Box shield{}; ///< the second occluder, in whose shadow nothing may bleed; empty: everywhere
};

quality::Light lightOf(const Setup& setup, int size);

/// Depth of the split half-way between the shield's farthest point and the nearest point of its shadow on the ground.
float splitBehindShield(const Setup& setup);

/// LVSM figure 2: plane A high above plane B, and B just above the ground C.
Setup planes();
/// LVSM figures 3 and 5: a tree over a bench over the ground.
Setup bench();
/// LVSM figures 6 to 8: slabs far above others that are close to the ground.
Setup blocks();

/// ESM figures 1, 8 and 10: a yard with a house, trees and a table, fenced in.
Setup yard();

/// The article on VSM: a round thing and a thin wall on a floor, before a wall; by a directional light or from a point.
Setup room(bool spot);

/// What a camera sees, as receivers in the light's map.
struct View
{
    int width, height;
    std::vector<Receiver> receivers;
    std::vector<bool> shielded; ///< of each receiver: on the ground, in full shadow, behind the shield
    std::vector<int> at;        ///< of each pixel, row by row from above: its receiver, or -1
    std::vector<float> facing;  ///< of each pixel: n.l, 0 where it is not lit, -1 where there is nothing
};

/// A scene, its light's depth peel and what the camera sees, with exact visibilities under a binomial filter.
struct Lit
{
    quality::Scene scene;
    View view;
    int filterWidth;
};

/// mapSize: texels along each side. pixels: of the camera's whole picture, of which the crop is kept.
Lit lit(const std::string& name, const Setup& setup, int mapSize, int filterWidth, int pixels);

/// The same in the last part of a longer range of the light: what is at depth z comes to 1 - share + share z.
Lit farther(const Lit& lit, float share);

} // namespace lvsm::papers

#endif
