// Reads maps of mixtures for one receiver a thread: the whole map, and a rectangle of it.
#include "lvsm/sampling/separate.hlsli"

// Two for a receiver: uv, depth and texels; gradient, deviation and slice.
StructuredBuffer<float4> inputs : register(t0);
RWStructuredBuffer<float4> outputs : register(u1);
Texture2DArray<uint2> two : register(t2);
Texture2DArray<uint4> four : register(t3);

[numthreads(1, 1, 1)]
void main(uint3 group : SV_GroupID)
{
    float4 receiver = inputs[2u * group.x];
    float4 plane = inputs[2u * group.x + 1u];
    float2 none = float2(0.0, 0.0);
    lvsm_MapPoint at = lvsm_mapPoint(receiver.xy, none, none, int(plane.w));
    lvsm_MapPoint inPart = lvsm_atlasPoint(receiver.xy, none, none, int(plane.w), float4(0.25, 0.25, 0.5, 0.5));
    outputs[group.x] = float4(lvsm_sampleMixture2(two, at, receiver.z, plane.xy, receiver.w, plane.z),
                              lvsm_sampleMixture4(four, at, receiver.z, plane.xy, receiver.w, plane.z),
                              lvsm_sampleMixture2(two, inPart, receiver.z, plane.xy, receiver.w, plane.z),
                              lvsm_sampleMixture4(four, inPart, receiver.z, plane.xy, receiver.w, plane.z));
}
