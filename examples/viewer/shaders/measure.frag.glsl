// Squared error of a block of pixels, and what there is of weight in it. A pixel counts by the light that arrives there.
uniform highp sampler2D arriving;
uniform highp sampler2D exact;
uniform highp sampler2D judged;
layout(location = 0) out vec4 sums;

void main()
{
    ivec2 size = textureSize(judged, 0);
    sums = vec4(0.0);
    for (int i = 0; i < BLOCK * BLOCK; ++i)
    {
        ivec2 pixel = BLOCK * ivec2(gl_FragCoord.xy) + ivec2(i % BLOCK, i / BLOCK);
        if (any(greaterThanEqual(pixel, size)))
            continue;
        vec2 light = texelFetch(arriving, pixel, 0).xy;
        float weight = light.x * light.y;
        float error = texelFetch(judged, pixel, 0).x - texelFetch(exact, pixel, 0).x;
        // What is no number is as wrong as can be.
        error = abs(error) <= 1.0 ? error : 1.0;
        sums += weight * vec4(1.0, error * error, max(error, 0.0), max(-error, 0.0));
    }
}
