// lvsm_web: what a client without C++ runs of the sampling wrappers and the ready passes, and whether its answers are right.
//   lvsm_web write|judge glsl|wgsl FOLDER --single DIR --kernels DIR
#include "web.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace
{

using namespace lvsm::support;
using namespace sampling;

bool checkAll(Web& web)
{
    std::vector<Receiver> receivers = makeReceivers();
    std::vector<Receiver> around = receivers;
    for (Receiver& receiver : around)
    {
        receiver.tangent = tangentOfCube();
        receiver.direction *= 100.0f;
    }
    const std::vector<Receiver> walk = makeWalk();
    receivers.insert(receivers.end(), walk.begin(), walk.end());
    bool passed = web.checkWrappersOf(kAlone, receivers, false);
    passed = web.checkWrappersOf(kInAtlas, receivers, false) && passed;
    passed = web.checkWrappersOf(kAlone, around, true) && passed;
    passed = web.checkMixtureWrappers() && passed;
    passed = web.checkBlurs() && passed;
    passed = web.checkStores() && passed;
    passed = web.checkDepths() && passed;
    passed = web.checkLevels() && passed;
    passed = web.checkFused() && passed;
    passed = web.checkPlacing() && passed;
    const std::vector<Depths> images = stillImages();
    for (const std::size_t image : {0u, 1u})
    {
        for (const bool inPairs : {false, true})
            passed = web.checkSteps(images[image], inPairs) && passed;
    }
    return passed;
}

} // namespace

int main(int argc, char** argv)
{
    std::string phase;
    std::string language;
    std::string folder;
    Options options;
    options.api = GlApi::Es30;
    CLI::App app("Writes down what a client runs, and compares its answers with the library's C++ functions.");
    app.add_option("phase", phase, "write or judge")->required()->check(CLI::IsMember({"write", "judge"}));
    app.add_option("language", language, "glsl or wgsl")->required()->check(CLI::IsMember({"glsl", "wgsl"}));
    app.add_option("folder", folder, "of the script and of the client's results")->required();
    app.add_option("--single", options.single, "folder of the one-file versions")->required();
    app.add_option("--kernels", options.kernels, "folder of the shaders that call the wrappers")->required();
    CLI11_PARSE(app, argc, argv);
    try
    {
        WebScript script(folder, language == "glsl" ? WebLanguage::Glsl : WebLanguage::Wgsl, phase == "judge");
        Web web(script, options);
        const bool passed = checkAll(web);
        script.finish();
        return passed ? 0 : 1;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "lvsm_web: %s\n", error.what());
        return 1;
    }
}
