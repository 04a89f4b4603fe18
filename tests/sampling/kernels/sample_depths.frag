#version 450
// A depth for each sample of each texel, all different from their neighbours'.
void main()
{
    int number = int(gl_FragCoord.x) * 7 + int(gl_FragCoord.y) * 13 + gl_SampleID * 29;
    gl_FragDepth = (float(number % 64) + 0.5) / 64.0;
}
