#include "wgpu.hpp"

#include "kernel.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace parity
{
namespace
{

namespace fs = std::filesystem;

constexpr int kUnavailable = 77;

void write(const fs::path& path, const void* data, std::size_t size)
{
    std::ofstream(path, std::ios::binary).write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
}

} // namespace

lvsm::support::Result<std::map<std::string, std::vector<float>>>
runWithWgpu(const std::string& command, const std::string& kernel, const std::vector<Words>& inputs,
            std::size_t numbers, const std::vector<std::string>& devices)
{
    const fs::path folder = fs::temp_directory_path() / ("lvsm_wgpu_" + std::to_string(getpid()));
    fs::create_directories(folder);
    write(folder / "kernel.wgsl", kernel.data(), kernel.size());
    write(folder / "inputs", inputs.data(), inputs.size() * sizeof(Words));
    std::string line = "'" + command + "' run '" + (folder / "kernel.wgsl").string() + "' '" +
                       (folder / "inputs").string() + "' " + std::to_string(numbers * sizeof(float)) + " " +
                       std::to_string(inputs.size() / kGroupSize) + " '" + (folder / "results").string() + "'";
    for (const std::string& device : devices)
        line += " '" + device + "'";
    const int status = std::system(line.c_str());

    std::map<std::string, std::vector<float>> results;
    for (const std::string& device : devices)
    {
        std::ifstream file(folder / ("results." + device), std::ios::binary);
        std::vector<float> read(numbers);
        if (file.read(reinterpret_cast<char*>(read.data()), static_cast<std::streamsize>(numbers * sizeof(float))))
            results[device] = read;
    }
    fs::remove_all(folder);
    if (status != 0 && !(WIFEXITED(status) && WEXITSTATUS(status) == kUnavailable))
        return lvsm::support::Failure{command + " failed"};
    return results;
}

} // namespace parity
