// Layered variance shadow map, two layers in each array layer of the image: LVSM paper, sections 3.3 to 5.
#include "technique.glsl"
#include "lvsm/layers.glsl"

float splits[LVSM_MAX_LAYERS + 1];

void loadSplits()
{
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = technique.splits[i].x;
}

vec2 interval(int layer)
{
    return lvsm_layerInterval(splits[layer], splits[layer + 1], technique.overlap);
}

vec4 encode(float depth, int texel)
{
    loadSplits();
    return lvsm_packLayers(lvsm_layerMoments(depth, interval(2 * texel)),
                           lvsm_layerMoments(depth, interval(2 * texel + 1)));
}

float layerVisibility(vec2 coord, float depth, int layer)
{
    vec2 moments = lvsm_unpackLayer(textureLod(source, vec3(coord, layer / 2), 0.0), layer);
    return lvsm_layeredVisibility(moments, depth, interval(layer), technique.minVariance);
}

vec2 receive(vec2 coord, float depth)
{
    loadSplits();
    float receiver = depth - technique.bias;
    int layer = lvsm_layerIndex(receiver, splits, technique.layerCount);
    float visibility = layerVisibility(coord, receiver, layer);
    float weight = lvsm_transitionWeight(receiver, splits[layer], splits[layer + 1], technique.transition);
    if (weight != 0.0)
    {
        int neighbour = weight < 0.0 ? layer - 1 : layer + 1;
        visibility = lvsm_blendTransition(visibility, layerVisibility(coord, receiver, neighbour), weight);
    }
    return vec2(visibility, float(layer));
}
