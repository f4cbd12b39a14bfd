// A piece of known work that is timed when the tests are configured, compiled as they are: how slow this
// machine and this build are scales every time limit (.cmake/OnggiTests.cmake). Prints the milliseconds it
// took, by the clock. Like the tests it computes in double precision, walks memory that a cache does not
// hold, and allocates.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace {

double relax(std::vector<double>& rings, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 1; i + 1 < rings.size(); ++i)
            rings[i] = 0.5 * rings[i] + 0.25 * (rings[i - 1] + rings[i + 1]) + 1e-9 * std::sqrt(rings[i]);
    }
    return rings[rings.size() / 2];
}

std::uint64_t walk(std::vector<std::uint32_t>& memory, int steps) {
    std::uint64_t state = 1;
    for (int step = 0; step < steps; ++step) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        memory[(state >> 33U) % memory.size()] += static_cast<std::uint32_t>(step);
    }
    return memory[0];
}

std::size_t write(int lines) {
    std::vector<std::string> text;
    for (int line = 0; line < lines; ++line)
        text.push_back("ring " + std::to_string(line) + " of the wall of a pot");
    return text.size();
}

}  // namespace

int main() {
    const auto begun = std::chrono::steady_clock::now();
    std::vector<double> rings(20'000, 40.0);
    std::vector<std::uint32_t> memory(4'000'000);
    const double result = relax(rings, 1'000) + static_cast<double>(walk(memory, 5'000'000)) +
                          static_cast<double>(write(400'000));
    const auto took = std::chrono::steady_clock::now() - begun;
    std::printf("%lld\n",
                static_cast<long long>(std::chrono::duration_cast<std::chrono::milliseconds>(took).count()));
    return result > 0.0 ? 0 : 1;
}
