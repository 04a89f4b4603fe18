// Runs WGSL by the command tests/support/wgsl.
#ifndef LVSM_PARITY_WGPU_HPP
#define LVSM_PARITY_WGPU_HPP

#include "inputs.hpp"

#include <result.hpp>

#include <map>
#include <string>
#include <vector>

namespace parity
{

// The results by name of the device, `numbers` of each; without those devices that are not there, and empty where the
// command cannot be had. The command prints its own log.
lvsm::support::Result<std::map<std::string, std::vector<float>>>
runWithWgpu(const std::string& command, const std::string& kernel, const std::vector<Words>& inputs,
            std::size_t numbers, const std::vector<std::string>& devices);

} // namespace parity

#endif
