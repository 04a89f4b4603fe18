// What the C++ snippets of the documents take as given: the names of a renderer around them.
#include <lvsm/lvsm.hpp>

#include <cstdio>
#include <vector>

extern std::vector<float> depths; // the light's depth image, width by height
extern int width, height;
extern float depth;                   // a receiver's
extern glm::vec2 moments;             // filtered, at its texel
glm::vec4 filteredTexel(int texture); // a filtered sample of two packed layers
