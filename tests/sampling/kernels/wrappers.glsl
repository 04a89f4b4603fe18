// Calls every wrapper for one receiver, in GLSL and HLSL. MAP, SLICES, ESM and ZMAX are the maps as a wrapper takes them;
// COMPONENTS is how many they have, since HLSL's types say it, and 4 elsewhere.
// inputs: uv, depth, change of the coordinates to the next pixel; exponent, threshold and offset of ESM; the
// rectangle; a direction and the tangent of a cube's face.
#define RESULTS 51

void putFour(inout float results[RESULTS], int first, vec4 value)
{
    for (int c = 0; c < 4; ++c)
        results[first + c] = value[c];
}

// Point of the map whose first slice is the given one of the test's.
lvsm_MapPoint pointOf(vec4 inputs[4], int slice)
{
    vec2 dx = vec2(inputs[0].w, 0.0);
    vec2 dy = vec2(0.0, inputs[0].w);
    if (inputs[2].z == 1.0)
        return lvsm_mapPoint(inputs[0].xy, dx, dy, slice);
    return lvsm_atlasPoint(inputs[0].xy, dx, dy, slice, inputs[2]);
}

void callWrappers(vec4 inputs[4], out float results[RESULTS])
{
    for (int r = 0; r < RESULTS; ++r)
        results[r] = 0.0;
    float depth = inputs[0].z;
    vec2 gradient = vec2(0.01, -0.02);
    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = min(0.25 * float(i), 1.0);
    lvsm_MapPoint depths = pointOf(inputs, 0);
    lvsm_MapPoint terms = pointOf(inputs, 3);

    vec4 border = vec4(1.0, 2.0, 3.0, 4.0);
    putFour(results, 0, lvsm_sampleMap(MAP, inputs[0].xy, depths.dx, depths.dy, border));
    putFour(results, 4, lvsm_sampleSlice(SLICES, depths, 1, border));
    putFour(results, 8, lvsm_gatherMap(MAP, inputs[0].xy, 5.0));
    putFour(results, 12, lvsm_gatherSlice(SLICES, depths, 1, 5.0));
    vec2 fraction = lvsm_mapFraction(inputs[0].xy, vec2(8.0, 8.0));
    results[16] = fraction.x;
    results[17] = fraction.y;
    putFour(results, 18, lvsm_fetchSlice(SLICES, depths, 1, floor(8.0 * inputs[0].xy)));
    results[22] = lvsm_samplePcf(SLICES, depths, depth, gradient, 3.5, 0.0, 0.001);
    results[23] = lvsm_samplePcf(SLICES, depths, depth, gradient, 3.5, 1.25, 0.001);
    results[24] = lvsm_sampleEsm(ESM, terms, depth, inputs[1].x, inputs[1].y);
#if COMPONENTS >= 2
    results[25] = lvsm_sampleVariance(SLICES, pointOf(inputs, 4), depth, LVSM_MIN_VARIANCE_FP16);
    results[26] = lvsm_sampleExponential2(SLICES, pointOf(inputs, 5), depth, 5.0, 0.0001);
    results[27] = lvsm_samplePackedQuantised4(SLICES, pointOf(inputs, 19), depth);
#endif
#if COMPONENTS >= 4
    results[28] = lvsm_sampleExponential4(SLICES, pointOf(inputs, 5), depth, vec2(5.0, 4.0), 0.0001);
    results[29] = lvsm_sampleMoments4(SLICES, pointOf(inputs, 6), depth, false, 0.001);
    results[30] = lvsm_sampleMoments4(SLICES, pointOf(inputs, 7), depth, true, 0.001);
    results[31] = lvsm_sampleLayeredMoments4(SLICES, pointOf(inputs, 8), depth, splits, 4, true, 0.001);
    results[32] = lvsm_sampleTrigonometric(SLICES, pointOf(inputs, 12), depth, 0.001);
    results[33] = lvsm_sampleBracketed2(SLICES, pointOf(inputs, 20), depth, 0.5, 0.0001);
    results[34] = lvsm_sampleBracketed(SLICES, pointOf(inputs, 13), depth, splits, 4, false, 0.0001);
    results[35] = lvsm_sampleBracketed(SLICES, pointOf(inputs, 15), depth, splits, 4, true, 0.0001);
    results[36] = lvsm_samplePlane(SLICES, pointOf(inputs, 13), depth, gradient, splits, 4, false, 1.5, 0.0001, 0.15);
    results[37] = lvsm_samplePlane(SLICES, pointOf(inputs, 15), depth, 8.0 * gradient, splits, 4, true, 1.5, 0.0001, 0.15);
    results[38] = lvsm_sampleConvolution(SLICES, pointOf(inputs, 21), depth, 6, 0.08, 1.0, 1.0);
    results[39] = lvsm_sampleQuantised4(SLICES, pointOf(inputs, 17), depth);
    results[40] = lvsm_sampleLayers(SLICES, pointOf(inputs, 1), depth, splits, 4, 0.0625, 0.0625, 0.01);
#endif

    vec3 direction = inputs[3].xyz;
    lvsm_MapPoint face = lvsm_cubePoint(direction, vec3(0.0, 0.02, 0.01), vec3(0.03, 0.0, -0.01), 5, 2, inputs[3].w);
    putFour(results, 41, vec4(face.uv, face.dx));
    results[45] = face.dy.x;
    results[46] = face.dy.y;
    results[47] = float(face.slice);
    results[48] = lvsm_sampleSlice(SLICES, face, 0, vec4(9.0, 9.0, 9.0, 9.0)).x;
    results[49] = LVSM_MIN_VARIANCE;
    results[50] = lvsm_sampleEsmZMax(ZMAX, terms, depth, inputs[1].x, inputs[1].z);
}
