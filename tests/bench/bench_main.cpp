// onggi_bench: Google Benchmark's usual command line, with an exit code that tells a wrong result.
#include <benchmark/benchmark.h>

#include "tests/bench/bench_failure.h"

namespace onggi::bench {
namespace {

bool failed = false;

}  // namespace

void fail(benchmark::State& state, const char* message) {
    failed = true;
    state.SkipWithError(message);
}

bool any_failed() {
    return failed;
}

}  // namespace onggi::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return onggi::bench::any_failed() ? 1 : 0;
}
