// paper_tick/N/radius_mm: one tick of the paper's clay. paper_tick_scan/N/radius_mm: the same tick by
// visiting every element in double precision, the yardstick.
#include <benchmark/benchmark.h>

#include "tests/bench/bench_failure.h"
#include "tests/bench/paper_tick_case.h"

namespace onggi::bench {
namespace {

void run(benchmark::State& state, double (PaperTickCase::*tick)()) {
    PaperTickCase wall(static_cast<int>(state.range(0)), static_cast<double>(state.range(1)));
    if (!wall.both_agree()) {
        fail(state, "the clay and the scan disagree on the contact");
        return;
    }
    double contacts = 0.0;
    for ([[maybe_unused]] auto iteration : state) {
        state.SetIterationTime((wall.*tick)());
        contacts += wall.forces().contacts;
    }
    state.counters["contacts"] = benchmark::Counter(contacts, benchmark::Counter::kAvgIterations);
    state.counters["rate_hz"] = benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate);
}

void paper_tick(benchmark::State& state) {
    run(state, &PaperTickCase::tick_clay);
}

void paper_tick_scan(benchmark::State& state) {
    run(state, &PaperTickCase::tick_scan);
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->UseManualTime();
    for (const int element_count : {2000, 20000, 200000}) {
        for (const int radius_mm : {5, 20})
            bench->Args({element_count, radius_mm});
    }
}

BENCHMARK(paper_tick)->Apply(sizes);
BENCHMARK(paper_tick_scan)->Apply(sizes);

}  // namespace
}  // namespace onggi::bench
