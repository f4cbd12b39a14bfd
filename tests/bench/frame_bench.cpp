// frame/WxH: one frame of the live picture, drawn into memory, of a pot that changes and turns every frame
// with a tool at its side: all that a frame costs but showing it. Pin it to one core to see what the kiosk
// has: LP_NUM_THREADS=0 taskset -c 0 onggi_bench --benchmark_filter=frame
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "engine/jobs/histogram.h"
#include "game/wheel/live_view.h"
#include "tests/bench/bench_failure.h"
#include "tests/bench/paper_tick_case.h"

namespace onggi::bench {
namespace {

constexpr int kElements = 2000;
constexpr double kHeightMm = 200.0;

// A vase with throwing rings of 0.3 mm, which shrinks by a hair each frame and grows back.
void throw_a_little(std::vector<float>& radii, std::int64_t frame) {
    const double breath = 0.2 * std::sin(0.1 * static_cast<double>(frame));
    for (int i = 0; i < kElements; ++i) {
        const double y = (i + 0.5) * kHeightMm / kElements;
        const double belly = (y - 70.0) / 52.0;
        radii[static_cast<std::size_t>(i)] =
            static_cast<float>(32.0 + 24.0 * std::exp(-belly * belly) +
                               0.3 * std::sin(y * 0.78 + 2.3 * std::sin(y * 0.026)) + breath);
    }
}

void frame(benchmark::State& state, int width, int height) {
    auto view = wheel::LiveView::open({.width = width, .height = height, .headless = true});
    if (!view) return fail(state, view.error().message.c_str());
    std::vector<float> radii(kElements);
    jobs::Histogram taken_ns;
    StopWatch watch;
    std::int64_t number = 0;
    for ([[maybe_unused]] auto iteration : state) {
        throw_a_little(radii, number);
        const double angle = 0.2 * static_cast<double>(number++);
        watch.start();
        const auto drawn =
            (*view)->draw({.radii_mm = radii,
                           .height_mm = kHeightMm,
                           .tool_position_mm = {70.0, 100.0 + 20.0 * std::sin(0.05 * angle), 0.0},
                           .wheel_direction = {std::cos(angle), std::sin(angle)},
                           .wheel_turning = true});
        const auto waited = (*view)->wait();
        const double taken_s = watch.stop_s();
        if (!drawn || !*drawn || !waited) return fail(state, "no frame was drawn");
        state.SetIterationTime(taken_s);
        taken_ns.record(static_cast<std::int64_t>(taken_s * 1e9));
    }
    const auto picture = (*view)->read_back();
    if (!picture || picture->rgba.at(0) == 0) fail(state, "the picture is empty");
    state.counters["p50_ms"] = static_cast<double>(taken_ns.percentile(0.5)) * 1e-6;
    state.counters["p99_ms"] = static_cast<double>(taken_ns.percentile(0.99)) * 1e-6;
    state.SetLabel((*view)->device_name());
}

void frame_720p(benchmark::State& state) {
    frame(state, 1280, 720);
}
BENCHMARK(frame_720p)->Name("frame/1280x720")->UseManualTime()->Unit(benchmark::kMillisecond);

void frame_1080p(benchmark::State& state) {
    frame(state, 1920, 1080);
}
BENCHMARK(frame_1080p)->Name("frame/1920x1080")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace onggi::bench
