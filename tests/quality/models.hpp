// Meshes to build scenes from: files that Assimp reads, and what can be made on the spot.
#ifndef LVSM_TESTS_QUALITY_MODELS_HPP
#define LVSM_TESTS_QUALITY_MODELS_HPP

#include <random>
#include <string>

#include "depth_peel.hpp"
#include "result.hpp"

namespace lvsm::quality
{

/// Numbers that are the same everywhere: the C++ standard leaves its distributions open.
class Random
{
public:
    explicit Random(unsigned seed) : m_generator(seed) {}
    float uniform(float low, float high)
    {
        return low + (high - low) * (static_cast<float>(m_generator() >> 8) * 0x1p-24f);
    }

private:
    std::mt19937 m_generator;
};

/// Reads a model and stands it on the ground at the origin, of height 1 or width 10; y is up. Its faces are turned
/// outwards all together, if they are not.
support::Result<Mesh> loadModel(const std::string& path);

/// Adds a copy of a model: scaled, turned about the vertical by an angle in degrees, and moved.
void place(Mesh& mesh, const Mesh& model, glm::vec3 foot, float scale, float turn);

void addQuad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, bool twoSided);
void addBox(Mesh& mesh, glm::vec3 low, glm::vec3 high);
void addGround(Mesh& mesh, glm::vec2 low, glm::vec2 high);

/// Posts and rails along x, from one point of the ground.
void addFence(Mesh& mesh, glm::vec3 from, float length, float height);

/// A hill of a given height around the origin, and its height at a point.
void addHill(Mesh& mesh, float halfWidth, float height);
float hillHeight(glm::vec2 point, float halfWidth, float height);

/// A trunk, boughs and a crown of flat two-sided leaves.
void addTree(Mesh& mesh, glm::vec3 foot, float height, Random& random);

} // namespace lvsm::quality

#endif
