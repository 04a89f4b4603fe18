// lvsm_answers: the rows of tests/parity in float, compiled as a client compiles the headers.
//   lvsm_answers FOLDER        reads FOLDER/FUNCTION.inputs, as many words an input as Words has, and writes
//                              FOLDER/FUNCTION.results, the numbers of each result, which lvsm_client_rows judges
#include "kernel.hpp"
#include "run_row.hpp"

#include <cstdio>
#include <fstream>

namespace
{

using namespace parity;

bool answer(const std::string& path, int components, Result<float> (*run)(const Words&))
{
    std::ifstream inputs(path + ".inputs", std::ios::binary);
    std::ofstream results(path + ".results", std::ios::binary);
    Words words;
    while (inputs.read(reinterpret_cast<char*>(words.data()), sizeof words))
    {
        const Result<float> result = run(words);
        results.write(reinterpret_cast<const char*>(result.data()),
                      static_cast<std::streamsize>(static_cast<std::size_t>(components) * sizeof(float)));
    }
    return inputs.eof() && inputs.gcount() == 0 && results.flush().good();
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::fprintf(stderr, "usage: lvsm_answers FOLDER\n");
        return 2;
    }
    const std::string folder = std::string(argv[1]) + '/';
    bool complete = true;
#define FUNCTION(name, kind, arguments, domain, low, high) \
    complete = answer(folder + #name, componentCount(#kind), run_##name<float>) && complete;
#include "functions.def"
#undef FUNCTION
    if (!complete)
        std::fprintf(stderr, "lvsm_answers: inputs missing in %s, or its results cannot be written\n", argv[1]);
    return complete ? 0 : 1;
}
