// Calls every wrapper for one receiver. MAP, LAYERS and ESM are the maps as a wrapper takes them.
// receiver: uv, depth, change of the coordinates to the next pixel. settings: exponent and threshold of ESM.
void callWrappers(vec4 receiver, vec4 settings, out float results[21])
{
    vec2 uv = receiver.xy;
    float depth = receiver.z;
    vec2 dx = vec2(receiver.w, 0.0);
    vec2 dy = vec2(0.0, receiver.w);
    float splits[LVSM_MAX_LAYERS + 1];
    for (int i = 0; i <= LVSM_MAX_LAYERS; ++i)
        splits[i] = min(0.25 * float(i), 1.0);

    vec4 border = vec4(1.0, 2.0, 3.0, 4.0);
    vec4 texels[4];
    texels[0] = lvsm_sampleMap(MAP, uv, dx, dy, border);
    texels[1] = lvsm_sampleMapArray(LAYERS, uv, 1, dx, dy, border);
    texels[2] = lvsm_gatherMap(MAP, uv, 5.0);
    texels[3] = lvsm_gatherMapArray(LAYERS, uv, 1, 5.0);
    for (int t = 0; t < 4; ++t)
    {
        for (int c = 0; c < 4; ++c)
            results[4 * t + c] = texels[t][c];
    }
    vec2 fraction = lvsm_mapFraction(uv, vec2(8.0, 8.0));
    results[16] = fraction.x;
    results[17] = fraction.y;
    results[18] = lvsm_sampleLayers(LAYERS, uv, dx, dy, depth, splits, 4, 0.0625, 0.0625, 0.01);
    results[19] = lvsm_samplePcf(MAP, uv, 3.5, depth, vec2(0.01, -0.02), 0.001);
    results[20] = lvsm_sampleEsm(ESM, uv, dx, dy, depth, settings.x, settings.y);
}
