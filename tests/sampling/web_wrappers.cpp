#include "mixtures_truth.hpp"
#include "web.hpp"

namespace sampling
{

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
        {"unfiltered", 6, m_script.texture(alone ? maps.unfiltered : placed(maps.unfiltered, place), true)},
        {"greatest", 7, m_script.texture(alone ? maps.greatest : placed(maps.greatest, place), true)}};
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

} // namespace sampling
