#include "web_script.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sampling
{

WebScript::WebScript(std::string folder, WebLanguage language, bool isPlayed)
    : m_folder(std::move(folder)), m_language(language), m_isPlayed(isPlayed)
{
    if (!m_isPlayed)
        return;
    std::ifstream file(m_folder + "/results", std::ios::binary);
    if (!file)
        throw std::runtime_error("the client has left no results in " + m_folder);
    m_results.assign(std::istreambuf_iterator<char>(file), {});
}

std::size_t WebScript::append(const void* data, std::size_t bytes)
{
    const std::size_t at = m_data.size();
    m_data.insert(m_data.end(), static_cast<const char*>(data), static_cast<const char*>(data) + bytes);
    return at;
}

int WebScript::texture(const Shape& shape, const void* texels, bool isArray, bool isOfWords)
{
    m_shapes.push_back(shape);
    if (!m_isPlayed)
        m_commands.push_back({{"do", "texture"},
                              {"width", shape.width},
                              {"height", shape.height},
                              {"slices", shape.slices},
                              {"levels", shape.levels},
                              {"array", isArray},
                              {"words", isOfWords},
                              {"at", append(texels, shape.count() * sizeof(glm::vec4))}});
    return static_cast<int>(m_shapes.size()) - 1;
}

int WebScript::texture(const Pixels& pixels, bool isArray)
{
    return texture(pixels, pixels.texels.data(), isArray, false);
}

int WebScript::codes(const Shape& shape, const std::vector<glm::uvec4>& texels)
{
    return texture(shape, texels.data(), true, true);
}

int WebScript::program(const std::string& text, const std::string& entry)
{
    if (!m_isPlayed)
        m_commands.push_back({{"do", "program"}, {"text", text}, {"entry", entry}});
    return m_programs++;
}

int WebScript::buffer(const void* data, std::size_t bytes)
{
    m_bufferBytes.push_back(bytes);
    if (!m_isPlayed)
        m_commands.push_back({{"do", "buffer"}, {"at", append(data, bytes)}, {"bytes", bytes}});
    return static_cast<int>(m_bufferBytes.size()) - 1;
}

nlohmann::json WebScript::runCommand(int program, const std::vector<WebSource>& sources,
                                     const std::vector<Block>& blocks, const lvsm::GroupCount& groups)
{
    nlohmann::json command = {{"do", "run"},
                              {"program", program},
                              {"groups", {groups.x, groups.y, groups.z}},
                              {"sources", nlohmann::json::array()},
                              {"blocks", nlohmann::json::array()},
                              {"buffers", nlohmann::json::array()}};
    for (const WebSource& source : sources)
        command["sources"].push_back({source.name, source.binding, source.texture, source.level});
    for (const Block& block : blocks)
        command["blocks"].push_back({block.name, block.binding, append(block.data, block.bytes), block.bytes});
    return command;
}

void WebScript::run(int program, const std::vector<WebSource>& sources, const std::vector<Block>& blocks,
                    const WebTarget& target, const lvsm::Rectangle& region, const lvsm::GroupCount& groups)
{
    if (m_isPlayed)
        return;
    nlohmann::json command = runCommand(program, sources, blocks, groups);
    command["target"] = {target.texture, target.slice, target.level};
    command["region"] = {region.x, region.y, region.width, region.height};
    m_commands.push_back(std::move(command));
}

void WebScript::dispatch(int program, const std::vector<WebSource>& sources, const std::vector<Block>& blocks,
                         const std::vector<WebBuffer>& buffers, const lvsm::GroupCount& groups)
{
    if (m_isPlayed)
        return;
    nlohmann::json command = runCommand(program, sources, blocks, groups);
    for (const WebBuffer& buffer : buffers)
        command["buffers"].push_back({buffer.binding, buffer.buffer});
    m_commands.push_back(std::move(command));
}

void WebScript::takeResults(void* data, std::size_t bytes)
{
    if (m_read + bytes > m_results.size())
        throw std::runtime_error("the client has left too few results");
    std::memcpy(data, m_results.data() + m_read, bytes);
    m_read += bytes;
}

Pixels WebScript::read(int texture)
{
    const Shape& shape = m_shapes[static_cast<std::size_t>(texture)];
    Pixels pixels(shape.width, shape.height, shape.slices, shape.levels);
    if (m_isPlayed)
        takeResults(pixels.texels.data(), pixels.texels.size() * sizeof(glm::vec4));
    else
        m_commands.push_back({{"do", "read"}, {"texture", texture}});
    return pixels;
}

std::vector<std::uint32_t> WebScript::readBuffer(int buffer)
{
    std::vector<std::uint32_t> words(m_bufferBytes[static_cast<std::size_t>(buffer)] / sizeof(std::uint32_t));
    if (m_isPlayed)
        takeResults(words.data(), words.size() * sizeof(std::uint32_t));
    else
        m_commands.push_back({{"do", "readBuffer"}, {"buffer", buffer}});
    return words;
}

void WebScript::finish() const
{
    if (m_isPlayed)
    {
        if (m_read != m_results.size())
            throw std::runtime_error("the client has left more results than were asked for");
        return;
    }
    std::ofstream(m_folder + "/script.json") << m_commands.dump();
    std::ofstream(m_folder + "/script.data", std::ios::binary)
        .write(m_data.data(), static_cast<std::streamsize>(m_data.size()));
}

} // namespace sampling
