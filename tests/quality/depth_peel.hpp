// Depth peels of triangle meshes: every surface along every ray of a light, by rasterising on the host.
#ifndef LVSM_TESTS_QUALITY_DEPTH_PEEL_HPP
#define LVSM_TESTS_QUALITY_DEPTH_PEEL_HPP

#include <vector>

#include "peel.hpp"

namespace lvsm::quality
{

/// Corners anticlockwise seen from outside. A two-sided triangle, such as a leaf, is lit from either side.
struct Triangle
{
    glm::vec3 corners[3];
    bool twoSided;
};

using Mesh = std::vector<Triangle>;

/// A light and the part of space that its map covers: a box for a directional light, a pyramid for a spot light.
class Light
{
public:
    /// Both shine on the whole mesh, from the given elevation and azimuth in degrees; y is up.
    static Light directional(const Mesh& mesh, float elevation, float azimuth, int size);
    static Light spot(const Mesh& mesh, float elevation, float azimuth, int size);

    struct Ray
    {
        glm::dvec3 origin;
        glm::dvec3 direction;
    };

    /// The ray through a point of the map, in texels; the centre of the first texel is at 0.5.
    Ray ray(double x, double y) const;

    /// The same light with another grid: so many texels further.
    Light moved(glm::dvec2 texels) const;

    /// The point of a depth that falls on a place of the map, in texels.
    glm::dvec3 point(glm::dvec2 place, double depth) const;

    /// Where a point falls on the map, in texels.
    glm::dvec2 texel(glm::dvec3 point) const;

    /// Depth of a point, in [0,1]: the distance to the light's plane, or to the spot light, over the reach of the mesh and
    /// a little more.
    double depth(glm::dvec3 point) const;

private:
    Light(const Mesh& mesh, bool spot, glm::dvec3 origin, glm::dvec3 forward, int size);

    glm::dvec3 local(glm::dvec3 point) const;
    double distance(glm::dvec3 point) const;

    bool m_spot;
    glm::dvec3 m_origin, m_right, m_up, m_forward;
    glm::dvec2 m_low, m_texelsPerUnit;
    double m_nearDistance, m_farDistance;
};

Peel depthPeel(const Mesh& mesh, const Light& light, int size);

} // namespace lvsm::quality

#endif
