// The one filter kernel of the gallery: binomial weights of 9 texels, in each direction.
const int RADIUS = 4;
const float WEIGHTS[2 * RADIUS + 1] = float[](1.0 / 256.0, 8.0 / 256.0, 28.0 / 256.0, 56.0 / 256.0, 70.0 / 256.0,
                                              56.0 / 256.0, 28.0 / 256.0, 8.0 / 256.0, 1.0 / 256.0);
