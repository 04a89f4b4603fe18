// Calls every wrapper for one receiver an invocation, as wrappers.glsl does; it stands behind lvsm_separate.wgsl. The
// receivers' inputs are a row each, the results a column each.
const RESULTS: i32 = 51;
alias Results = array<f32, RESULTS>;

@group(0) @binding(0) var receivers: texture_2d<f32>;
@group(0) @binding(1) var target_: texture_storage_2d<rgba32float, write>;
@group(0) @binding(3) var filtering: sampler;
@group(0) @binding(4) var map: texture_2d<f32>;
@group(0) @binding(5) var slices: texture_2d_array<f32>;
@group(0) @binding(6) var unfiltered: texture_2d_array<f32>;
@group(0) @binding(7) var greatest: texture_2d_array<f32>;

fn putFour(results: ptr<function, Results>, first: i32, value: vec4f)
{
    for (var c = 0; c < 4; c++)
    {
        (*results)[first + c] = value[c];
    }
}

// Point of the map whose first slice is the given one of the test's.
fn pointOf(inputs: array<vec4f, 4>, slice: i32) -> lvsm_MapPoint
{
    let dx = vec2f(inputs[0].w, 0.0);
    let dy = vec2f(0.0, inputs[0].w);
    if (inputs[2].z == 1.0)
    {
        return lvsm_mapPoint(inputs[0].xy, dx, dy, slice);
    }
    return lvsm_atlasPoint(inputs[0].xy, dx, dy, slice, inputs[2]);
}

fn callWrappers(inputs: array<vec4f, 4>, results: ptr<function, Results>)
{
    let depth = inputs[0].z;
    let gradient = vec2f(0.01, -0.02);
    var splits: array<f32, LVSM_MAX_LAYERS + 1>;
    for (var i = 0; i <= LVSM_MAX_LAYERS; i++)
    {
        splits[i] = min(0.25 * f32(i), 1.0);
    }
    let depths = pointOf(inputs, 0);
    let terms = pointOf(inputs, 3);

    let border = vec4f(1.0, 2.0, 3.0, 4.0);
    putFour(results, 0, lvsm_sampleMap(map, filtering, inputs[0].xy, depths.dx, depths.dy, border));
    putFour(results, 4, lvsm_sampleSlice(slices, filtering, depths, 1, border));
    putFour(results, 8, lvsm_gatherMap(map, filtering, inputs[0].xy, 5.0));
    putFour(results, 12, lvsm_gatherSlice(slices, filtering, depths, 1, 5.0));
    let fraction = lvsm_mapFraction(inputs[0].xy, vec2f(8.0, 8.0));
    (*results)[16] = fraction.x;
    (*results)[17] = fraction.y;
    putFour(results, 18, lvsm_fetchSlice(slices, filtering, depths, 1, floor(8.0 * inputs[0].xy)));
    (*results)[22] = lvsm_samplePcf(slices, filtering, depths, depth, gradient, 3.5, 0.0, 0.001);
    (*results)[23] = lvsm_samplePcf(slices, filtering, depths, depth, gradient, 3.5, 1.25, 0.001);
    (*results)[24] = lvsm_sampleEsm(slices, unfiltered, filtering, terms, depth, inputs[1].x, inputs[1].y);
    (*results)[25] = lvsm_sampleVariance(slices, filtering, pointOf(inputs, 4), depth, LVSM_MIN_VARIANCE_FP16);
    (*results)[26] = lvsm_sampleExponential2(slices, filtering, pointOf(inputs, 5), depth, 5.0, 0.0001);
    (*results)[27] = lvsm_samplePackedQuantised4(slices, filtering, pointOf(inputs, 19), depth);
    (*results)[28] = lvsm_sampleExponential4(slices, filtering, pointOf(inputs, 5), depth, vec2f(5.0, 4.0), 0.0001);
    (*results)[29] = lvsm_sampleMoments4(slices, filtering, pointOf(inputs, 6), depth, false, 0.001);
    (*results)[30] = lvsm_sampleMoments4(slices, filtering, pointOf(inputs, 7), depth, true, 0.001);
    (*results)[31] = lvsm_sampleLayeredMoments4(slices, filtering, pointOf(inputs, 8), depth, splits, 4, true, 0.001);
    (*results)[32] = lvsm_sampleTrigonometric(slices, filtering, pointOf(inputs, 12), depth, 0.001);
    (*results)[33] = lvsm_sampleBracketed2(slices, filtering, pointOf(inputs, 20), depth, 0.5, 0.0001);
    (*results)[34] = lvsm_sampleBracketed(slices, filtering, pointOf(inputs, 13), depth, splits, 4, false, 0.0001);
    (*results)[35] = lvsm_sampleBracketed(slices, filtering, pointOf(inputs, 15), depth, splits, 4, true, 0.0001);
    (*results)[36] = lvsm_samplePlane(slices, filtering, pointOf(inputs, 13), depth, gradient, splits, 4, false, 1.5, 0.0001,
                                      0.15);
    (*results)[37] = lvsm_samplePlane(slices, filtering, pointOf(inputs, 15), depth, 8.0 * gradient, splits, 4, true, 1.5,
                                      0.0001, 0.15);
    (*results)[38] = lvsm_sampleConvolution(slices, filtering, pointOf(inputs, 21), depth, 6, 0.08, 1.0, 1.0);
    (*results)[39] = lvsm_sampleQuantised4(slices, filtering, pointOf(inputs, 17), depth);
    (*results)[40] = lvsm_sampleLayers(slices, filtering, pointOf(inputs, 1), depth, splits, 4, 0.0625, 0.0625, 0.01);

    let direction = inputs[3].xyz;
    let face = lvsm_cubePoint(direction, vec3f(0.0, 0.02, 0.01), vec3f(0.03, 0.0, -0.01), 5, 2, inputs[3].w);
    putFour(results, 41, vec4f(face.uv, face.dx));
    (*results)[45] = face.dy.x;
    (*results)[46] = face.dy.y;
    (*results)[47] = f32(face.slice);
    (*results)[48] = lvsm_sampleSlice(slices, filtering, face, 0, vec4f(9.0, 9.0, 9.0, 9.0)).x;
    (*results)[49] = LVSM_MIN_VARIANCE;
    (*results)[50] = lvsm_sampleEsmZMax(slices, unfiltered, greatest, filtering, terms, depth, inputs[1].x,
                                        inputs[1].z);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u)
{
    let column = i32(id.x);
    if (column >= i32(textureDimensions(receivers).y))
    {
        return;
    }
    var inputs: array<vec4f, 4>;
    for (var i = 0; i < 4; i++)
    {
        inputs[i] = textureLoad(receivers, vec2i(i, column), 0);
    }
    var results: Results;
    callWrappers(inputs, &results);
    for (var row = 0; row < RESULTS; row++)
    {
        textureStore(target_, vec2i(column, row), vec4f(results[row]));
    }
}
