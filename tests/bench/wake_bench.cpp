// wake_latency: how late the haptic tick starts with and without a renderer beside it, alternating every
// second within one run. The studio's clay at 1 kHz on the last core as the program runs it (SCHED_FIFO where
// the kernel grants it), the whole picture at 60 Hz on the others; in a third turn a picture of 3840x2160, of
// which a second thread draws half on the haptic core itself.
//   onggi_bench --benchmark_filter=wake_latency      (not under taskset: it needs both cores)
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/jobs/frame_pacer.h"
#include "game/haptic/job.h"
#include "tests/bench/bench_failure.h"
#include "tests/bench/frame_case.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::bench {
namespace {

constexpr double kRateHz = 1000.0;
constexpr double kFrameRateHz = 60.0;
constexpr int kFramesATurn = 60;
constexpr int kTurns = 6;

struct Beside {
    const char* name;
    FrameCase* picture;  // null: none
    jobs::Histogram p50_ns{};
    jobs::Histogram p99_ns{};
    std::uint64_t longest_ns = 0;
    std::uint64_t missed = 0;
};

// One second of the job, beside frames or sleeps at the same rate.
Result<void> take_turn(Beside& beside, const jobs::CoreChoice& core, bool& has_fifo) {
    haptic::HapticJobOptions options;
    options.real_time.core = core;
    haptic::HapticJob job(test::studio_start(), {}, std::make_unique<test::StudioHand>(kRateHz), options);
    if (auto started = job.start(); !started) return started;
    has_fifo = job.real_time().fifo.grant == jobs::Grant::kGranted;
    jobs::MonotonicClock clock;
    jobs::FramePacer<> pacer(clock, kFrameRateHz);
    for (int frame = 0; frame < kFramesATurn; ++frame) {
        pacer.wait();
        static_cast<void>(job.newest_snapshot());
        if (beside.picture != nullptr) {
            if (auto drawn = beside.picture->frame(); !drawn) return drawn.error();
        }
        pacer.finish();
        haptic::TickRecord record;
        while (job.take_record(record)) {
        }
    }
    job.stop();
    const jobs::TickStats& stats = job.stats();
    // Recorded for each turn: the median of the turns separates the machine's bad seconds from the renderer's
    // effect.
    beside.p50_ns.record(static_cast<std::int64_t>(stats.wake_latency_ns.percentile(0.5)));
    beside.p99_ns.record(static_cast<std::int64_t>(stats.wake_latency_ns.percentile(0.99)));
    beside.longest_ns = std::max(beside.longest_ns, stats.wake_latency_ns.max());
    beside.missed += stats.missed_deadlines();
    return {};
}

void wake_latency(benchmark::State& state) {
    const jobs::CoreChoice core = jobs::choose_haptic_core();
    static_cast<void>(jobs::keep_this_thread_off_haptic_core(core));
    auto picture = FrameCase::open({});
    if (!picture) return fail(state, picture.error().message.c_str());
    auto large = FrameCase::open({.width = 3840, .height = 2160, .second_thread_on = core.core});
    if (!large) return fail(state, large.error().message.c_str());
    Beside beside[]{{.name = "alone", .picture = nullptr},
                    {.name = "beside frames", .picture = picture->get()},
                    {.name = "beside 4K on its core", .picture = large->get()}};
    bool has_fifo = false;
    for ([[maybe_unused]] auto iteration : state) {
        for (int turn = 0; turn < kTurns; ++turn) {
            for (Beside& one : beside) {
                if (auto taken = take_turn(one, core, has_fifo); !taken)
                    return fail(state, taken.error().message.c_str());
            }
        }
    }
    constexpr double kUsANs = 1e-3;
    for (const Beside& one : beside) {
        const std::string name = one.name;
        state.counters[name + " p50_us"] = static_cast<double>(one.p50_ns.percentile(0.5)) * kUsANs;
        state.counters[name + " p99_us"] = static_cast<double>(one.p99_ns.percentile(0.5)) * kUsANs;
        state.counters[name + " max_us"] = static_cast<double>(one.longest_ns) * kUsANs;
        state.counters[name + " missed"] = static_cast<double>(one.missed);
    }
    state.SetLabel(has_fifo ? "SCHED_FIFO" : "ordinary scheduling");
}
BENCHMARK(wake_latency)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace onggi::bench
