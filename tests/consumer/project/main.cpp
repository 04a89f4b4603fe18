// Uses the library, and opens the files named as arguments: those that the package's variables point at.
#include <lvsm/lvsm.hpp>

#include <cstdio>
#include <fstream>

int main(int argc, char** argv)
{
    // A planar occluder over half of the window, at depth 0.25; a receiver at 0.75: half lit.
    const glm::vec2 moments = 0.5f * (lvsm::depthMoments(0.25f) + lvsm::depthMoments(0.75f));
    const float visibility = lvsm::chebyshevUpperBound(moments, 0.75f, 0.0f);
    std::printf("visibility %g\n", static_cast<double>(visibility));

    bool ok = visibility > 0.499f && visibility < 0.501f;
    for (int i = 1; i < argc; ++i)
    {
        if (!std::ifstream(argv[i]))
        {
            std::printf("cannot open %s\n", argv[i]);
            ok = false;
        }
    }
    return ok ? 0 : 1;
}
