// Percentage-closer filtering: the depth comparison first, the filter after it.
// Reeves, Salesin & Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987.
//
// A filter of N x N texels: start from (0, 0), pcfAdd the texels four at a time with the weights of the filter topic
// (a Gaussian's, or boxWeight of each texel's offset for a box of any width), and end with pcfVisibility.
#ifndef LVSM_PCF_HLSLI
#define LVSM_PCF_HLSLI

#include "filter.hlsli"

/// Plain shadow test of one texel.
/// occluder: depth in the map. depth: the receiver's, clamped to [0,1]. bias: what the receiver is moved towards the
/// light, clamped to [-1,1]. Result: 1 where the receiver is not behind the occluder, else 0.
/// Source: Williams, Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978.
float lvsm_depthTest(float occluder, float depth, float bias)
{
    return clamp(depth, 0.0, 1.0) - clamp(bias, -1.0, 1.0) <= occluder ? 1.0 : 0.0;
}

/// Percentage-closer filtering over 2 x 2 texels, continuous in the receiver's position.
/// depths: of the texels (0,0), (1,0), (0,1) and (1,1), which is a gather's .wzxy. fraction: position between the
/// centres of the first and the last, each component clamped to [0,1]. depth: the receiver's, clamped to [0,1].
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result in [0,1].
/// Source: Reeves et al. 1987, with bilinear weights.
float lvsm_pcfBilinear(float4 depths, float2 fraction, float depth, float bias)
{
    return lvsm_bilinearVisibility(float4(lvsm_depthTest(depths.x, depth, bias), lvsm_depthTest(depths.y, depth, bias),
                                        lvsm_depthTest(depths.z, depth, bias), lvsm_depthTest(depths.w, depth, bias)),
                                   fraction);
}

/// Four more texels of a percentage-closer filter of any shape and size.
/// sum: (weight that is lit, weight of all) so far, (0, 0) at first, each clamped to [0, 2^125].
/// depths: of four texels. weights: theirs in the same order, each clamped to [0, 2^122].
/// depth: the receiver's, clamped to [0,1].
/// bias: what the receiver is moved towards the light, clamped to [-1,1]. Result: both sums, in [0, 2^126].
/// Source: Reeves et al. 1987.
float2 lvsm_pcfAdd(float2 sum, float4 depths, float4 weights, float depth, float bias)
{
    float2 s = clamp(sum, 0.0, 0.5 * LVSM_HUGE);
    float4 w = clamp(weights, 0.0, 0.0625 * LVSM_HUGE);
    float4 lit = w * float4(lvsm_depthTest(depths.x, depth, bias), lvsm_depthTest(depths.y, depth, bias),
                        lvsm_depthTest(depths.z, depth, bias), lvsm_depthTest(depths.w, depth, bias));
    return s + float2(lit.x + lit.y + lit.z + lit.w, w.x + w.y + w.z + w.w);
}

/// Visibility from the sums of pcfAdd.
/// sum: (weight that is lit, weight of all). Result in [0,1]: their ratio.
/// Degenerate: no weight at all (under 2^-126) is lit.
/// Source: Reeves et al. 1987.
float lvsm_pcfVisibility(float2 sum)
{
    float all = min(sum.y, LVSM_HUGE);
    return all < LVSM_TINY ? 1.0 : clamp(sum.x / all, 0.0, 1.0);
}

/// Change of the receiver's depth with the map's texture coordinates, from screen derivatives.
/// dx, dy: change of (u, v, depth) to the next pixel in x and in y, each component clamped to [-1e15, 1e15].
/// Result: (d depth / du, d depth / dv), each in [-2^20, 2^20].
/// Degenerate: a receiver seen edge-on from the light (determinant under 2^-126) gives (0, 0).
/// Source: Isidoro, Shadow Mapping: GPU-based Tips and Techniques, GDC 2006; the chain rule solved for the gradient.
float2 lvsm_receiverPlaneGradient(float3 dx, float3 dy)
{
    float3 a = clamp(dx, -1.0e15, 1.0e15);
    float3 b = clamp(dy, -1.0e15, 1.0e15);
    float determinant = a.x * b.y - a.y * b.x;
    float size = abs(determinant);
    if (size < LVSM_TINY)
        return float2(0.0, 0.0);
    float limit = 1048576.0 * size;
    float alongU = clamp(a.z * b.y - a.y * b.z, -limit, limit);
    float alongV = clamp(a.x * b.z - a.z * b.x, -limit, limit);
    return clamp(float2(alongU, alongV) / determinant, -1048576.0, 1048576.0);
}

/// Change of the receiver's depth from its own position in the map to a texel: what to add to depth for that tap.
/// gradient: of receiverPlaneGradient. offset: from the receiver's texture coordinates to the texel's centre.
/// Components of either are clamped to [-2^20, 2^20]. Result in [-1,1].
/// Source: Isidoro 2006, the receiver's plane extrapolated.
float lvsm_receiverPlaneBias(float2 gradient, float2 offset)
{
    float2 g = clamp(gradient, -1048576.0, 1048576.0);
    float2 o = clamp(offset, -1048576.0, 1048576.0);
    return clamp(g.x * o.x + g.y * o.y, -1.0, 1.0);
}

#endif
