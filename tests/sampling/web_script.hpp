// The checks of this folder for clients that have no C++: what they do is written down as a list of textures, shaders and
// passes, and played back with the answers that the client has left. One function does both, in two runs.
#ifndef LVSM_SAMPLING_WEB_SCRIPT_HPP
#define LVSM_SAMPLING_WEB_SCRIPT_HPP

#include "checks.hpp"

#include <lvsm/lvsm.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace sampling
{

// GLSL ES 3.00, whose passes are drawn, or WGSL, whose passes are computed.
enum class WebLanguage
{
    Glsl,
    Wgsl
};

// A texture as a shader has it: by its name in GLSL, by its number in WGSL. level: which one alone, or all where it is -1.
struct WebSource
{
    std::string name;
    int binding;
    int texture;
    int level = -1;
};

// A buffer that shaders change. Of WGSL.
struct WebBuffer
{
    int binding;
    int buffer;
};

struct WebTarget
{
    int texture;
    int slice = 0;
    int level = 0;
};

class WebScript
{
public:
    // folder: where script.json and script.data are written, or results are read, as isPlayed says.
    WebScript(std::string folder, WebLanguage language, bool isPlayed);

    bool isWgsl() const { return m_language == WebLanguage::Wgsl; }
    bool isPlayed() const { return m_isPlayed; }

    int texture(const Pixels& pixels, bool isArray);

    // An array of codes, as words.
    int codes(const Shape& shape, const std::vector<glm::uvec4>& texels);

    // text: whole. entry: of WGSL.
    int program(const std::string& text, const std::string& entry);

    // A pass with its block: in WGSL all slices at once, in GLSL slice by slice, from `first` on.
    template <typename Block>
    void run(int program, const std::vector<WebSource>& sources, const std::string& blockName, lvsm::Pass<Block> pass,
             const WebTarget& target, int slices)
    {
        for (int slice = 0; slice < (isWgsl() ? 1 : slices); ++slice)
        {
            if (!isWgsl())
                pass.block.slice = target.slice + slice;
            run(program, sources, {{blockName, 2, &pass.block, sizeof(Block)}},
                {target.texture, target.slice + slice, target.level}, pass.region, pass.groups);
        }
    }

    struct Block
    {
        std::string name;
        int binding;
        const void* data;
        std::size_t bytes;
    };
    void run(int program, const std::vector<WebSource>& sources, const std::vector<Block>& blocks,
             const WebTarget& target, const lvsm::Rectangle& region, const lvsm::GroupCount& groups);

    // A compute shader that writes to buffers alone. Of WGSL.
    void dispatch(int program, const std::vector<WebSource>& sources, const std::vector<Block>& blocks,
                  const std::vector<WebBuffer>& buffers, const lvsm::GroupCount& groups);

    // Words, which shaders have as storage or as a uniform block.
    int buffer(const void* data, std::size_t bytes);

    // What the texture holds by then; while the script is written, zeros.
    Pixels read(int texture);
    std::vector<std::uint32_t> readBuffer(int buffer);

    // Writes the list, where it is not played.
    void finish() const;

private:
    int texture(const Shape& shape, const void* texels, bool isArray, bool isOfWords);
    std::size_t append(const void* data, std::size_t bytes);
    nlohmann::json runCommand(int program, const std::vector<WebSource>& sources, const std::vector<Block>& blocks,
                              const lvsm::GroupCount& groups);
    void takeResults(void* data, std::size_t bytes);

    std::string m_folder;
    WebLanguage m_language;
    bool m_isPlayed;
    nlohmann::json m_commands = nlohmann::json::array();
    std::vector<char> m_data;
    std::vector<char> m_results;
    std::size_t m_read = 0;
    int m_programs = 0;
    std::vector<Shape> m_shapes;
    std::vector<std::size_t> m_bufferBytes;
};

} // namespace sampling

#endif
