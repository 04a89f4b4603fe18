#include "fused_truth.hpp"
#include "levels_truth.hpp"
#include "web.hpp"

namespace sampling
{
namespace
{

// The sampler's, which WebGPU does not say.
constexpr int kSubTexelBits = 8;

} // namespace

int Web::pass(const std::string& name, const std::string& entry, const Settings& settings)
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

std::pair<std::string, std::string> wide(const std::string& alias)
{
    const std::string line = "alias lvsm_" + alias + "Target = texture_storage_2d_array<rgba";
    return {line + "16float", line + "32float"};
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

// The fused pass, and what it leaves is what it stored and blurred along x.
bool Web::checkFused()
{
    if (!m_script.isWgsl())
        return true;
    const int program = pass("fused", "lvsm_fusedCompute", {"", {wide("Store")}});
    const int source = m_script.texture(fusedDepths(), false);
    bool passed = true;
    for (const Blur& blur : fusedBlurs())
    {
        const lvsm::FusedPasses passes = fusedPassesOf(blur);
        const int target = m_script.texture(Pixels(kFusedSize.width, kFusedSize.height, kFusedSize.slices), true);
        m_script.run(program, {{"lvsm_depths", 0, source}},
                     {{"lvsm_Store", 2, &passes.store.block, sizeof passes.store.block},
                      {"lvsm_Fused", 3, &passes.fused, sizeof passes.fused}},
                     {target}, passes.store.region, passes.store.groups);
        const Pixels made = m_script.read(target);
        passed = !m_script.isPlayed() || (compareFused("fused", blur, made) && passed);
    }
    return passed;
}

} // namespace sampling
