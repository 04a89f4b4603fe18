#include "techniques.hpp"

namespace lvsm::quality
{

Technique fourTaps(Technique technique)
{
    technique.name += ", 4 taps";
    technique.taps = 4;
    return technique;
}

std::vector<Technique> allTechniques()
{
    std::vector<Technique> all;
    for (const auto& part : {varianceTechniques(), otherPeers(), momentTechniques(), layeredTechniques(), limits()})
    {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

} // namespace lvsm::quality
