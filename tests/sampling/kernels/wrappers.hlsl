// Calls every wrapper for one receiver a thread.
#include "lvsm/sampling/separate.hlsli"

// uv, depth, change of the coordinates to the next pixel
StructuredBuffer<float4> inputs : register(t0);
RWStructuredBuffer<float> outputs : register(u1);
Texture2D<float4> map : register(t2);
Texture2DArray<float4> layers : register(t3);
Texture2D<float4> terms : register(t4);
SamplerState filtering : register(s5);

[numthreads(1, 1, 1)]
void main(uint3 group : SV_GroupID)
{
    float4 receiver = inputs[group.x];
    float2 uv = receiver.xy;
    float depth = receiver.z;
    float2 dx = float2(receiver.w, 0.0);
    float2 dy = float2(0.0, receiver.w);
    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = min(0.25 * float(i), 1.0);

    float4 border = float4(1.0, 2.0, 3.0, 4.0);
    float4 texels[4];
    texels[0] = lvsm_sampleMap(map, filtering, uv, dx, dy, border);
    texels[1] = lvsm_sampleMapArray(layers, filtering, uv, 1, dx, dy, border);
    texels[2] = lvsm_gatherMap(map, filtering, uv, 5.0);
    texels[3] = lvsm_gatherMapArray(layers, filtering, uv, 1, 5.0);
    uint result = 21u * group.x;
    for (int t = 0; t < 4; ++t)
    {
        for (int c = 0; c < 4; ++c)
            outputs[result + uint(4 * t + c)] = texels[t][c];
    }
    float2 fraction = lvsm_mapFraction(uv, float2(8.0, 8.0));
    outputs[result + 16u] = fraction.x;
    outputs[result + 17u] = fraction.y;
    outputs[result + 18u] =
        lvsm_sampleLayers(layers, filtering, uv, dx, dy, depth, splits, 4, 0.0625, 0.0625, 0.01);
    outputs[result + 19u] = lvsm_samplePcf(map, filtering, uv, 3.5, depth, float2(0.01, -0.02), 0.001);
    outputs[result + 20u] = lvsm_sampleEsm(terms, filtering, uv, dx, dy, depth, 20.0, 0.02);
}
