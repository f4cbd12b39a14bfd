// publish_snapshot: the haptic thread's cost of publishing a snapshot of 2000 radii. safety_chain,
// velocity_estimator: the cost of each. whole_tick, whole_tick_studio: a whole period of the haptic thread:
// device, clay, safety, record, snapshot.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <utility>

#include "engine/jobs/triple_buffer.h"
#include "game/haptic/job.h"
#include "game/haptic/tool_device.h"
#include "tests/bench/bench_failure.h"
#include "tests/bench/paper_tick_case.h"

namespace onggi::bench {
namespace {

void publish_snapshot(benchmark::State& state) {
    const haptic::HapticState clay_and_wheel;
    const haptic::TickResult result;
    const haptic::HapticParameters parameters;
    jobs::TripleBuffer<haptic::Snapshot> buffer(haptic::first_snapshot(clay_and_wheel, parameters));
    jobs::TripleBuffer<pot::Pot> pots([&] { return haptic::pot_of(clay_and_wheel); });
    haptic::PotCopier copier;
    for ([[maybe_unused]] auto iteration : state) {
        haptic::fill_snapshot(buffer.writing(), clay_and_wheel, result, parameters);
        buffer.publish();
        if (copier.step(pots.writing(), clay_and_wheel, parameters.dt_s())) pots.publish();
        benchmark::ClobberMemory();
    }
    buffer.acquire();
    pots.acquire();
    const std::vector<float>& radii_mm = pots.reading().outer_mm;
    if (radii_mm.size() != 2000 || radii_mm.back() != 60.0F) {
        fail(state, "the snapshot does not hold the clay");
    }
}
BENCHMARK(publish_snapshot);

void safety_chain(benchmark::State& state) {
    const haptics::SafetyLimits limits = haptics::limits_for(
        {.name = "motors", .force_axes = 3, .peak_force_n = 3.3, .continuous_force_n = 0.88});
    haptics::SafetyInput input{
        .position_mm = {69.0, 100.0, 0.0}, .dt_s = 0.00025, .velocity_mm_s = {40.0, 0.0, 0.0}};
    double step_mm = 0.01;
    haptics::SafetyState safety;
    safety.calm_ticks = limits.small_force_ticks + 1;
    dvec3 force_n(1.0, 0.5, -0.25);
    for ([[maybe_unused]] auto iteration : state) {
        benchmark::DoNotOptimize(force_n);
        benchmark::DoNotOptimize(haptics::apply_safety_chain(force_n, input, limits, safety));
        force_n = -force_n;  // so that every stage has something to do
        input.position_mm.x += step_mm;
        step_mm = -step_mm;
    }
    if (safety.ramp == 0.0 || safety.fault != haptics::Fault::kNone) fail(state, "the chain was not at work");
}
BENCHMARK(safety_chain);

void velocity_estimator(benchmark::State& state) {
    constexpr double kStepMm = 0.055;
    haptics::VelocityEstimator estimator(kStepMm);
    dvec3 at_mm(60.0, 100.0, 0.0);
    dvec3 velocity_mm_s(0.0);
    int tick = 0;
    double fastest_mm_s = 0.0;
    for ([[maybe_unused]] auto iteration : state) {
        tick = (tick + 1) % 300;
        at_mm.x = 60.0 + kStepMm * (tick / 3);
        benchmark::DoNotOptimize(at_mm);
        velocity_mm_s = estimator.update(at_mm, 0.00025);
        benchmark::DoNotOptimize(velocity_mm_s);
        fastest_mm_s = std::max(fastest_mm_s, velocity_mm_s.x);
    }
    // The library also runs a single tick, in which nothing can move.
    if (state.iterations() > 300 && fastest_mm_s == 0.0) fail(state, "the tool did not move");
}
BENCHMARK(velocity_estimator);

// A hand that moves inwards at 10 mm/s, which keeps a 10 mm tool about 1 mm deep in the clay.
class SteadyHand final : public haptic::ToolDevice {
  public:
    SteadyHand(double wall_mm, double rate_hz) : wall_mm_(wall_mm), rate_hz_(rate_hz) {}
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override { return {}; }
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double /*dt_s*/) noexcept override {
        const double inwards_mm = 1.0 + 10.0 * static_cast<double>(tick) / rate_hz_;
        return {.position_mm = {wall_mm_ + 10.0 - inwards_mm, 100.013, 0.0},
                .radius_mm = 10.0,
                .wheel_button = true};
    }
    void write(const dvec3& force_n) noexcept override {
        dvec3 written_n = force_n;
        benchmark::DoNotOptimize(written_n);
    }

  private:
    double wall_mm_;
    double rate_hz_;
};

void run_whole_ticks(benchmark::State& state, haptic::HapticState start, double wall_mm,
                     const haptic::HapticParameters& parameters) {
    haptic::HapticJobOptions options;
    options.run_ticks = 1000;
    options.repeat = true;
    haptic::HapticWork work(std::move(start), parameters,
                            std::make_unique<SteadyHand>(wall_mm, parameters.rate_hz()), options);
    jobs::Period period{.dt_s = parameters.dt_s()};
    jobs::Histogram taken_ns;
    StopWatch watch;
    double contacts = 0.0;
    for ([[maybe_unused]] auto iteration : state) {
        watch.start();
        bool more = work.tick(period);
        const double taken_s = watch.stop_s();
        state.SetIterationTime(taken_s);
        taken_ns.record(static_cast<std::int64_t>(taken_s * 1e9));

        benchmark::DoNotOptimize(more);
        haptic::TickRecord record;
        while (work.take_record(record))
            benchmark::DoNotOptimize(record);
        contacts += work.newest_snapshot().result.forces.contacts;
        ++period.index;
        ++period.tick;
    }
    if (contacts == 0.0) fail(state, "the tool never touched the clay");
    state.counters["contacts"] = benchmark::Counter(contacts, benchmark::Counter::kAvgIterations);
    state.counters["p50_ns"] = static_cast<double>(taken_ns.percentile(0.5));
    state.counters["p99_ns"] = static_cast<double>(taken_ns.percentile(0.99));
    state.counters["p999_ns"] = static_cast<double>(taken_ns.percentile(0.999));
}

void whole_tick(benchmark::State& state) {
    run_whole_ticks(state, haptic::HapticState(), 60.0, {});
}
BENCHMARK(whole_tick)->UseManualTime();

// The same with the studio's clay at the kiosk's 4000 Hz: a thrown wall of 2000 rings that stands alone.
void whole_tick_studio(benchmark::State& state) {
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(4000.0);
    clay::StudioClay wall({.mass_g = 2500.0, .off_centre_mm = 0.0});
    wall.set_wall(45.0, 6.5, 12.0, 200.0, 2000);
    wall.set_wheel_speed(4.0 * std::numbers::pi);
    run_whole_ticks(state, haptic::HapticState(std::move(wall)), 45.0, parameters);
}
BENCHMARK(whole_tick_studio)->UseManualTime();

}  // namespace
}  // namespace onggi::bench
