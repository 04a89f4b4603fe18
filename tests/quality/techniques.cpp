#include "techniques.hpp"

namespace lvsm::quality
{

std::vector<Technique> allTechniques()
{
    std::vector<Technique> all;
    for (const auto& part : {varianceTechniques(), otherPeers(), pcfPeers(), momentTechniques(), layeredTechniques(),
                             mixtureTechniques(), limits()})
    {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

} // namespace lvsm::quality
