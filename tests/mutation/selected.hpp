// Included before everything else in a build that holds all mutants at once: which of them this process runs.
#ifndef LVSM_TESTS_MUTATION_SELECTED_HPP
#define LVSM_TESTS_MUTATION_SELECTED_HPP

#include <cstdlib>

// For a mutant's own code: there is too much of it to optimise.
#ifdef __clang__
#define LVSM_PLAIN __attribute__((optnone, noinline))
#else
#define LVSM_PLAIN __attribute__((optimize("O0"), noinline))
#endif

// A function, because constants of the library may be initialised before any variable here.
inline int lvsmSelectedMutant()
{
    static const int selected = std::getenv("LVSM_MUTANT") != nullptr ? std::atoi(std::getenv("LVSM_MUTANT")) : -1;
    return selected;
}

static const int lvsmMutant = lvsmSelectedMutant();

#endif
