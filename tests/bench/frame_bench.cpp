// frame/WxH: one frame of the live picture, drawn into memory, of a hollow pot that changes and turns every
// frame with a hand at its side: all that a frame costs but showing it. Pin it to one core to see what the
// kiosk has: LP_NUM_THREADS=0 taskset -c 0 onggi_bench --benchmark_filter=frame
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

// A hollow vase of the studio's clay with throwing rings of 0.3 mm, which shrinks by a hair each frame and
// grows back. Rough: with 150 grooves besides, a pixel each.
struct Vase {
    explicit Vase(bool is_rough) : rough_mm(is_rough ? 0.25 : 0.0) {
        for (int i = 0; i < kElements; ++i) {
            top_mm.push_back(static_cast<float>((i + 1) * kHeightMm / kElements));
            film.push_back(0.7F);
            liquidity.push_back(0.6F);
        }
        radii_mm.resize(kElements);
        inner_mm.resize(kElements);
    }
    void throw_a_little(std::int64_t frame) {
        const double breath = 0.2 * std::sin(0.1 * static_cast<double>(frame));
        for (int i = 0; i < kElements; ++i) {
            const double y = (i + 0.5) * kHeightMm / kElements;
            const double belly = (y - 70.0) / 52.0;
            const double radius = 32.0 + 24.0 * std::exp(-belly * belly) +
                                  0.3 * std::sin(y * 0.78 + 2.3 * std::sin(y * 0.026)) +
                                  rough_mm * std::sin(y * 2.0 * 3.14159265 * 150.0 / kHeightMm) + breath;
            const auto at = static_cast<std::size_t>(i);
            radii_mm[at] = static_cast<float>(radius);
            inner_mm[at] = y < 10.0 ? 0.0F : static_cast<float>(radius - 5.0);
        }
    }
    double rough_mm;
    std::vector<float> radii_mm;
    std::vector<float> inner_mm;
    std::vector<float> top_mm;
    std::vector<float> film;
    std::vector<float> liquidity;
};

void frame(benchmark::State& state, int width, int height, bool is_rough) {
    auto view = wheel::LiveView::open({.width = width, .height = height, .headless = true});
    if (!view) return fail(state, view.error().message.c_str());
    Vase vase(is_rough);
    jobs::Histogram taken_ns;
    StopWatch watch;
    std::int64_t number = 0;
    for ([[maybe_unused]] auto iteration : state) {
        vase.throw_a_little(number);
        const double angle = 0.2 * static_cast<double>(number++);
        watch.start();
        const auto drawn =
            (*view)->draw({.radii_mm = vase.radii_mm,
                           .inner_mm = vase.inner_mm,
                           .top_mm = vase.top_mm,
                           .height_mm = kHeightMm,
                           .floor_mm = 10.0,
                           .film = vase.film,
                           .liquidity = vase.liquidity,
                           .hand = {.position_mm = {70.0, 100.0 + 20.0 * std::sin(0.05 * angle), 0.0}},
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
    frame(state, 1280, 720, false);
}
BENCHMARK(frame_720p)->Name("frame/1280x720")->UseManualTime()->Unit(benchmark::kMillisecond);

void frame_720p_rough(benchmark::State& state) {
    frame(state, 1280, 720, true);
}
BENCHMARK(frame_720p_rough)->Name("frame/1280x720/rough")->UseManualTime()->Unit(benchmark::kMillisecond);

void frame_1080p(benchmark::State& state) {
    frame(state, 1920, 1080, false);
}
BENCHMARK(frame_1080p)->Name("frame/1920x1080")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace onggi::bench
