// frame/...: one frame of the live picture with everything in it, drawn into memory: the cost of a frame
// without presenting it. Pin it to one core for the kiosk's conditions: LP_NUM_THREADS=0 taskset -c 0
// onggi_bench --benchmark_filter=frame
//   frame/WxH, frame/WxH/rough      at rest; rough: 150 grooves, of a pixel each at 1280x720
//   frame/1280x720/view_change, /evening     while another view is made and fades in, while the light changes
//   frame/WxH/two_threads           a second thread, on the last core, draws half of a large picture
//   frame/WxH/drawn                 while a finger draws on the pot, its new point laid in the same frame
//   frame/1280x720/trimmed          shavings fly, the rib lies on the bench
//   frame_by/...                    by the picture's content and quality
//   frame_cost/BACKEND/WxH          the device's work for a frame, with the CPU backend and on a GPU's
//   quality steps; also with a modelled instead of a photographed room frame_parts/1280x720            its
//   parts, by the device's clock and by the host's
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "engine/jobs/histogram.h"
#include "engine/jobs/thread_setup.h"
#include "tests/bench/bench_failure.h"
#include "tests/bench/frame_case.h"

namespace onggi::bench {
namespace {

int last_core() {
    return jobs::choose_haptic_core().core;
}

// Advances the scene before each frame; whether a frame counts is known after it is drawn.
struct Motion {
    std::function<void(FrameCase&, std::int64_t)> before = [](FrameCase&, std::int64_t) {};
    std::function<bool(const FrameCase&)> counts = [](const FrameCase&) { return true; };
};

void report(benchmark::State& state, const jobs::Histogram& wall_ns, double least_wall_s,
            double least_processor_s) {
    state.counters["p50_ms"] = static_cast<double>(wall_ns.percentile(0.5)) * 1e-6;
    state.counters["p99_ms"] = static_cast<double>(wall_ns.percentile(0.99)) * 1e-6;
    state.counters["least_ms"] = least_wall_s * 1e3;
    state.counters["least_processor_ms"] = least_processor_s * 1e3;
}

void frame(benchmark::State& state, const FrameCaseDesc& desc, const Motion& motion) {
    auto opened = FrameCase::open(desc);
    if (!opened) return fail(state, opened.error().message.c_str());
    FrameCase& drawn = **opened;
    jobs::Histogram wall_ns;
    double least_wall_s = std::numeric_limits<double>::infinity();
    double least_processor_s = least_wall_s;
    std::int64_t number = 0;
    for ([[maybe_unused]] auto iteration : state) {
        FrameTime time;
        do {
            motion.before(drawn, number++);
            const auto taken = drawn.frame();
            if (!taken) return fail(state, taken.error().message.c_str());
            time = *taken;
        } while (!motion.counts(drawn));
        state.SetIterationTime(time.wall_s);
        wall_ns.record(static_cast<std::int64_t>(time.wall_s * 1e9));
        least_wall_s = std::min(least_wall_s, time.wall_s);
        least_processor_s = std::min(least_processor_s, time.processor_s);
    }
    const auto picture = drawn.read_back();
    if (!picture || picture->rgba.at(0) == 0) fail(state, "the picture is empty");
    report(state, wall_ns, least_wall_s, least_processor_s);
    const render::FrameStats& stats = drawn.stats();
    state.counters["rings"] = stats.rings;
    state.counters["draws"] = stats.work.draws;
    state.counters["vertices"] = static_cast<double>(stats.work.vertices);
    state.counters["uploaded_kb"] = static_cast<double>(stats.work.uploaded_bytes) * 1e-3;
    state.counters["device_ms"] = stats.device_ms;
    state.SetLabel(drawn.device_name());
}

void add(const std::string& name, const FrameCaseDesc& desc, const Motion& motion = {}) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [desc, motion](benchmark::State& state) { frame(state, desc, motion); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

// Changes the view to and fro; counts every frame of a change, from the first in which the other view is
// rendered.
Motion changing_view() {
    return {.before =
                [](FrameCase& drawn, std::int64_t number) {
                    drawn.scene().look_at(number / 60 % 2 == 0 ? wheel::View::kLookingIn
                                                               : wheel::View::kThrowing);
                },
            .counts = [](const FrameCase& drawn) { return drawn.view_changes(); }};
}

Motion dimming() {
    return {
        .before = [](FrameCase& drawn,
                     std::int64_t number) { drawn.scene().set_evening(number / 120 % 2 == 0 ? 1.0 : 0.0); },
        .counts = [](const FrameCase& drawn) { return drawn.light_changes(); }};
}

// The least time of each part.
void frame_parts(benchmark::State& state, const FrameCaseDesc& desc) {
    auto opened = FrameCase::open(desc);
    if (!opened) return fail(state, opened.error().message.c_str());
    std::map<std::string, double> least_ms;
    for ([[maybe_unused]] auto iteration : state) {
        const auto taken = (*opened)->frame();
        if (!taken) return fail(state, taken.error().message.c_str());
        state.SetIterationTime(taken->wall_s);
        double all_ms = 0.0;
        std::map<std::string, double> ms;
        for (const render::PassTime& part : (*opened)->stats().parts) {
            ms[part.name] += part.ms;
            all_ms += part.ms;
        }
        ms["all of them"] = all_ms;
        for (const auto& [name, value] : ms) {
            const auto [at, is_new] = least_ms.emplace(name, value);
            if (!is_new) at->second = std::min(at->second, value);
        }
    }
    for (const auto& [name, value] : least_ms)
        state.counters[name] = value;
}
BENCHMARK_CAPTURE(frame_parts, small, {.measures_parts = true})
    ->Name("frame_parts/1280x720")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frame_parts, large,
                  {.width = 3840, .height = 2160, .measures_parts = true, .second_thread_on = last_core()})
    ->Name("frame_parts/3840x2160/two_threads")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

const bool added = [] {
    constexpr int kGrooves = 150;
    add("frame/1280x720", {});
    add("frame/1280x720/rough", {.grooves = kGrooves});
    add("frame/1280x720/view_change", {}, changing_view());
    add("frame/1280x720/evening", {}, dimming());
    add("frame/1280x720/drawn", {.with_hands = false, .is_drawn_on = true});
    add("frame/1280x720/trimmed", {.is_trimmed = true});
    add("frame/1920x1080/drawn", {.width = 1920, .height = 1080, .with_hands = false, .is_drawn_on = true});
    add("frame/1920x1080", {.width = 1920, .height = 1080});
    add("frame/1920x1080/view_change", {.width = 1920, .height = 1080}, changing_view());
    add("frame/1920x1080/rough", {.width = 1920, .height = 1080, .grooves = kGrooves});
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {2560, 1440}, {3840, 2160}}) {
        if (height > 1080) add(fmt::format("frame/{}x{}", width, height), {.width = width, .height = height});
        add(fmt::format("frame/{}x{}/two_threads", width, height),
            {.width = width, .height = height, .second_thread_on = last_core()});
    }
    for (const auto& [backend, step] : {std::pair{"cpu", render::QualityStep::kOneCore},
                                        {"gpu_half", render::QualityStep::kSlowestGpu},
                                        {"gpu", render::QualityStep::kIntegratedGpu},
                                        {"gpu_finest", render::QualityStep::kDiscreteGpu}}) {
        for (const int height : {720, 1080, 2160}) {
            const int width = height * 16 / 9;
            add(fmt::format("frame_cost/{}/{}x{}", backend, width, height),
                {.width = width, .height = height, .step = step});
        }
        add(fmt::format("frame_cost/{}/1280x720/modelled_room", backend),
            {.is_modelled = true, .step = step});
    }
    add("frame_by/no_hands", {.with_hands = false});
    add("frame_by/no_text", {.with_text = false});
    for (const int sectors : {32, 48, 64, 96, 128})
        add("frame_by/sectors/" + std::to_string(sectors), {.sectors = sectors});
    for (const int rings : {40, 64, 96, 128, 256})
        add("frame_by/most_rings/" + std::to_string(rings), {.grooves = kGrooves, .max_rings = rings});
    for (const int grooves : {0, 30, 60, 150, 300})
        add("frame_by/grooves/" + std::to_string(grooves), {.grooves = grooves});
    for (const int height : {480, 600, 720, 900, 1080})
        add("frame_by/lines/" + std::to_string(height), {.width = height * 16 / 9, .height = height});
    return true;
}();

}  // namespace
}  // namespace onggi::bench
