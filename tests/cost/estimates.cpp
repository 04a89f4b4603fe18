// Whole visibility estimates as a lighting shader makes them: with the wrappers of glsl/lvsm/sampling, from textures.
#include "kernels.hpp"

#include "shader_text.hpp"

#include <cmath>
#include <sstream>

namespace cost
{
namespace
{

struct Estimate
{
    const char* name;
    const char* map;
    int decisions;
    int mostTapsAcross;
    const char* expression;
};

// A lighting pass that knows each pixel's place in the map, its change to the next pixels, and the receiver's plane.
const char* const kScene = R"(
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Receivers { vec4 receivers[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Outputs { float outputs[]; };
layout(set = 0, binding = 2) uniform sampler2DArray map;
layout(set = 0, binding = 2) uniform sampler2DArrayShadow comparedMap;
layout(set = 0, binding = 2) uniform usampler2DArray codes;
layout(std140, set = 0, binding = 4) uniform Layers { float splits[LVSM_MAX_LAYERS + 1]; };
const float minVariance = 1.0e-5;
const float bleeding = 0.1;
const vec2 exponents = vec2(42.0, 10.0);
const float split = 0.4;
const float bias = 0.001;
const float deviation = 1.2247449;
const float contact = 0.15;
const int layerCount = 8;

// A point some texels away.
lvsm_MapPoint moved(lvsm_MapPoint at, vec2 away)
{
    lvsm_MapPoint other = at;
    other.uv += away / lvsm_mapArraySize(map);
    return other;
}
)";

// What the benchmark judges and no wrapper does: layers with the simpler bound, layers relative to the plane where that
// stays within one of them (the wrapper merges those that it reaches), and codes of mixtures that four texels decode.
const char* const kOurs = R"(
struct Three { vec2 front; vec2 own; vec2 behind; };

// Two layers to the texel of one slice.
Three threeOfTwo(vec4 pair, bool isBehind)
{
    return isBehind ? Three(pair.xy, pair.zw, vec2(0.0)) : Three(vec2(1.0), pair.xy, pair.zw);
}

Three threeOf(vec4 own, vec4 other, int layer)
{
    bool isEven = (layer & 1) == 0;
    return Three(layer == 0 ? vec2(1.0) : isEven ? other.zw : own.xy, isEven ? own.xy : own.zw,
                 layer >= layerCount - 1 ? vec2(0.0) : isEven ? own.zw : other.xy);
}

int otherSlice(int layer)
{
    return clamp((layer & 1) == 0 ? layer / 2 - 1 : layer / 2 + 1, 0, layerCount / 2 - 1);
}

float bracketed(lvsm_MapPoint at, float depth, bool compact)
{
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    Three t = threeOf(lvsm_sampleLayerPair(map, at, layer / 2, compact),
                      lvsm_sampleLayerPair(map, at, otherSlice(layer), compact), layer);
    return lvsm_bracketedVisibility(t.front, t.own, t.behind, depth, vec2(splits[layer], splits[layer + 1]), minVariance);
}

float boundedOfTwo(lvsm_MapPoint at, float depth, bool compact)
{
    bool isBehind = depth >= split;
    Three t = threeOfTwo(lvsm_sampleLayerPair(map, at, 0, compact), isBehind);
    return lvsm_bracketedBoundedVisibility(t.front, t.own, t.behind, depth, isBehind ? vec2(split, 1.0) : vec2(0.0, split),
                                           minVariance);
}

float bracketedOfTwo(lvsm_MapPoint at, float depth)
{
    return lvsm_bracketedVisibility2(lvsm_sampleLayerPair(map, at, 0, true), depth, split, minVariance);
}

vec3 meansOf(Three t) { return vec3(t.front.x, t.own.x, t.behind.x); }

float planeVisibility(Three t, vec3 right, vec3 left, vec3 up, vec3 down, float depth, vec2 gradient, vec2 interval)
{
    vec3 covariances = vec3(lvsm_planeCovariance(vec4(right.x, left.x, up.x, down.x), gradient, deviation),
                            lvsm_planeCovariance(vec4(right.y, left.y, up.y, down.y), gradient, deviation),
                            lvsm_planeCovariance(vec4(right.z, left.z, up.z, down.z), gradient, deviation));
    return lvsm_planeBracketedVisibility(t.front, t.own, t.behind, covariances, depth, interval,
                                         lvsm_planeVariance(gradient, deviation), minVariance, contact);
}

vec3 meansOfTwo(lvsm_MapPoint at, vec2 away, bool isBehind)
{
    return meansOf(threeOfTwo(lvsm_sampleNeighbourPair(map, at, 0, true, away), isBehind));
}

float planeOfTwo(lvsm_MapPoint at, float depth, vec2 gradient)
{
    bool isBehind = depth >= splits[1];
    return planeVisibility(threeOfTwo(lvsm_sampleLayerPair(map, at, 0, true), isBehind),
                           meansOfTwo(at, vec2(1.0, 0.0), isBehind), meansOfTwo(at, vec2(-1.0, 0.0), isBehind),
                           meansOfTwo(at, vec2(0.0, 1.0), isBehind), meansOfTwo(at, vec2(0.0, -1.0), isBehind), depth,
                           gradient, isBehind ? vec2(splits[1], 1.0) : vec2(0.0, splits[1]));
}

vec3 meansOfMany(lvsm_MapPoint at, vec2 away, int layer)
{
    return meansOf(threeOf(lvsm_sampleNeighbourPair(map, at, layer / 2, true, away),
                           lvsm_sampleNeighbourPair(map, at, otherSlice(layer), true, away), layer));
}

float planeOfMany(lvsm_MapPoint at, float depth, vec2 gradient)
{
    int layer = lvsm_layerIndex(depth, splits, layerCount);
    return planeVisibility(threeOf(lvsm_sampleLayerPair(map, at, layer / 2, true),
                                   lvsm_sampleLayerPair(map, at, otherSlice(layer), true), layer),
                           meansOfMany(at, vec2(1.0, 0.0), layer), meansOfMany(at, vec2(-1.0, 0.0), layer),
                           meansOfMany(at, vec2(0.0, 1.0), layer), meansOfMany(at, vec2(0.0, -1.0), layer), depth,
                           gradient, vec2(splits[layer], splits[layer + 1]));
}

float mixtureOfFour(lvsm_MapPoint at, float depth, vec2 gradient, bool four)
{
    vec2 size = lvsm_mapCodesSize(codes);
    vec2 corner = lvsm_firstCorner(at.uv, size);
    vec2 fraction = lvsm_mapFraction(at.uv, size);
    float own = lvsm_shiftReceiver(depth, gradient, 0.5);
    vec4 lit;
    for (int i = 0; i < 4; ++i)
    {
        vec2 away = vec2(i & 1, i >> 1);
        uvec4 code = texelFetch(codes, ivec3(corner + away, 0), 0);
        float there = lvsm_planeDepth(own, gradient, away - fraction);
        lit[i] = four ? lvsm_mixtureVisibility4(code, vec2(0.0), there, gradient, deviation, LVSM_MIXTURE_BIAS)
                      : lvsm_mixtureVisibility2(code.xy, vec2(0.0), there, gradient, deviation, LVSM_MIXTURE_BIAS);
    }
    return lvsm_bilinearVisibility(lvsm_maskCorners(lit, corner, size, 1.0), fraction);
}
)";

// Percentage-closer filtering as one who wants it fast writes it, with a sampler whose border is lit.
const char* const kPcf = R"(
// A square of gathers around the receiver's texel, the weights of a fixed window moved between texels.
float pcfWindow(const int gathers, const float weights[28], lvsm_MapPoint at, float depth, vec2 gradient)
{
    vec2 size = lvsm_mapArraySize(map);
    vec2 position = at.uv * size - 0.5;
    vec2 f = fract(position);
    vec3 corner = vec3((position - f + 1.0) / size, 0.0);
    float across[26];
    for (int i = 0; i < 2 * gathers; ++i)
        across[i] = mix(weights[i + 1], weights[i], f.x);
    float sum = 0.0;
    float own = depth - bias + dot(gradient, vec2(1 - gathers) - f);
    for (int y = 0; y < gathers; ++y)
    {
        vec2 rows = vec2(0.0);
        for (int x = 0; x < gathers; ++x)
        {
            vec4 depths = textureGatherOffset(map, corner, ivec2(2 * x + 1 - gathers, 2 * y + 1 - gathers)).wzxy;
            float here = own + gradient.x * float(2 * x) + gradient.y * float(2 * y);
            rows.x += (depths.x >= here ? across[2 * x] : 0.0) + (depths.y >= here + gradient.x ? across[2 * x + 1] : 0.0);
            here += gradient.y;
            rows.y += (depths.z >= here ? across[2 * x] : 0.0) + (depths.w >= here + gradient.x ? across[2 * x + 1] : 0.0);
        }
        sum += rows.x * mix(weights[2 * y + 1], weights[2 * y], f.y) +
               rows.y * mix(weights[2 * y + 2], weights[2 * y + 1], f.y);
    }
    return sum;
}

// 2 x 2 texels, each against the receiver's plane.
float pcfFour(lvsm_MapPoint at, float depth, vec2 gradient)
{
    vec2 size = lvsm_mapArraySize(map);
    vec2 position = at.uv * size - 0.5;
    vec2 f = fract(position);
    vec4 depths = textureGather(map, vec3((position - f + 1.0) / size, 0.0)).wzxy;
    float corner = depth - dot(gradient, f);
    return lvsm_pcfBilinear(depths, f, corner + vec4(0.0, gradient.x, gradient.y, gradient.x + gradient.y), bias);
}

// The least and the greatest depths of the parts of a window, against the receiver's plane over each: 1 in front of all, 0
// behind all, and a half is not certain.
float inRanges(const int across, lvsm_MapPoint at, float depth, vec2 gradient)
{
    vec2 position = at.uv * lvsm_mapArraySize(map);
    float spread = 3.0 * (abs(gradient.x) + abs(gradient.y));
    bool isLit = true;
    bool isDark = true;
    for (int i = 0; i < across * across; ++i)
    {
        vec2 texel = floor(position + 3.0 * vec2(i % across, i / across) - 1.5 * float(across - 1));
        vec2 range = texelFetch(map, ivec3(texel, 0), 0).xy;
        float plane = lvsm_planeDepth(depth, gradient, texel + 0.5 - position);
        isLit = isLit && range.x >= plane + spread - bias;
        isDark = isDark && range.y < plane - spread;
    }
    return isLit ? 1.0 : isDark ? 0.0 : 0.5;
}

// Sixteen places on a disc, turned by a hash of the pixel's place.
vec2 turnedPlace(int i, vec2 turn)
{
    float angle = 2.3999632 * float(i);
    vec2 p = 2.0 * deviation * sqrt((float(i) + 0.5) / 16.0) * vec2(cos(angle), sin(angle));
    return vec2(p.x * turn.x - p.y * turn.y, p.x * turn.y + p.y * turn.x);
}

vec2 turnOf(vec2 place)
{
    float angle = 6.2831853 * fract(52.9829189 * fract(dot(place, vec2(0.06711056, 0.00583715))));
    return vec2(cos(angle), sin(angle));
}

float pcfTurned(lvsm_MapPoint at, float depth, vec2 gradient)
{
    vec2 turn = turnOf(at.uv * lvsm_mapArraySize(map));
    float sum = 0.0;
    for (int i = 0; i < 16; ++i)
    {
        vec2 away = turnedPlace(i, turn);
        sum += pcfFour(moved(at, away), lvsm_planeDepth(depth, gradient, away), gradient);
    }
    return sum / 16.0;
}

// The same with comparing samplers, which take one depth for their four texels.
float pcfTurnedCompared(lvsm_MapPoint at, float depth, vec2 gradient)
{
    vec2 turn = turnOf(at.uv * lvsm_mapArraySize(map));
    float sum = 0.0;
    for (int i = 0; i < 16; ++i)
    {
        vec2 away = turnedPlace(i, turn);
        float own = lvsm_planeDepth(depth, gradient, away) - bias;
        sum += textureGrad(comparedMap, vec4(moved(at, away).uv, 0.0, own), vec2(0.0), vec2(0.0));
    }
    return sum / 16.0;
}
)";

// A constant array of 28: a window's weights between zeros.
std::string window(const std::string& name, const std::vector<double>& weights)
{
    std::ostringstream text;
    text << std::showpoint << "const float " << name << "[28] = float[](0.0";
    for (std::size_t i = 0; i < 27; ++i)
        text << ", " << (i < weights.size() ? weights[i] : 0.0);
    text << ");\n";
    return text.str();
}

std::vector<double> binomial(int width)
{
    std::vector<double> weights{std::pow(0.5, width - 1)};
    for (int i = 1; i < width; ++i)
        weights.push_back(weights.back() * (width - i) / i);
    return weights;
}

// The estimate at the receiver, or the mean of as many as there are taps, a texel apart and on its plane.
std::string body(const std::string& expression, int tapsAcross)
{
    const std::string across = std::to_string(tapsAcross);
    const std::string one =
        "float estimate(lvsm_MapPoint at, float depth, vec2 gradient)\n{\n    return " + expression + ";\n}\n";
    std::string text = one + R"(
void main()
{
    vec4 first = receivers[3u * gl_GlobalInvocationID.x];
    vec4 change = receivers[3u * gl_GlobalInvocationID.x + 1u];
    vec2 gradient = receivers[3u * gl_GlobalInvocationID.x + 2u].xy;
    lvsm_MapPoint at = lvsm_mapPoint(first.xy, change.xy, change.zw, 0);
)";
    if (tapsAcross == 1)
        return text + "    outputs[gl_GlobalInvocationID.x] = estimate(at, first.z, gradient);\n}\n";
    return text + R"(    float sum = 0.0;
    for (int y = 0; y < )" +
           across + R"(; ++y)
    {
        for (int x = 0; x < )" +
           across + R"(; ++x)
        {
            vec2 away = vec2(x, y) - 0.5 * float()" +
           across + R"( - 1);
            sum += window)" +
           across + R"([x + 1] * window)" + across + R"([y + 1] *
                   estimate(moved(at, away), lvsm_planeDepth(first.z, gradient, away), gradient);
        }
    }
    outputs[gl_GlobalInvocationID.x] = sum;
}
)";
}

// The library with samples as they are: the sampler has the border, as one that compares depths has it for PCF.
std::string plainSamples(const std::string& library)
{
    const std::string head =
        "vec4 lvsm_sampleSlice(LVSM_HIGHP sampler2DArray map, lvsm_MapPoint at, int index, vec4 border)\n{\n";
    return replaced(library, head,
                    head + "    return textureGrad(map, vec3(at.uv, float(at.slice + index)), at.dx, at.dy);\n");
}

} // namespace

std::vector<Kernel> estimateKernels(const std::string& glslFolder)
{
    const Estimate estimates[] = {
#define ESTIMATE(name, map, decisions, mostTapsAcross, ...) {#name, #map, decisions, mostTapsAcross, #__VA_ARGS__},
#include "estimates.def"
#undef ESTIMATE
    };
    std::string start = "#version 450\n#extension GL_EXT_control_flow_attributes : require\n"
                        "#include \"lvsm/lvsm.glsl\"\n#include \"lvsm/sampling/combined.glsl\"\n";
    const std::string library = withIncludes(start, glslFolder);
    start = kScene;
    for (const int width : {2, 3, 4, 5, 7, 9, 15, 25})
        start += window("window" + std::to_string(width), binomial(width));
    start += window("box3", std::vector<double>(3, 1.0 / 3.0));
    start += std::string(kOurs) + kPcf;

    std::vector<Kernel> kernels;
    for (const Estimate& estimate : estimates)
    {
        for (int across = 1; across <= estimate.mostTapsAcross; ++across)
        {
            const int taps = across * across;
            const std::string name = estimate.name + (taps == 1 ? "" : ' ' + std::to_string(taps) + " taps");
            const std::string rest = start + body(estimate.expression, across);
            Kernel kernel{"estimate", name, unrolled(plainSamples(library) + rest),
                          taps == 1 ? unrolled(library + rest) : ""};
            kernel.map = estimate.map;
            kernel.decisions = taps * estimate.decisions;
            kernels.push_back(kernel);
        }
    }
    return kernels;
}

} // namespace cost
