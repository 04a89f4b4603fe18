// What RADV, Mesa's driver for AMD GPUs, makes of a compute shader. No GPU is needed: it can be told which to assume.
#ifndef LVSM_COST_RADV_HPP
#define LVSM_COST_RADV_HPP

#include <result.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cost
{

struct Statistics
{
    int instructions;
    // The compiler's estimate of the cycles that the busiest unit needs for one wave.
    int inverseThroughput;
    // Vector registers of a wave.
    int registers;
};

class Radv
{
public:
    // target: a family that RADV_FORCE_FAMILY takes, such as GFX1100. Fails where RADV is not installed.
    static lvsm::support::Result<Radv> open(const std::string& target);

    Radv(Radv&&) noexcept;
    ~Radv();

    // Version of the driver, and so of the compiler: its figures compare only with its own.
    std::string version() const;

    // The shader may use, at bindings 0 to 5 of set 0, two storage buffers, a texture with its sampler, a storage image
    // and two uniform buffers, and 64 bytes of push constants.
    lvsm::support::Result<Statistics> compile(const std::vector<std::uint32_t>& spirv) const;

private:
    struct State;
    explicit Radv(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace cost

#endif
