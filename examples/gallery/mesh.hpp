#ifndef LVSM_GALLERY_MESH_HPP
#define LVSM_GALLERY_MESH_HPP

#include <vector>

#include <glm/glm.hpp>

namespace lvsm::gallery
{

/// Objects that the figures tell apart.
enum class Object
{
    Ground = 1,
    Other = 2,
    /// Of one face that is lit from either side.
    Thin = 3
};

/// One corner of a triangle. `normal` shades, `faceNormal` is the triangle's own plane.
struct Vertex
{
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec3 faceNormal;
    glm::vec3 colour;
    float object;
    /// On a leaf that the alpha test cuts out, from -1 to 1 along and across; 0 on what is solid.
    glm::vec2 place{0.0f};
};

/// Triangles, three vertices each.
using Mesh = std::vector<Vertex>;

struct Box
{
    glm::vec3 low;
    glm::vec3 high;

    glm::vec3 centre() const { return 0.5f * (low + high); }
    glm::vec3 corner(int index) const;
};

/// A normal of length 0, as files may have it, is the triangle's own.
void addTriangle(Mesh& mesh, const glm::vec3 (&corners)[3], const glm::vec3 (&normals)[3], glm::vec3 colour,
                 Object object = Object::Other);

/// Corners in turn around the quadrilateral.
void addQuad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, glm::vec3 colour,
             Object object = Object::Other);

/// A leaf that the alpha test cuts out of a rectangle: from its stem twice `along`, and `across` to both sides.
void addCutOut(Mesh& mesh, glm::vec3 stem, glm::vec3 along, glm::vec3 across, glm::vec3 colour);

void addBox(Mesh& mesh, const Box& box, glm::vec3 colour);

/// A tapering round bar, open at its ends.
void addBar(Mesh& mesh, glm::vec3 from, glm::vec3 to, float radiusFrom, float radiusTo, glm::vec3 colour);

/// A square of ground at height 0.
void addGround(Mesh& mesh, float halfWidth, glm::vec3 colour);

} // namespace lvsm::gallery

#endif
