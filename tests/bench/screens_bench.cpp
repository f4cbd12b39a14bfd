// frame/1280x720/...: frames of the kiosk's own screens over the live picture, as frame/1280x720 otherwise.
// Screens are composed beforehand, as the kiosk composes them beside its frames.
//   screen     the throwing screen, whole, at rest
//   words      while it changes its language: English, Korean, Arabic
//   screens    while one screen fades into the next, through a visit
#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/jobs/histogram.h"
#include "game/screens/stage.h"
#include "game/visit/steps.h"
#include "tests/bench/bench_failure.h"
#include "tests/bench/frame_case.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::bench {
namespace {

using Screens = std::vector<std::shared_ptr<const screens::Composed>>;

// A screen in a language; null if there is none of that name.
class Composing {
  public:
    std::shared_ptr<const screens::Composed> composed(const std::string& language, const std::string& name) {
        for (const screens::SampleView& sample : screens::sample_views({.language = language})) {
            if (sample.name != name) continue;
            return std::make_shared<const screens::Composed>(
                screens::Composed{sample.view, visit::compose(*sample.view, painter_, store_)});
        }
        return nullptr;
    }

  private:
    ui::Painter painter_;
    screens::PaintingStore store_{painter_};
};

// Shows each screen for half a second; counts the frames in which the stage changes, or those in which it
// rests.
void screen_frames(benchmark::State& state, const Screens& shown, bool counts_changes) {
    constexpr int kFramesEach = 30;
    constexpr double kFrameS = 1.0 / 60.0;
    if (shown.empty() || std::count(shown.begin(), shown.end(), nullptr) > 0)
        return fail(state, "a screen is missing");
    auto opened = FrameCase::open({.with_text = false});
    if (!opened) return fail(state, opened.error().message.c_str());
    screens::Stage stage;
    jobs::Histogram wall_ns;
    double least_processor_s = std::numeric_limits<double>::infinity();
    double most_processor_s = 0.0;
    std::size_t number = 0;
    for ([[maybe_unused]] auto iteration : state) {
        FrameTime time;
        bool counts = false;
        do {
            const double now_s = static_cast<double>(number) * kFrameS;
            stage.take(shown[number / kFramesEach % shown.size()], now_s);
            const ui::DrawList& list = stage.draw({.now_s = now_s});
            const render::Overlay overlay{.list = &list,
                                          .uploads = stage.uploads(),
                                          .atlas_side_px = stage.atlas_side_px(),
                                          .scene_rests = stage.scene_rests(),
                                          .covers = stage.covers()};
            const auto taken = (*opened)->frame(&overlay);
            if (!taken) return fail(state, taken.error().message.c_str());
            time = *taken;
            // In the first round every picture is new to the device, as at the kiosk's start.
            counts = number >= kFramesEach * shown.size() && stage.changes(now_s) == counts_changes;
            ++number;
        } while (!counts);
        state.SetIterationTime(time.wall_s);
        wall_ns.record(static_cast<std::int64_t>(time.wall_s * 1e9));
        least_processor_s = std::min(least_processor_s, time.processor_s);
        most_processor_s = std::max(most_processor_s, time.processor_s);
    }
    state.counters["p50_ms"] = static_cast<double>(wall_ns.percentile(0.5)) * 1e-6;
    state.counters["p99_ms"] = static_cast<double>(wall_ns.percentile(0.99)) * 1e-6;
    state.counters["least_processor_ms"] = least_processor_s * 1e3;
    state.counters["most_processor_ms"] = most_processor_s * 1e3;
    state.SetLabel((*opened)->device_name());
}

void add(const std::string& name, const std::vector<std::pair<std::string, std::string>>& shown,
         bool counts_changes) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [shown, counts_changes](benchmark::State& state) {
                                     Composing composing;
                                     Screens made;
                                     for (const auto& [language, screen] : shown)
                                         made.push_back(composing.composed(language, screen));
                                     screen_frames(state, made, counts_changes);
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

const bool added = [] {
    add("frame/1280x720/screen", {{"en", "throw-0"}}, false);
    add("frame/1280x720/words", {{"en", "throw-0"}, {"ko", "throw-0"}, {"ar", "throw-0"}}, true);
    add("frame/1280x720/screens",
        {{"en", "attract"},
         {"en", "choose"},
         {"en", "throw-0"},
         {"en", "firing-0"},
         {"en", "glaze-0"},
         {"en", "your-pot"},
         {"en", "keep"}},
        true);
    return true;
}();

}  // namespace
}  // namespace onggi::bench
