// lvsm_web: what a client without C++ runs of the sampling wrappers and the ready passes, and whether its answers are right.
//   lvsm_web write|judge glsl|wgsl FOLDER --single DIR --kernels DIR
#include "levels_truth.hpp"
#include "mixtures_truth.hpp"
#include "opengl.hpp"
#include "passes_truth.hpp"
#include "steps_truth.hpp"
#include "web_script.hpp"
#include "wrappers_truth.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace
{

using namespace lvsm::support;
using namespace sampling;

// The sampler's, which WebGPU does not say.
constexpr int kSubTexelBits = 8;
// By when the splits of the images are at rest.
constexpr int kFrames = 60;

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

    int pass(const std::string& name, const std::string& entry, const Settings& settings = {})
    {
        if (!m_script.isWgsl())
            return m_script.program(passText(m_options, "lvsm_" + name + ".frag", settings.macros), "");
        std::string text = readFile(m_options.single + "/lvsm_" + name + ".wgsl");
        for (const auto& [from, to] : settings.lines)
        {
            const std::size_t at = text.find(from);
            if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
                throw std::runtime_error(name + ".wgsl is to have this once: " + from);
            text.replace(at, from.size(), to);
        }
        return m_script.program(text, entry);
    }

    bool checkWrappersOf(const Place& place, const std::vector<Receiver>& receivers, bool isCube);
    bool checkMixtureWrappers();
    bool checkBlurs();
    bool checkStores();
    bool checkDepths();
    bool checkLevels();
    bool checkSteps(const Depths& image, bool inPairs);

private:
    std::string kernelText(const std::string& name) const;
    int receivers(const std::vector<glm::vec4>& inputs, int perReceiver);
    std::vector<State> drawSteps(const Depths& image, bool inPairs);
    lvsm::PlaceStep step(int frame, bool inPairs, const lvsm::RelaxOptions<float>& options) const;

    WebScript& m_script;
    Options m_options;
};

// The target's format of this test, and the name of its alias.
std::pair<std::string, std::string> wide(const std::string& alias)
{
    const std::string line = "alias lvsm_" + alias + "Target = texture_storage_2d_array<rgba";
    return {line + "16float", line + "32float"};
}

// The one-file wrappers and what calls them.
std::string Web::kernelText(const std::string& name) const
{
    if (m_script.isWgsl())
        return readFile(m_options.single + "/lvsm_separate.wgsl") + readFile(m_options.kernels + "/" + name + ".wgsl");
    std::string kernel = readFile(m_options.kernels + "/" + name + ".frag");
    const std::string mark = "CALL_WRAPPERS\n";
    if (const std::size_t at = kernel.rfind(mark); at != std::string::npos)
        kernel.replace(at, mark.size(), readFile(m_options.kernels + "/" + name + ".glsl"));
    return head(m_options.api) + readFile(m_options.single + "/lvsm_combined.glsl") + kernel;
}

// A row for each.
int Web::receivers(const std::vector<glm::vec4>& inputs, int perReceiver)
{
    Pixels pixels(perReceiver, static_cast<int>(inputs.size()) / perReceiver);
    pixels.texels = inputs;
    return m_script.texture(pixels, false);
}

bool Web::checkWrappersOf(const Place& place, const std::vector<Receiver>& receivers, bool isCube)
{
    Maps maps = makeMaps();
    if (isCube)
        maps.slices = makeCube();
    std::vector<glm::vec4> inputs;
    for (const Receiver& receiver : receivers)
    {
        const auto own = inputsOf(receiver, place);
        inputs.insert(inputs.end(), own.begin(), own.end());
    }
    const auto count = static_cast<int>(receivers.size());
    const bool alone = place.width == kSize;
    const int program = m_script.program(kernelText("wrappers"), "main");
    const std::vector<WebSource> sources = {
        {"receivers", 0, this->receivers(inputs, kInputs)},
        {"map", 4, m_script.texture(maps.map, false)},
        {"slices", 5, m_script.texture(alone ? maps.slices : placed(maps.slices, place), true)},
        {"unfiltered", 6, m_script.texture(alone ? maps.unfiltered : placed(maps.unfiltered, place), true)}};
    const int target = m_script.texture(Pixels(count, kResults), false);
    m_script.run(program, sources, {}, {target}, {0, 0, count, kResults}, {(count + 63) / 64, 1, 1});
    const Pixels drawn = m_script.read(target);
    if (!m_script.isPlayed())
        return true;
    std::vector<float> results;
    for (int i = 0; i < count * kResults; ++i)
        results.push_back(drawn.at(i / kResults, i % kResults).x);
    return isCube ? compareCube(receivers, results) : compareWrappers(maps, receivers, results);
}

bool Web::checkMixtureWrappers()
{
    const MixtureMaps maps = randomCodes();
    std::vector<glm::uvec4> two;
    for (const glm::uvec2& code : maps.two)
        two.emplace_back(code, 0u, 0u);
    const std::vector<MixtureReceiver> all = mixtureReceivers();
    std::vector<glm::vec4> inputs;
    for (const MixtureReceiver& receiver : all)
        inputs.insert(inputs.end(), {receiver.place(), receiver.plane()});
    const auto count = static_cast<int>(all.size());
    const std::vector<WebSource> sources = {{"receivers", 0, receivers(inputs, 2)},
                                            {"two", 4, m_script.codes(maps.shape, two)},
                                            {"four", 5, m_script.codes(maps.shape, maps.four)}};
    const int target = m_script.texture(Pixels(count, 1), false);
    m_script.run(m_script.program(kernelText("mixtures"), "main"), sources, {}, {target}, {0, 0, count, 1},
                 {(count + 63) / 64, 1, 1});
    const Pixels drawn = m_script.read(target);
    return !m_script.isPlayed() || compareMixtureWrappers(maps, all, drawn.texels);
}

bool Web::checkBlurs()
{
    const int blurring = pass("blur", "lvsm_blurCompute", {"", {wide("Blur")}});
    const std::string maximum = "const LVSM_BLUR_MAXIMUM: bool = ";
    const int largest = pass("blur", "lvsm_blurCompute",
                             {"#define LVSM_BLUR_MAXIMUM\n", {wide("Blur"), {maximum + "false", maximum + "true"}}});
    bool passed = true;
    for (const Blur& blur : {binomialBlur(), gaussianBlur(), boxBlur(), blurOfPart(), largestOfPart()})
    {
        const Pixels pixels = randomPixels(kSlices);
        const int source = m_script.texture(pixels, true);
        const int between = m_script.texture(Pixels(kWidth, kHeight, kSlices), true);
        const int target = m_script.texture(Pixels(kWidth, kHeight, kSlices), true);
        const int program = blur.maximum ? largest : blurring;
        m_script.run(program, {{"lvsm_source", 0, source}}, "lvsm_Blur", blur.passes().across, {between}, kSlices);
        m_script.run(program, {{"lvsm_source", 0, between}}, "lvsm_Blur", blur.passes().down, {target}, kSlices);
        const Pixels made = m_script.read(target);
        passed = !m_script.isPlayed() || (compareBlur("blur", blur, pixels, made, kSubTexelBits) && passed);
    }
    return passed;
}

bool Web::checkStores()
{
    bool passed = true;
    for (const bool isExponential : {false, true})
    {
        const Store store = isExponential ? exponentialStore(false) : layersStore();
        Settings settings{store.macros, {wide("Store")}};
        if (isExponential)
            settings.lines.insert(
                settings.lines.end(),
                {{"    return lvsm_storedLayers(depth, slice);",
                  "    return lvsm_exponentialMoments(depth, vec2f(5.0, 2.0));"},
                 {"\nconst LVSM_STORE_LARGEST: f32 = 1.0", "\nconst LVSM_STORE_LARGEST: f32 = LVSM_LARGEST_FP16"}});
        const int program = pass("store", "lvsm_storeCompute", settings);
        const Pixels depths = storeDepths();
        const int source = m_script.texture(depths, false);
        const int target = m_script.texture(Pixels(kWidth, kHeight, kSlices), true);
        m_script.run(program, {{"lvsm_depths", 0, source}}, "lvsm_Store", storePassOfTest(), {target}, kSlices);
        const Pixels made = m_script.read(target);
        passed = !m_script.isPlayed() || (compareStore("store", store, depths, made) && passed);
    }
    return passed;
}

// A reversed depth buffer of a spot light, as distances to the light, and their moments.
bool Web::checkDepths()
{
    const Settings settings{
        "#define LVSM_DEPTH_SOURCE layout(std140)\n#define LVSM_STORE_LARGEST 1.0\n"
        "#define LVSM_STORE(depth, slice) vec4(lvsm_depthMoments(depth), 0.0, 0.0)\n",
        {wide("Store"),
         {"    return value;", "    return lvsm_convertedDepth(value, texel);"},
         {"    return lvsm_storedLayers(depth, slice);", "    return vec4f(lvsm_depthMoments(depth), 0.0, 0.0);"}}};
    const int program = pass("store", "lvsm_storeCompute", settings);
    const Pixels depths = storeDepths();
    const glm::vec2 tangents(0.75f, 1.25f);
    const lvsm::DepthBlock block = lvsm::pointDepths(0.5f, 20.0f, true, 1.0f, 16.0f, tangents, kWhole);
    auto pass = lvsm::storePass(nullptr, 0, 0, kWhole);
    const int target = m_script.texture(Pixels(kWidth, kHeight), true);
    m_script.run(program, {{"lvsm_depths", 0, m_script.texture(depths, false)}},
                 {{"lvsm_Store", 2, &pass.block, sizeof pass.block}, {"lvsm_Depths", 4, &block, sizeof block}},
                 {target}, pass.region, pass.groups);
    const Pixels made = m_script.read(target);
    if (!m_script.isPlayed())
        return true;
    Comparison comparison("store from a depth buffer");
    for (int i = 0; i < kWidth * kHeight; ++i)
    {
        const int x = i % kWidth;
        const int y = i / kWidth;
        const double linear = lvsm::linearDepthReversed(static_cast<double>(depths.at(x, y).x), 0.5, 20.0);
        const glm::dvec2 place((x + 0.5) / kWidth, (y + 0.5) / kHeight);
        const double along = 0.5 + linear * 19.5;
        const glm::dvec3 position(along * glm::dvec2(tangents) * (2.0 * place - 1.0), along);
        const auto expected = lvsm::depthMoments(lvsm::pointLightDepth(position, glm::dvec3(0), 1.0, 16.0));
        // Twenty units in the last place of a distance up to twice the range, whose square doubles them.
        for (int c = 0; c < 2; ++c)
            comparison.expect(static_cast<double>(made.at(x, y)[c]), expected[c], 2 * 20.0 / (1 << 23) * 2,
                              std::to_string(x) + ' ' + std::to_string(y));
    }
    return comparison.passed();
}

bool Web::checkLevels()
{
    const std::string maximum = "const LVSM_MIP_MAXIMUM: bool = ";
    bool passed = true;
    for (const Levels& levels : levelsOfTest())
    {
        Settings settings{levels.maximum ? "#define LVSM_MIP_MAXIMUM\n" : "", {wide("Mip")}};
        if (levels.maximum)
            settings.lines.push_back({maximum + "false", maximum + "true"});
        const int program = pass("mip", "lvsm_mipCompute", settings);
        const int texture = m_script.texture(randomLevels(), true);
        for (int level = 1; level < levels.count(); ++level)
            m_script.run(program, {{"lvsm_source", 0, texture, level - 1}}, "lvsm_Mip",
                         lvsm::mipPass(levels.map, level, 0, kLevelsTexture.slices), {texture, 0, level},
                         kLevelsTexture.slices);
        const Pixels made = m_script.read(texture);
        passed = !m_script.isPlayed() || (compareLevels("", levels, made, true) && passed);
    }
    return passed;
}

lvsm::PlaceStep Web::step(int frame, bool inPairs, const lvsm::RelaxOptions<float>& options) const
{
    return lvsm::placeStep(kLayers, kMaxLayers, kMap, inPairs ? frame : 0, options);
}

// All frames at once: the client comes to rest by itself.
std::vector<State> Web::drawSteps(const Depths& image, bool inPairs)
{
    lvsm::RelaxOptions<float> options;
    options.splitsPerIteration = inPairs ? 2 : 0;
    const int sumsProgram = pass("step_sums", "lvsm_stepSumsCompute");
    const int mipProgram = pass("mip", "lvsm_mipCompute", {"", {wide("Mip")}});
    const int moveProgram = pass("step_move", "lvsm_stepMoveCompute");
    const int levels = lvsm::levelCount(kMap);
    const int slices = inPairs ? 1 : kLayers / 2;
    const int sums = m_script.texture(Pixels(kMap.width, kMap.height, slices, levels), true);
    const State start = startState(kLayers);
    Pixels first(kStateWidth, 2);
    for (std::size_t i = 0; i < start.size(); ++i)
        first.texels[i / 4][static_cast<int>(i % 4)] = start[i];
    int states[] = {m_script.texture(first, false), m_script.texture(Pixels(kStateWidth, 2), false)};
    const int depths = m_script.texture(image.pixels, false);
    std::vector<State> all;
    for (int frame = 0; frame < (inPairs ? 2 : 1) * kFrames; ++frame)
    {
        const lvsm::PlaceStep now = step(frame, inPairs, options);
        const lvsm::GroupCount groups{(kMap.width + 7) / 8, (kMap.height + 7) / 8, slices};
        m_script.run(sumsProgram, {{"lvsm_depths", 0, depths}, {"lvsm_state", 3, states[0]}}, "lvsm_Step",
                     lvsm::Pass<lvsm::StepBlock>{now.block, groups, now.sums}, {sums}, slices);
        for (int level = 1; level < levels; ++level)
            m_script.run(mipProgram, {{"lvsm_source", 0, sums, level - 1}}, "lvsm_Mip",
                         lvsm::mipPass(now.sums, level, 0, slices), {sums, 0, level}, slices);
        m_script.run(moveProgram, {{"lvsm_sums", 0, sums, levels - 1}, {"lvsm_state", 3, states[0]}},
                     {{"lvsm_Step", 2, &now.block, sizeof now.block}}, {states[1]}, {0, 0, kStateWidth, 2}, {1, 1, 1});
        std::swap(states[0], states[1]);
        const Pixels made = m_script.read(states[0]);
        const float* numbers = &made.texels[0].x;
        all.emplace_back(numbers, numbers + 8 * kStateWidth);
    }
    return all;
}

bool Web::checkSteps(const Depths& image, bool inPairs)
{
    const std::vector<State> states = drawSteps(image, inPairs);
    if (!m_script.isPlayed())
        return true;
    Comparison steps("steps");
    Comparison ends("where steps of all come to rest");
    std::size_t frame = 0;
    const auto draw = [&](const lvsm::PlaceStep&, const Depths&)
    {
        if (frame == states.size())
            throw std::runtime_error("the splits are not at rest when the frames are over");
        return states[frame++];
    };
    compareSteps({image, kLayers, inPairs, false, inPairs ? "in pairs" : "all"}, draw, steps, ends);
    return steps.passed() && (inPairs || ends.passed());
}

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
