// export_glb: the wait between "keep it" and a file: the pot that the bundled gesture throws, 2000 elements,
// thinned, turned into triangles and written as GLB in memory.
#include <benchmark/benchmark.h>

#include "game/exporter/export.h"
#include "tests/bench/bench_failure.h"
#include "tests/support/pot_samples.h"

namespace onggi::bench {
namespace {

void export_glb(benchmark::State& state) {
    const support::PotSample pot = support::thrown_vase();
    std::size_t bytes = 0;
    for ([[maybe_unused]] auto iteration : state) {
        const Result<std::vector<std::byte>> glb =
            exporter::encode_pot(exporter::pot_file(pot.rings()), exporter::ExportKind::kGlb);
        if (!glb || glb->size() < 100000) {
            fail(state, "the export gave no pot");
            return;
        }
        bytes = glb->size();
        benchmark::DoNotOptimize(glb->data());
    }
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(export_glb)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace onggi::bench
