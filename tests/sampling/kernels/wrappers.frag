// Calls every wrapper, for the receiver that the target's column counts and with the result that its row counts. It
// stands behind a #version, in ES the preamble, and the one-file wrappers.
uniform highp sampler2D receivers;
uniform highp sampler2D map;
uniform highp sampler2DArray layers;
uniform highp sampler2D terms;
uniform highp sampler2D blurred;
layout(location = 0) out vec4 result;

#define MAP map
#define LAYERS layers
#define ESM blurred, terms
CALL_WRAPPERS

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    float results[21];
    callWrappers(texelFetch(receivers, ivec2(0, at.x), 0), texelFetch(receivers, ivec2(1, at.x), 0), results);
    result = vec4(results[at.y], 0.0, 0.0, 1.0);
}
