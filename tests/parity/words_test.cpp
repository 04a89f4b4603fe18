// That a row which reads beyond the words of an input is refused, whatever it reads them as.
#include "run_row.hpp"

#include <cstdio>
#include <stdexcept>

namespace
{

using namespace parity;

template <typename Read>
bool isRefused(const Read& read)
{
    try
    {
        static_cast<void>(read());
    }
    catch (const std::out_of_range&)
    {
        return true;
    }
    return false;
}

// What reads `count` words reads the last ones of an input, and no word more.
template <typename Read>
int failures(const char* name, int count, const Read& read)
{
    const int last = kWords - count;
    int found = 0;
    if (isRefused([&] { return read(last); }))
    {
        std::printf("FAIL %s(%d) is refused, though it reads the last words of an input\n", name, last);
        ++found;
    }
    for (const int word : {last + 1, kWords, kWords + 1, -1})
    {
        if (!isRefused([&] { return read(word); }))
        {
            std::printf("FAIL %s(%d) reads what is not of the input\n", name, word);
            ++found;
        }
    }
    return found;
}

} // namespace

#define FAILURES(name, count) failures(#name, count, [&](int word) { return name(word); })

int main()
{
    using T = double;
    const Words words{};
    const Arguments<T> in(words);
    const int found = FAILURES(A, 1) + FAILURES(I, 1) + FAILURES(N, 1) + FAILURES(V2, 2) + FAILURES(V3, 3) +
                      FAILURES(V4, 4) + FAILURES(IV2, 2) + FAILURES(UV2, 2) + FAILURES(UV4, 4) + FAILURES(TAP, 4) +
                      FAILURES(COMPONENT, 10) + FAILURES(PLANE, 7) + FAILURES(MIXTURE2, 20) + FAILURES(MIXTURE4, 22);
    std::printf("%d failures\n", found);
    return found == 0 ? 0 : 1;
}
