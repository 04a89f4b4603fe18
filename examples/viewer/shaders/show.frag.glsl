// The picture: one of the views of what both sides judged, divided.
uniform sampler2D colours;
uniform highp sampler2D arriving;
uniform highp sampler2D left;
uniform highp sampler2D right;
uniform highp sampler2D exact;
uniform int view;
uniform float divider; // in pixels
uniform vec3 background;
layout(location = 0) out vec4 result;

const vec3 UNLIT = vec3(0.36, 0.42, 0.52);

vec3 encoded(vec3 linear)
{
    return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, vec3(lessThan(linear, vec3(0.0031308))));
}

// Blue where it is too dark, orange where too light, white where right; lightness alone tells how much.
vec3 errorColour(float error)
{
    float size = min(abs(error) / 0.5, 1.0);
    vec3 end = error > 0.0 ? vec3(0.70, 0.35, 0.02) : vec3(0.13, 0.25, 0.60);
    vec3 middle = error > 0.0 ? vec3(0.99, 0.72, 0.39) : vec3(0.57, 0.77, 0.87);
    return size < 0.5 ? mix(vec3(0.97), middle, 2.0 * size) : mix(middle, end, 2.0 * size - 1.0);
}

// Dark blue over green to yellow, whose lightness rises all the way.
vec3 rampColour(float value)
{
    const vec3 stops[5] = vec3[](vec3(0.27, 0.00, 0.33), vec3(0.23, 0.32, 0.55), vec3(0.13, 0.57, 0.55),
                                 vec3(0.37, 0.79, 0.38), vec3(0.99, 0.91, 0.14));
    float at = 4.0 * clamp(value, 0.0, 1.0);
    int first = min(int(at), 3);
    return mix(stops[first], stops[first + 1], at - float(first));
}

// The eight colours of Okabe and Ito, the two darkest lightened.
vec3 layerColour(int layer)
{
    const vec3 palette[8] = vec3[](vec3(0.90, 0.62, 0.00), vec3(0.34, 0.71, 0.91), vec3(0.00, 0.62, 0.45),
                                   vec3(0.94, 0.89, 0.26), vec3(0.15, 0.50, 0.80), vec3(0.84, 0.37, 0.00),
                                   vec3(0.80, 0.47, 0.65), vec3(0.75, 0.75, 0.75));
    return palette[layer & 7];
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 surface = texelFetch(colours, pixel, 0);
    vec2 light = texelFetch(arriving, pixel, 0).xy;
    vec4 judged = float(pixel.x) < divider ? texelFetch(left, pixel, 0) : texelFetch(right, pixel, 0);
    vec3 shaded = surface.rgb * (0.16 + 0.95 * light.x * judged.x);
    bool isLit = light.y > 0.0;
    vec3 colour = encoded(clamp(shaded, 0.0, 1.0));
    if (view == 1)
        colour = isLit ? vec3(judged.x) : UNLIT;
    if (view == 2)
        colour = isLit ? errorColour(judged.x - texelFetch(exact, pixel, 0).x) : UNLIT;
    if (view == 3)
        colour = judged.y < 0.0 ? UNLIT : layerColour(int(judged.y + 0.5)) * (0.45 + 0.55 * (isLit ? judged.x : 0.0));
    if (view == 4)
        colour = judged.y < 0.0 ? UNLIT : rampColour(judged.z);
    if (view == 5)
        colour = judged.y < 0.0 ? UNLIT : rampColour(4.0 * judged.w);
    result = vec4(surface.a > 0.0 ? colour : background, 1.0);
}
