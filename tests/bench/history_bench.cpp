// session_undo/M: what a session of M minutes at 1 kHz costs the keeper. Counters, in processor time:
// follow_ns, to follow one tick; undo_ms, to undo the last move. undo_ticks are the ticks that this undo
// replays; far_ticks are the most that the undo of any move replays.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <ctime>

#include "game/haptic/history.h"
#include "tests/bench/bench_failure.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::bench {
namespace {

constexpr double kRateHz = 1000.0;

// Processor time of this process, s.
double worked_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void session_undo(benchmark::State& state) {
    constexpr auto kThrow = static_cast<std::uint64_t>(test::kStudioHandSeconds * kRateHz);
    const auto ticks =
        static_cast<std::uint64_t>(state.range(0)) * static_cast<std::uint64_t>(60.0 * kRateHz);
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(kRateHz);
    haptic::History history(test::studio_start(), parameters);
    for ([[maybe_unused]] auto iteration : state) {
        const double start = worked_s();
        for (std::uint64_t tick = 0; tick < ticks; ++tick)
            history.add_played(test::studio_hand(tick % kThrow, kRateHz));
        state.counters["follow_ns"] = 1e9 * (worked_s() - start) / static_cast<double>(ticks);
    }
    const auto before = history.before_last_move();
    if (!before) return fail(state, "no move was made");
    const double start = worked_s();
    if (!history.state_at(*before)) return fail(state, "the move was not undone");
    state.counters["undo_ms"] = 1e3 * (worked_s() - start);
    state.counters["undo_ticks"] = static_cast<double>(history.ticks_to_replay(*before));
    std::uint64_t most = 0;
    for (const haptic::Move& move : history.moves())
        most = std::max(most, history.ticks_to_replay(move.first_tick));
    state.counters["far_ticks"] = static_cast<double>(most);
    state.counters["moves"] = static_cast<double>(history.moves().size());
}

BENCHMARK(session_undo)->Arg(5)->Arg(15)->Arg(60)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace onggi::bench
