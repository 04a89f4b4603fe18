#include "techniques.hpp"

#include <stdexcept>

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

Technique techniqueNamed(const std::string& name)
{
    for (const Technique& technique : allTechniques())
    {
        if (technique.name == name)
            return technique;
    }
    throw std::out_of_range("no technique " + name);
}

} // namespace lvsm::quality
