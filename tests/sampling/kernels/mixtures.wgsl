// Reads maps of mixtures for one receiver an invocation, from the whole map and from a rectangle of it. It stands behind
// lvsm_separate.wgsl.
@group(0) @binding(0) var receivers: texture_2d<f32>;
@group(0) @binding(1) var results: texture_storage_2d<rgba32float, write>;
@group(0) @binding(4) var two: texture_2d_array<u32>;
@group(0) @binding(5) var four: texture_2d_array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u)
{
    let row = i32(id.x);
    if (row >= i32(textureDimensions(receivers).y))
    {
        return;
    }
    let receiver = textureLoad(receivers, vec2i(0, row), 0);
    let plane = textureLoad(receivers, vec2i(1, row), 0);
    let none = vec2f(0.0, 0.0);
    let at = lvsm_mapPoint(receiver.xy, none, none, i32(plane.w));
    let inPart = lvsm_atlasPoint(receiver.xy, none, none, i32(plane.w), vec4f(0.25, 0.25, 0.5, 0.5));
    textureStore(results, vec2i(row, 0), vec4f(
        lvsm_sampleMixture2(two, at, receiver.z, plane.xy, receiver.w, plane.z),
        lvsm_sampleMixture4(four, at, receiver.z, plane.xy, receiver.w, plane.z),
        lvsm_sampleMixture2(two, inPart, receiver.z, plane.xy, receiver.w, plane.z),
        lvsm_sampleMixture4(four, inPart, receiver.z, plane.xy, receiver.w, plane.z)));
}
