// Calls every wrapper for one receiver a thread, with maps of COMPONENTS components; 1, 2 or 4.
#include "lvsm/sampling/separate.hlsli"

#ifndef COMPONENTS
#define COMPONENTS 4
#endif
#if COMPONENTS == 1
#define TEXEL float
#elif COMPONENTS == 2
#define TEXEL float2
#else
#define TEXEL float4
#endif
StructuredBuffer<float4> receivers : register(t0);
RWStructuredBuffer<float> outputs : register(u1);
Texture2D<TEXEL> map : register(t2);
Texture2DArray<TEXEL> slices : register(t3);
Texture2DArray<TEXEL> unfiltered : register(t4);
Texture2DArray<TEXEL> greatest : register(t5);
SamplerState filtering : register(s6);
#define MAP map, filtering
#define SLICES slices, filtering
#define ESM slices, unfiltered, filtering
#define ZMAX slices, unfiltered, greatest, filtering
// The calls are written in GLSL.
#define vec2 float2
#define vec3 float3
#define vec4 float4
#include "wrappers.glsl"

[numthreads(1, 1, 1)]
void main(uint3 group : SV_GroupID)
{
    float4 inputs[4];
    for (int i = 0; i < 4; ++i)
        inputs[i] = receivers[4u * group.x + uint(i)];
    float results[RESULTS];
    callWrappers(inputs, results);
    for (int k = 0; k < RESULTS; ++k)
        outputs[uint(RESULTS) * group.x + uint(k)] = results[k];
}
