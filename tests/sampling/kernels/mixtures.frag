// Reads maps of mixtures for the receiver that the target's column counts, from the whole map and from a rectangle of it.
// It stands behind a #version, in ES the preamble, and the one-file wrappers.
uniform highp sampler2D receivers;
uniform highp usampler2DArray two;
uniform highp usampler2DArray four;
layout(location = 0) out vec4 result;

void main()
{
    int row = int(gl_FragCoord.x);
    vec4 receiver = texelFetch(receivers, ivec2(0, row), 0);
    vec4 plane = texelFetch(receivers, ivec2(1, row), 0);
    vec2 none = vec2(0.0, 0.0);
    lvsm_MapPoint at = lvsm_mapPoint(receiver.xy, none, none, int(plane.w));
    lvsm_MapPoint inPart = lvsm_atlasPoint(receiver.xy, none, none, int(plane.w), vec4(0.25, 0.25, 0.5, 0.5));
    result = vec4(lvsm_sampleMixture2(two, at, receiver.z, plane.xy, receiver.w, plane.z),
                  lvsm_sampleMixture4(four, at, receiver.z, plane.xy, receiver.w, plane.z),
                  lvsm_sampleMixture2(two, inPart, receiver.z, plane.xy, receiver.w, plane.z),
                  lvsm_sampleMixture4(four, inPart, receiver.z, plane.xy, receiver.w, plane.z));
}
