// Reports a wrong result of a benchmark: the benchmark is skipped, and the program exits with 1. (Google
// Benchmark alone would print the error and exit with 0.) Main thread.
#pragma once

#include <benchmark/benchmark.h>

namespace onggi::bench {

void fail(benchmark::State& state, const char* message);

}  // namespace onggi::bench
