// The levels of a map by the mip pass, against means of cells worked out in double.
#ifndef LVSM_SAMPLING_LEVELS_TRUTH_HPP
#define LVSM_SAMPLING_LEVELS_TRUTH_HPP

#include "checks.hpp"

#include <lvsm/lvsm.hpp>

namespace sampling
{

constexpr Shape kLevelsTexture{48, 32, 2, 6};

Pixels randomLevels();

struct Levels
{
    std::string name;
    lvsm::Rectangle map;
    bool maximum;

    int count() const;
};

// A whole map, one of odd sizes in an atlas, and the largest of its texels.
std::vector<Levels> levelsOfTest();

// Every level from the one before as it is, which the test can read. isAlone: whether the pass writes the map alone, and
// not all of the level.
bool compareLevels(const std::string& what, const Levels& levels, const Pixels& made, bool isAlone);

} // namespace sampling

#endif
