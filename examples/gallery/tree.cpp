#include "tree.hpp"

#include <random>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

namespace lvsm::gallery
{
namespace
{

constexpr glm::vec3 kBark{0.33f, 0.25f, 0.18f};
constexpr glm::vec3 kLeaf{0.30f, 0.42f, 0.16f};
constexpr int kForks = 5;
constexpr int kBranchesPerFork = 3;
constexpr int kLeavesPerTwig = 9;
constexpr float kLeafLength = 0.17f;

class TreeBuilder
{
public:
    TreeBuilder(Mesh& mesh, unsigned seed) : m_mesh(mesh), m_random(seed) {}

    void grow(glm::vec3 from, glm::vec3 direction, float length, float radius, int forks)
    {
        const glm::vec3 to = from + direction * length;
        const float end = radius * 0.66f;
        addBar(m_mesh, from, to, radius, end, kBark);
        if (forks == 0)
        {
            for (int i = 0; i < kLeavesPerTwig; ++i)
                addLeaf(glm::mix(from, to, uniform(0.3f, 1.2f)));
            return;
        }
        const float turn = uniform(0.0f, glm::two_pi<float>());
        for (int i = 0; i < kBranchesPerFork; ++i)
        {
            const float around = turn + glm::two_pi<float>() * static_cast<float>(i) / kBranchesPerFork;
            const glm::vec3 branch = tilted(direction, around, uniform(0.45f, 0.85f));
            grow(to, branch, length * uniform(0.62f, 0.8f), end, forks - 1);
        }
    }

private:
    // The C++ standard leaves the distributions open, and the tree must be the same everywhere.
    float uniform(float low, float high)
    {
        const float unit = static_cast<float>(m_random() >> 8) * 0x1p-24f;
        return low + (high - low) * unit;
    }

    static glm::vec3 tilted(glm::vec3 axis, float around, float angle)
    {
        const glm::vec3 helper = glm::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        const glm::vec3 side = glm::angleAxis(around, axis) * glm::normalize(glm::cross(axis, helper));
        return glm::normalize(glm::cos(angle) * axis + glm::sin(angle) * side);
    }

    void addLeaf(glm::vec3 stem)
    {
        // One after the other: compilers differ about the order in which arguments are computed.
        const float lean = uniform(0.0f, 1.0f);
        const glm::vec3 facing = tilted({0, 1, 0}, uniform(0.0f, glm::two_pi<float>()), lean);
        const glm::vec3 along = tilted(facing, uniform(0.0f, glm::two_pi<float>()), glm::half_pi<float>());
        const glm::vec3 across = glm::cross(facing, along) * (0.3f * kLeafLength);
        const glm::vec3 middle = stem + along * (0.5f * kLeafLength);
        const glm::vec3 tip = stem + along * kLeafLength;
        addQuad(m_mesh, stem, middle - across, tip, middle + across, kLeaf * uniform(0.8f, 1.2f), Object::Thin);
    }

    Mesh& m_mesh;
    std::mt19937 m_random;
};

} // namespace

void addTree(Mesh& mesh, glm::vec3 foot, unsigned seed)
{
    TreeBuilder(mesh, seed).grow(foot, glm::normalize(glm::vec3(0.08f, 1.0f, 0.05f)), 1.9f, 0.15f, kForks);
}

} // namespace lvsm::gallery
