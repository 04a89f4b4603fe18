// lvsm_client_rows: the rows of tests/parity, a few thousand inputs each, as files for a client to run and to be judged.
//   lvsm_client_rows write FOLDER                 writes FOLDER/FUNCTION.inputs, 24 words an input, and FOLDER/rows.json
//                                                 with the shaders of each: `kernel`, for fragments, `hlsl` and
//                                                 `wgsl`, to put after the library; `compute`, of GLSL, to put it after
//                                                 the first line
//   lvsm_client_rows judge FOLDER CLIENT REPORT ORDER
//                                                 reads FOLDER/FUNCTION.results, as many numbers an input as its result
//                                                 has, and FOLDER/version, what the client says of itself
// The tolerance is that of tests/parity, derived input by input from the precision that Vulkan and OpenGL ES promise.
// ORDER: `precise`, or `imprecise` where the language has no such word, and compilers take sums in another order.
#include "judge.hpp"
#include "kernel.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{

using namespace parity;
using nlohmann::json;

// Of the 65536 inputs of a domain, and as many hostile ones, a client runs one in so many.
constexpr std::size_t kEvery = 32;

std::string path(const std::string& folder, const Row& row, const char* suffix)
{
    return folder + "/" + row.function + suffix;
}

int write(const std::string& folder)
{
    json list = json::array();
    for (const Row& row : rows())
    {
        const std::vector<Words> inputs = thinnedInputs(row, kEvery);
        std::ofstream file(path(folder, row, ".inputs"), std::ios::binary);
        file.write(reinterpret_cast<const char*>(inputs.data()),
                   static_cast<std::streamsize>(inputs.size() * sizeof(Words)));
        list.push_back({{"function", row.function},
                        {"inputs", inputs.size()},
                        {"numbers", componentCount(row.kind)},
                        {"kernel", glslFragmentKernel(row)},
                        {"compute", glslKernel(row, "")},
                        {"hlsl", hlslKernel(row, "")},
                        {"wgsl", wgslKernel(row, "")}});
    }
    std::ofstream(folder + "/rows.json") << list.dump(1) << '\n';
    return 0;
}

// The verdicts of a row; none where the client left no results of the right size.
std::vector<Verdict> judge(const std::string& folder, const Row& row, Order order)
{
    const Judge judge(row, order, kEvery);
    std::vector<float> results(judge.inputs().size() * static_cast<std::size_t>(componentCount(row.kind)));
    const std::streamsize size = static_cast<std::streamsize>(results.size() * sizeof(float));
    std::ifstream file(path(folder, row, ".results"), std::ios::binary);
    file.read(reinterpret_cast<char*>(results.data()), size);
    if (file.gcount() != size || file.peek() != std::char_traits<char>::eof())
        return {};
    const std::vector<Verdict> verdicts = judge.judge(results);
    for (const Verdict& verdict : verdicts)
    {
        if (!verdict.passed())
            std::printf("FAIL %s %s: %zu not finite, %zu outside, %.0f%% tight; expected %.9g, got %.9g for (%s)\n",
                        row.function.c_str(), verdict.domain.c_str(), verdict.nonFinite, verdict.outside,
                        100.0 * verdict.tightShare, verdict.expected, verdict.answered,
                        describeInput(judge.inputs()[verdict.worstInput]).c_str());
    }
    return verdicts;
}

// What the client has said of itself.
std::string readVersion(const std::string& folder)
{
    std::ifstream file(folder + "/version");
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

int judgeAll(const std::string& folder, const std::string& client, const std::string& report, Order order)
{
    std::size_t failed = 0;
    std::size_t inputs = 0;
    Verdict worst;
    std::string worstFunction;
    for (const Row& row : rows())
    {
        const std::vector<Verdict> verdicts = judge(folder, row, order);
        if (verdicts.empty())
            std::printf("FAIL %s: no results of the right size\n", row.function.c_str());
        bool passed = !verdicts.empty();
        for (const Verdict& verdict : verdicts)
        {
            passed = passed && verdict.passed();
            inputs += verdict.inputs;
            // Of visibilities, weights and depths of which little is allowed the one that has the least room.
            if (row.high <= 1.0 && verdict.tolerance > 0.0 && verdict.tolerance < 1.0e-5 &&
                verdict.worstError * worst.tolerance >= worst.worstError * verdict.tolerance)
            {
                worst = verdict;
                worstFunction = row.function;
            }
        }
        failed += passed ? 0 : 1;
    }
    std::printf("%s: %zu functions, %zu inputs, %zu functions failed; nearest to its tolerance: %s, %.3g of %.3g\n",
                client.c_str(), rows().size(), inputs, failed, worstFunction.c_str(), worst.worstError,
                worst.tolerance);
    std::filesystem::create_directories(std::filesystem::path(report).parent_path());
    std::ofstream(report) << json({{"client", client},
                                   {"version", readVersion(folder)},
                                   {"functions", rows().size()},
                                   {"inputs", inputs},
                                   {"failed", failed},
                                   {"worst_function", worstFunction},
                                   {"worst_error", worst.worstError},
                                   {"tolerance", worst.tolerance}})
                                 .dump(1)
                          << '\n';
    return failed == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 2 && words[0] == "write")
        return write(words[1]);
    if (words.size() == 5 && words[0] == "judge" && (words[4] == "precise" || words[4] == "imprecise"))
        return judgeAll(words[1], words[2], words[3], words[4] == "precise" ? Order::AsWritten : Order::Any);
    std::fprintf(stderr, "usage: lvsm_client_rows write FOLDER | judge FOLDER CLIENT REPORT ORDER\n");
    return 2;
}
