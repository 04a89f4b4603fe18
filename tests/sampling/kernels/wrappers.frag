// Calls every wrapper, for the receiver that the target's column counts and with the result that its row counts. It
// stands behind a #version, in ES the preamble, and the one-file wrappers.
uniform highp sampler2D receivers;
uniform highp sampler2D map;
uniform highp sampler2DArray slices;
uniform highp sampler2DArray unfiltered;
uniform highp sampler2DArray greatest;
layout(location = 0) out vec4 result;

#define COMPONENTS 4
#define MAP map
#define SLICES slices
#define ESM slices, unfiltered
#define ZMAX slices, unfiltered, greatest
CALL_WRAPPERS

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 inputs[4];
    for (int i = 0; i < 4; ++i)
        inputs[i] = texelFetch(receivers, ivec2(i, at.x), 0);
    float results[RESULTS];
    callWrappers(inputs, results);
    result = vec4(results[at.y], 0.0, 0.0, 1.0);
}
