// Calls every wrapper for one receiver a thread, with every type of map that it takes.
#include "lvsm/sampling/separate.hlsli"

// Two for a receiver: uv, depth, change of the coordinates to the next pixel; exponent and threshold of ESM.
StructuredBuffer<float4> inputs : register(t0);
RWStructuredBuffer<float> outputs : register(u1);
Texture2D<float4> map4 : register(t2);
Texture2DArray<float4> layers4 : register(t3);
Texture2D<float4> terms4 : register(t4);
Texture2D<float4> blurred4 : register(t5);
SamplerState filtering : register(s6);
// The same, as maps of one component and of two.
Texture2D<float> map1 : register(t12);
Texture2DArray<float> layers1 : register(t13);
Texture2D<float> terms1 : register(t14);
Texture2D<float> blurred1 : register(t15);
Texture2D<float2> map2 : register(t22);
Texture2DArray<float2> layers2 : register(t23);
Texture2D<float2> terms2 : register(t24);
Texture2D<float2> blurred2 : register(t25);

[numthreads(1, 1, 1)]
void main(uint3 group : SV_GroupID)
{
    float4 receiver = inputs[2u * group.x];
    float2 esm = inputs[2u * group.x + 1u].xy;
    float2 uv = receiver.xy;
    float depth = receiver.z;
    float2 dx = float2(receiver.w, 0.0);
    float2 dy = float2(0.0, receiver.w);
    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = min(0.25 * float(i), 1.0);

    float4 border = float4(1.0, 2.0, 3.0, 4.0);
    float4 texels[4];
    texels[0] = lvsm_sampleMap(map4, filtering, uv, dx, dy, border);
    texels[1] = lvsm_sampleMapArray(layers4, filtering, uv, 1, dx, dy, border);
    texels[2] = lvsm_gatherMap(map4, filtering, uv, 5.0);
    texels[3] = lvsm_gatherMapArray(layers4, filtering, uv, 1, 5.0);
    // Of each type what it has: x of one, y of two components.
    texels[0].x = lvsm_sampleMap(map1, filtering, uv, dx, dy, border).x;
    texels[0].y = lvsm_sampleMap(map2, filtering, uv, dx, dy, border).y;
    texels[1].x = lvsm_sampleMapArray(layers1, filtering, uv, 1, dx, dy, border).x;
    texels[1].y = lvsm_sampleMapArray(layers2, filtering, uv, 1, dx, dy, border).y;
    texels[2].x = lvsm_gatherMap(map1, filtering, uv, 5.0).x;
    texels[2].y = lvsm_gatherMap(map2, filtering, uv, 5.0).y;
    texels[3].x = lvsm_gatherMapArray(layers1, filtering, uv, 1, 5.0).x;
    texels[3].y = lvsm_gatherMapArray(layers2, filtering, uv, 1, 5.0).y;
    float2 fraction = lvsm_mapFraction(uv, float2(8.0, 8.0));
    float layered = lvsm_sampleLayers(layers4, filtering, uv, dx, dy, depth, splits, 4, 0.0625, 0.0625, 0.01);
    // By turns.
    float pcf = lvsm_samplePcf(map4, filtering, uv, 3.5, depth, float2(0.01, -0.02), 0.001);
    float shadow = lvsm_sampleEsm(blurred4, terms4, filtering, uv, dx, dy, depth, esm.x, esm.y);
    if (group.x % 3u == 1u)
    {
        pcf = lvsm_samplePcf(map1, filtering, uv, 3.5, depth, float2(0.01, -0.02), 0.001);
        shadow = lvsm_sampleEsm(blurred1, terms1, filtering, uv, dx, dy, depth, esm.x, esm.y);
    }
    else if (group.x % 3u == 2u)
    {
        pcf = lvsm_samplePcf(map2, filtering, uv, 3.5, depth, float2(0.01, -0.02), 0.001);
        shadow = lvsm_sampleEsm(blurred2, terms2, filtering, uv, dx, dy, depth, esm.x, esm.y);
    }

    uint result = 21u * group.x;
    for (int t = 0; t < 4; ++t)
    {
        for (int c = 0; c < 4; ++c)
            outputs[result + uint(4 * t + c)] = texels[t][c];
    }
    outputs[result + 16u] = fraction.x;
    outputs[result + 17u] = fraction.y;
    outputs[result + 18u] = layered;
    outputs[result + 19u] = pcf;
    outputs[result + 20u] = shadow;
}
