// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: no other.
// One level of maps of 1 to 4 components from the level before: entry points lvsm_mipCompute and lvsm_mipPixel.
//
// Each texel is the mean of its share of the level before: of two texels in each direction, and where that level has an
// odd size of three, the outer ones in part. So every level has the map's mean, the last row is not left out, and
// nothing off the map is read, such as its neighbour in an atlas; what is off the map is empty for whoever samples the
// level, see sampling/common.hlsli. Moments are added as 32-bit floats, whatever the driver's own levels do.
//
// Run it for each level from 1 on with what mipPass of include/lvsm/passes_mip.hpp gives: the constant buffer, and either
// how many groups of 8 x 8 texels and one slice lvsm_mipCompute runs over, or the rectangle of the level over which to
// draw lvsm_mipPixel, for one slice. In Vulkan, LVSM_MIP_FORMAT may name the target's format, such as "rgba16f".

// Where the resources are: define all of these or none, in front of this file. The numbers differ, so that they serve as
// Vulkan's bindings too.
#if defined(LVSM_MIP_SOURCE) && defined(LVSM_MIP_TARGET) && defined(LVSM_MIP_BLOCK)
#elif defined(LVSM_MIP_SOURCE) || defined(LVSM_MIP_TARGET) || defined(LVSM_MIP_BLOCK)
#error define all of LVSM_MIP_SOURCE, LVSM_MIP_TARGET and LVSM_MIP_BLOCK, or none
#else
#define LVSM_MIP_SOURCE t0
#define LVSM_MIP_TARGET u1
#define LVSM_MIP_BLOCK b2
#endif

Texture2DArray<float4> lvsm_source : register(LVSM_MIP_SOURCE);
#ifdef LVSM_MIP_FORMAT
[[vk::image_format(LVSM_MIP_FORMAT)]]
#endif
RWTexture2DArray<float4> lvsm_target : register(LVSM_MIP_TARGET);
// MipBlock of include/lvsm/passes_mip.hpp.
cbuffer lvsm_Mip : register(LVSM_MIP_BLOCK)
{
    // First texel and end of the map in the level before.
    int4 lvsm_before;
    // The same in the level that is made.
    int4 lvsm_region;
    // The slice that is made; for the compute shader the first one.
    int lvsm_slice;
    // The level before, as the source has it: 0 where the source is a view of that level alone.
    int lvsm_level;
};

// First texel and end of what a texel is the mean of, in units that whole numbers hold: m to a texel of the n before.
int2 lvsm_mipCell(int texel, int n)
{
    return int2(texel, texel + 1) * n;
}

// How much of a texel of the level before lies in a cell, in those units.
int lvsm_mipShare(int texel, int2 cell, int m)
{
    return min((texel + 1) * m, cell.y) - max(texel * m, cell.x);
}

// Where LVSM_MIP_MAXIMUM is defined, a texel is the largest of its share, each component for itself, as the Z-Max test
// of ESM needs.
float4 lvsm_mipTexel(int3 texel)
{
    int2 n = lvsm_before.zw - lvsm_before.xy;
    int2 m = max(lvsm_region.zw - lvsm_region.xy, 1);
    int2 own = texel.xy - lvsm_region.xy;
    int2 across = lvsm_mipCell(own.x, n.x);
    int2 down = lvsm_mipCell(own.y, n.y);
    int2 first = int2(across.x, down.x) / m;
    int2 last = (int2(across.y, down.y) - 1) / m;
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    for (int y = first.y; y <= last.y; ++y)
    {
        for (int x = first.x; x <= last.x; ++x)
        {
            float4 found = lvsm_source.Load(int4(lvsm_before.xy + int2(x, y), texel.z, lvsm_level));
#ifdef LVSM_MIP_MAXIMUM
            sum = x == first.x && y == first.y ? found : max(sum, found);
#else
            float2 share = float2(int2(lvsm_mipShare(x, across, m.x), lvsm_mipShare(y, down, m.y))) / float2(n);
            sum += share.x * share.y * found;
#endif
        }
    }
    return sum;
}

[numthreads(8, 8, 1)]
void lvsm_mipCompute(uint3 id : SV_DispatchThreadID)
{
    int3 texel = int3(id) + int3(lvsm_region.xy, lvsm_slice);
    if (texel.x < lvsm_region.z && texel.y < lvsm_region.w)
        lvsm_target[uint3(texel)] = lvsm_mipTexel(texel);
}

float4 lvsm_mipPixel(float4 position : SV_Position) : SV_Target
{
    return lvsm_mipTexel(int3(int2(position.xy), lvsm_slice));
}
