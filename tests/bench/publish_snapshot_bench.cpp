// publish_snapshot: what it costs the haptic thread to hand one snapshot of 2000 radii to the picture.
// safety_chain: what stands between the clay's force and the hand.
// whole_tick: all that one period of the haptic thread does at work: device, clay, safety, record, snapshot.
#include <benchmark/benchmark.h>

#include <memory>

#include "engine/jobs/triple_buffer.h"
#include "game/haptic/job.h"
#include "tests/bench/bench_failure.h"
#include "tests/bench/paper_tick_case.h"

namespace onggi::bench {
namespace {

void publish_snapshot(benchmark::State& state) {
    const haptic::HapticState clay_and_wheel;
    const haptic::TickResult result;
    jobs::TripleBuffer<haptic::Snapshot> buffer(haptic::first_snapshot(clay_and_wheel));
    for ([[maybe_unused]] auto iteration : state) {
        haptic::fill_snapshot(buffer.writing(), clay_and_wheel, result);
        buffer.publish();
        benchmark::ClobberMemory();
    }
    buffer.acquire();
    if (buffer.reading().radii_mm.size() != 2000 || buffer.reading().radii_mm.back() != 60.0F) {
        fail(state, "the snapshot does not hold the clay");
    }
}
BENCHMARK(publish_snapshot);

void safety_chain(benchmark::State& state) {
    const haptics::SafetyLimits limits;
    const haptics::SafetyInput input{.position_mm = {69.0, 100.0, 0.0}, .dt_s = 0.00025};
    haptics::SafetyState safety;
    safety.calm_ticks = limits.small_force_ticks + 1;
    dvec3 force_n(1.0, 0.5, -0.25);
    for ([[maybe_unused]] auto iteration : state) {
        benchmark::DoNotOptimize(force_n);
        benchmark::DoNotOptimize(haptics::apply_safety_chain(force_n, input, limits, safety));
        force_n = -force_n;  // so that every stage has something to do
    }
    if (safety.ramp == 0.0 || safety.fault != haptics::Fault::kNone) fail(state, "the chain was not at work");
}
BENCHMARK(safety_chain);

// A hand that goes inwards at 10 mm/s for a second, which keeps a 10 mm tool about 1 mm deep in the clay.
class SteadyHand final : public haptics::HapticDevice {
  public:
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override { return {}; }
    [[nodiscard]] haptics::ToolState read(std::uint64_t tick, double /*dt_s*/) noexcept override {
        const double inwards_mm = 1.0 + 0.01 * static_cast<double>(tick);
        return {.position_mm = {70.0 - inwards_mm, 100.013, 0.0}, .radius_mm = 10.0, .wheel_button = true};
    }
    void write(const dvec3& force_n) noexcept override { benchmark::DoNotOptimize(force_n); }
};

void whole_tick(benchmark::State& state) {
    haptic::HapticJobOptions options;
    options.run_ticks = 1000;
    options.repeat = true;
    haptic::HapticWork work(haptic::HapticState(), haptic::HapticParameters{}, std::make_unique<SteadyHand>(),
                            options);
    jobs::Period period{.dt_s = 0.001};
    jobs::Histogram taken_ns;
    StopWatch watch;
    double contacts = 0.0;
    for ([[maybe_unused]] auto iteration : state) {
        watch.start();
        const bool more = work.tick(period);
        const double taken_s = watch.stop_s();
        state.SetIterationTime(taken_s);
        taken_ns.record(static_cast<std::int64_t>(taken_s * 1e9));

        benchmark::DoNotOptimize(more);
        haptic::TickRecord record;
        while (work.take_record(record))
            benchmark::DoNotOptimize(record);
        haptic::BlockHash hash;
        while (work.take_hash(hash))
            benchmark::DoNotOptimize(hash);
        contacts += work.newest_snapshot().forces.contacts;
        ++period.index;
        ++period.tick;
    }
    if (contacts == 0.0) fail(state, "the tool never touched the clay");
    state.counters["contacts"] = benchmark::Counter(contacts, benchmark::Counter::kAvgIterations);
    state.counters["p50_ns"] = static_cast<double>(taken_ns.percentile(0.5));
    state.counters["p99_ns"] = static_cast<double>(taken_ns.percentile(0.99));
    state.counters["p999_ns"] = static_cast<double>(taken_ns.percentile(0.999));
}
BENCHMARK(whole_tick)->UseManualTime();

}  // namespace
}  // namespace onggi::bench
