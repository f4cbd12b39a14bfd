// stroke_point/N: the cost of adding a point to a stroke N mm wide within a frame, including the update of
// the picture. stroke_undo: undoing the last of many strokes.
#include <benchmark/benchmark.h>

#include "game/finish/glaze.h"
#include "game/look/lathe_marks.h"
#include "tests/bench/bench_failure.h"

namespace onggi::bench {
namespace {

decoration::Wall straight_wall() {
    const std::vector<vec2> outline{{60.0F, 0.0F}, {60.0F, 160.0F}};
    return decoration::wall_of(outline);
}

void stroke_point(benchmark::State& state) {
    decoration::Canvas canvas(straight_wall());
    look::DressedMarks dressed;
    const finish::MarkPalette& raw = finish::wet_clay().marks;
    dressed.dress(canvas.texture(), canvas.wall(), raw);
    static_cast<void>(canvas.take_changed());
    const decoration::Stroke stroke{.technique = decoration::Technique::kFinger,
                                    .width = static_cast<std::uint16_t>(100 * state.range(0))};
    std::size_t points = decoration::kMostPointsOfStroke;
    double turns = 0.0;
    for ([[maybe_unused]] auto iteration : state) {
        if (points == decoration::kMostPointsOfStroke) {
            state.PauseTiming();
            while (canvas.undo()) {
            }
            if (!canvas.begin(stroke)) return fail(state, "no stroke was begun");
            static_cast<void>(canvas.take_changed());
            points = 0;
            state.ResumeTiming();
        }
        turns += 0.004;
        if (!canvas.add(decoration::stroke_point(turns, 80.0).value()))
            return fail(state, "no point was laid");
        dressed.dress_changed(canvas.texture(), canvas.wall(), raw, canvas.take_changed());
        ++points;
    }
}
BENCHMARK(stroke_point)->Arg(4)->Arg(20)->Arg(36);

void stroke_undo(benchmark::State& state) {
    decoration::Canvas canvas(straight_wall());
    const auto draw = [&](int number) {
        return static_cast<bool>(
            canvas.begin({.technique = decoration::Technique::kIron,
                          .width = 400,
                          .points = {decoration::stroke_point(0.1 * number, 40.0).value(),
                                     decoration::stroke_point(0.1 * number + 0.2, 120.0).value()}}));
    };
    for (int i = 0; i < 39; ++i) {
        if (!draw(i)) return fail(state, "no stroke was drawn");
    }
    for ([[maybe_unused]] auto iteration : state) {
        state.PauseTiming();
        const bool drawn = draw(40);
        state.ResumeTiming();
        if (!drawn || !canvas.undo()) return fail(state, "nothing was taken back");
    }
}
BENCHMARK(stroke_undo);

}  // namespace
}  // namespace onggi::bench
