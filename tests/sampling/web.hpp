// What lvsm_web checks: the wrappers and passes, each by a script that a client plays.
#ifndef LVSM_SAMPLING_WEB_HPP
#define LVSM_SAMPLING_WEB_HPP

#include "opengl.hpp"
#include "steps_truth.hpp"
#include "web_script.hpp"
#include "wrappers_truth.hpp"

namespace sampling
{

// What a user writes into a pass: macros in front of GLSL, and lines of WGSL in another's place.
struct Settings
{
    std::string macros;
    std::vector<std::pair<std::string, std::string>> lines;
};

class Web
{
public:
    Web(WebScript& script, Options options) : m_script(script), m_options(std::move(options)) {}

    int pass(const std::string& name, const std::string& entry, const Settings& settings = {});

    bool checkWrappersOf(const Place& place, const std::vector<Receiver>& receivers, bool isCube);
    bool checkMixtureWrappers();
    bool checkBlurs();
    bool checkStores();
    bool checkDepths();
    bool checkLevels();
    // WGSL alone: it takes compute shaders.
    bool checkFused();
    bool checkPlacing();
    bool checkSteps(const Depths& image, bool inPairs);

private:
    std::string kernelText(const std::string& name) const;
    int receivers(const std::vector<glm::vec4>& inputs, int perReceiver);
    std::vector<State> drawSteps(const Depths& image, bool inPairs);
    lvsm::PlaceStep step(int frame, bool inPairs, const lvsm::RelaxOptions<float>& options) const;

    WebScript& m_script;
    Options m_options;
};

// The target's format of this test in place of the pass's own.
std::pair<std::string, std::string> wide(const std::string& alias);

} // namespace sampling

#endif
