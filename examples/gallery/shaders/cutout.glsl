// The alpha test of a leaf: `place` goes from -1 to 1 along it and across it, and is 0 on all that is solid.
bool isCutOut(vec2 place)
{
    float width = 1.0 - place.x * place.x;
    float serration = 0.12 * abs(fract(7.0 * place.x) - 0.5);
    return abs(place.y) > width * (1.0 - serration) && place != vec2(0.0);
}
