// The wrappers of no technique, PCF, layers with transitions and ESM; wrappers_techniques.cpp has the others.
#include "wrappers_truth.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace sampling
{

using Vec2 = glm::dvec2;
using Vec4 = glm::dvec4;

Vec2 cornerOf(Vec2 uv)
{
    return glm::floor(uv * double(kSize) - 0.5);
}

Vec4 texelOrBorder(const Pixels& map, int x, int y, int slice, int level, Vec4 border)
{
    const int size = kSize >> level;
    return x >= 0 && y >= 0 && x < size && y < size ? Vec4(map.at(x, y, slice, level)) : border;
}

// Bilinear among texels, as if border lay around the map.
Vec4 filteredTexel(const Pixels& map, const Receiver& receiver, int slice, Vec4 border)
{
    const double size = kSize >> receiver.level;
    const Vec2 corner = glm::floor(receiver.uv * size - 0.5);
    const Vec2 f = receiver.uv * size - 0.5 - corner;
    const int x = static_cast<int>(corner.x);
    const int y = static_cast<int>(corner.y);
    const auto texel = [&](int dx, int dy)
    {
        return texelOrBorder(map, x + dx, y + dy, slice, receiver.level, border);
    };
    const Vec4 top = texel(0, 0) * (1 - f.x) + texel(1, 0) * f.x;
    const Vec4 bottom = texel(0, 1) * (1 - f.x) + texel(1, 1) * f.x;
    return top * (1 - f.y) + bottom * f.y;
}

Vec4 gatheredTexels(const Pixels& map, Vec2 uv, int slice, double border)
{
    const int x = static_cast<int>(cornerOf(uv).x);
    const int y = static_cast<int>(cornerOf(uv).y);
    const auto texel = [&](int dx, int dy)
    {
        return texelOrBorder(map, x + dx, y + dy, slice, 0, Vec4(border)).x;
    };
    return {texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)};
}

namespace
{

double layerVisibility(const Maps& maps, const Receiver& receiver, int layer)
{
    const Vec2 interval = lvsm::layerInterval<double>(kSplits[layer], kSplits[layer + 1], 0.0625);
    const Vec4 texel = filteredTexel(maps.slices, receiver, kOverlapping + layer / 2, Vec4(1));
    return lvsm::layeredVisibility(lvsm::unpackLayer(texel, layer), receiver.depth, interval, 0.01);
}

double layersVisibility(const Maps& maps, const Receiver& receiver)
{
    const int layer = lvsm::layerIndex(static_cast<float>(receiver.depth), kSplits, kLayers);
    const double weight = lvsm::transitionWeight<double>(receiver.depth, kSplits[layer], kSplits[layer + 1], 0.0625);
    const double visibility = layerVisibility(maps, receiver, layer);
    if (weight == 0)
        return visibility;
    const double neighbour = layerVisibility(maps, receiver, weight < 0 ? layer - 1 : layer + 1);
    return lvsm::blendTransition(visibility, neighbour, weight);
}

// By its definition: every texel of the map and around it, compared with the plane and weighted.
double pcfVisibility(const Maps& maps, const Receiver& receiver, double deviation)
{
    const Vec2 position = receiver.uv * double(kSize) - 0.5;
    double lit = 0;
    double all = 0;
    for (int y = -8; y < kSize + 8; ++y)
    {
        for (int x = -8; x < kSize + 8; ++x)
        {
            const Vec2 offset = Vec2(x, y) - position;
            double weight = lvsm::boxWeight(offset.x, 3.5) * lvsm::boxWeight(offset.y, 3.5);
            if (deviation > 0)
                weight *= std::exp(-0.5 * glm::dot(offset, offset) / (deviation * deviation));
            const double plane = lvsm::planeDepth(receiver.depth, Vec2(0.01, -0.02), offset);
            all += weight;
            lit += weight * lvsm::depthTest(texelOrBorder(maps.slices, x, y, kDepths, 0, Vec4(1)).x, plane, 0.001);
        }
    }
    return lit / all;
}

double fourTerms(const Maps& maps, const Receiver& receiver)
{
    const double empty = lvsm::occluderTerm(1.0, receiver.exponent);
    const Vec2 fraction = receiver.uv * double(kSize) - 0.5 - cornerOf(receiver.uv);
    return lvsm::exponentialShadow2x2(gatheredTexels(maps.unfiltered, receiver.uv, kTerms, empty), fraction,
                                      receiver.depth, receiver.exponent);
}

double filteredTerm(const Maps& maps, const Receiver& receiver)
{
    return filteredTexel(maps.slices, receiver, kTerms, Vec4(lvsm::occluderTerm(1.0, receiver.exponent))).x;
}

double esmVisibility(const Maps& maps, const Receiver& receiver)
{
    const double occluder = filteredTerm(maps, receiver);
    if (lvsm::violatesThreshold(occluder, receiver.depth, receiver.exponent, receiver.threshold))
        return fourTerms(maps, receiver);
    return lvsm::exponentialShadow(occluder, receiver.depth, receiver.exponent);
}

double esmZMaxVisibility(const Maps& maps, const Receiver& receiver)
{
    double greatest = 0;
    for (const int level : {0, receiver.level})
    {
        const Vec2 corner = glm::floor(receiver.uv * double(kSize >> level) - 0.5);
        for (int i = 0; i < 4; ++i)
            greatest = std::max(greatest, texelOrBorder(maps.greatest, static_cast<int>(corner.x) + i % 2,
                                                        static_cast<int>(corner.y) + i / 2, kTerms, level, Vec4(1))
                                              .x);
    }
    if (lvsm::violatesZMax(receiver.depth, greatest, receiver.offset))
        return fourTerms(maps, receiver);
    return lvsm::exponentialShadow(filteredTerm(maps, receiver), receiver.depth, receiver.exponent);
}

// The table of OpenGL, Vulkan and Direct3D: axes of s and t of the faces +x, -x, +y, -y, +z, -z.
const glm::dvec3 kS[] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
const glm::dvec3 kT[] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};

Vec2 onFace(const glm::dvec3& direction, int face, double tangent)
{
    const double distance = std::abs(direction[face / 2]);
    const Vec2 place(glm::dot(kS[face], direction), glm::dot(kT[face], direction));
    return 0.5 + 0.5 * place / (distance * tangent);
}

int faceOf(const glm::vec3& direction)
{
    const glm::vec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (direction[axis] < 0 ? 1 : 0);
}

void compareFace(Comparison& comparison, const Receiver& receiver, const float* result, const std::string& where)
{
    const int face = faceOf(receiver.direction);
    const glm::dvec3 direction(receiver.direction);
    const double tangent = static_cast<double>(receiver.tangent);
    // Two sums of quotients up to 1 with a divisor and a factor that are rounded.
    const Vec2 uv = onFace(direction, face, tangent);
    comparison.expect(static_cast<double>(result[0]), uv.x, 8.0 / (1 << 24), where);
    comparison.expect(static_cast<double>(result[1]), uv.y, 8.0 / (1 << 24), where);
    const glm::dvec3 changes[] = {{0, 0.02, 0.01}, {0.03, 0, -0.01}};
    const double distance = std::abs(direction[face / 2]);
    for (int i = 0; i < 2; ++i)
    {
        // The derivative as a difference so small that its error, of second order, is below that of rounding.
        const double step = 1e-6 * distance;
        const Vec2 there = onFace(direction + step * changes[i], face, tangent);
        const Vec2 back = onFace(direction - step * changes[i], face, tangent);
        const Vec2 slope = 0.5 * (there - back) / step;
        for (int c = 0; c < 2; ++c)
            comparison.expect(static_cast<double>(result[2 + 2 * i + c]), slope[c],
                              16.0 / (1 << 24) * 0.06 / distance + 1e-9 / distance, where);
    }
    comparison.expect(static_cast<double>(result[6]), 5 + 2 * face, 0, where);
}

constexpr int kCubeSize = 64;
constexpr int kMargin = 3;

double cubeFunction(const glm::dvec3& direction)
{
    return glm::dot(glm::normalize(direction), glm::dvec3(0.3, -0.5, 0.7));
}

} // namespace

float tangentOfCube()
{
    return float(kCubeSize) / float(kCubeSize - 2 * kMargin);
}

Pixels makeCube()
{
    Pixels cube(kCubeSize, kCubeSize, kSliceCount);
    for (int i = 0; i < 6 * kCubeSize * kCubeSize; ++i)
    {
        const int x = i % kCubeSize;
        const int y = i / kCubeSize % kCubeSize;
        const int face = i / (kCubeSize * kCubeSize);
        const Vec2 place = (2.0 * (Vec2(x, y) + 0.5) / double(kCubeSize) - 1.0) * double(tangentOfCube());
        const glm::dvec3 axis = glm::cross(kT[face], kS[face]);
        cube.at(x, y, 5 + 2 * face) = glm::dvec4(cubeFunction(axis + place.x * kS[face] + place.y * kT[face]));
    }
    return cube;
}

bool compareCube(const std::vector<Receiver>& receivers, const std::vector<float>& results)
{
    Comparison cube("sampleSlice of a cube");
    // The second derivative of a unit vector's part along a unit vector is 1 at most, in x and in y; a texel is so long.
    const double texel = 2 * double(tangentOfCube()) / kCubeSize;
    for (std::size_t i = 0; i < receivers.size(); ++i)
        cube.expect(static_cast<double>(results[i * kResults + 48]), cubeFunction(glm::dvec3(receivers[i].direction)),
                    2 * texel * texel / 8,
                    std::to_string(receivers[i].direction.x) + ' ' + std::to_string(receivers[i].direction.y) + ' ' +
                        std::to_string(receivers[i].direction.z));
    return cube.passed();
}

bool compareWrappers(const Maps& maps, const std::vector<Receiver>& receivers, const std::vector<float>& results,
                     int components)
{
    Comparison samples("sampleMap and sampleSlice");
    Comparison gathers("gatherMap, gatherSlice and fetchSlice");
    Comparison fractions("mapFraction");
    Comparison layers("sampleLayers");
    Comparison pcf("samplePcf");
    Comparison gaussian("samplePcf of a Gaussian");
    Comparison esm("sampleEsm");
    Comparison zMax("sampleEsmZMax");
    Comparison faces("cubePoint");
    Comparison floors("LVSM_MIN_VARIANCE and LVSM_MIN_VARIANCE_FP16");
    // Rounded up, and by no more than that.
    const double fp16 = lvsm::recommendedMinVariance(3 * lvsm::kDepthErrorFp16<double>, 0.01);
    floors.expect(5.4e-5, 1.01 * fp16, 0.01 * fp16, "half floats");
    const double unorm16 = lvsm::recommendedMinVariance(3 * lvsm::kDepthErrorUnorm16<double>, 0.01);
    floors.expect(static_cast<double>(results[49]), 1.01 * std::max(unorm16, 1.0 / (1 << 24)), 0.01 / (1 << 24),
                  "other");
    for (std::size_t i = 0; i < receivers.size(); ++i)
    {
        const Receiver& receiver = receivers[i];
        const float* result = &results[i * kResults];
        const std::string where = "texel " + std::to_string(receiver.uv.x * kSize) + ' ' +
                                  std::to_string(receiver.uv.y * kSize) + " depth " + std::to_string(receiver.depth) +
                                  " level " + std::to_string(receiver.level);
        const Vec4 border(1, 2, 3, 4);
        const Vec4 texel = filteredTexel(maps.map, receiver, 0, border);
        const Vec4 slice = filteredTexel(maps.slices, receiver, 1, border);
        const Vec4 corners = gatheredTexels(maps.map, receiver.uv, 0, 5);
        const Vec4 sliceCorners = gatheredTexels(maps.slices, receiver.uv, 1, 5);
        const Vec2 own = glm::floor(receiver.uv * double(kSize));
        const Vec4 fetched = maps.slices.at(static_cast<int>(own.x), static_cast<int>(own.y), 1);
        const double rounding = 1.0 / (1 << 21);
        for (int c = 0; c < 4; ++c)
        {
            if (c < components)
            {
                // Weights in 16ths are exact; three products and sums of numbers up to 4 in each direction are not.
                samples.expect(static_cast<double>(result[c]), texel[c], 4 * rounding, where);
                samples.expect(static_cast<double>(result[4 + c]), slice[c], 4 * rounding, where);
                gathers.expect(static_cast<double>(result[18 + c]), fetched[c], 0, where);
            }
            gathers.expect(static_cast<double>(result[8 + c]), corners[c], 0, where);
            gathers.expect(static_cast<double>(result[12 + c]), sliceCorners[c], 0, where);
        }
        const Vec2 fraction = receiver.uv * double(kSize) - 0.5 - cornerOf(receiver.uv);
        fractions.expect(static_cast<double>(result[16]), fraction.x, 0, where);
        fractions.expect(static_cast<double>(result[17]), fraction.y, 0, where);
        // Weights of 25 texels, each with a few roundings of numbers up to 8, over the width.
        pcf.expect(static_cast<double>(result[22]), pcfVisibility(maps, receiver, 0), 25 * 8 * rounding, where);
        // The exponentials of up to 4 are 11 units in the last place off, twice.
        gaussian.expect(static_cast<double>(result[23]), pcfVisibility(maps, receiver, 1.25), 25 * 12 * rounding,
                        where);
        // Two exponentials of up to the exponent: each is 3 + 2 * exponent units in the last place off.
        const double ofTerms = 2 * (3 + 2 * receiver.exponent) / (1 << 23) + rounding;
        esm.expect(static_cast<double>(result[24]), esmVisibility(maps, receiver), ofTerms, where);
        zMax.expect(static_cast<double>(result[50]), esmZMaxVisibility(maps, receiver), ofTerms, where);
        // The variance floor in a layer is at least 0.01 / 0.375^2 = 0.07, over which the bound divides the errors of
        // about five moments' roundings, twice for two layers.
        if (components == 4)
            layers.expect(static_cast<double>(result[40]), layersVisibility(maps, receiver), 10 * rounding / 0.07,
                          where);
        compareFace(faces, receiver, result + 41, where);
    }
    bool passed = samples.passed();
    for (const Comparison* comparison : {&gathers, &fractions, &pcf, &gaussian, &esm, &zMax, &faces, &floors})
        passed = comparison->passed() && passed;
    if (components == 4)
        passed = layers.passed() && passed;
    return compareTechniques(maps, receivers, results, components) && passed;
}

} // namespace sampling
