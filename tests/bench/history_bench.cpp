// session_undo/M: what a session of M minutes at 1 kHz costs the keeper: following it (the time of the
// benchmark), and undoing the last of its moves. Counters: follow_ns of a tick; undo_ms of the last move,
// undo_ticks replayed for it, and far_ticks, the most that any undo within the session replays.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "game/haptic/history.h"
#include "tests/bench/bench_failure.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::bench {
namespace {

constexpr double kRateHz = 1000.0;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void session_undo(benchmark::State& state) {
    constexpr auto kThrow = static_cast<std::uint64_t>(test::kStudioHandSeconds * kRateHz);
    const auto ticks =
        static_cast<std::uint64_t>(state.range(0)) * static_cast<std::uint64_t>(60.0 * kRateHz);
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(kRateHz);
    haptic::History history(test::studio_start(), parameters);
    for ([[maybe_unused]] auto iteration : state) {
        const auto start = std::chrono::steady_clock::now();
        for (std::uint64_t tick = 0; tick < ticks; ++tick)
            history.add_played(test::studio_hand(tick % kThrow, kRateHz));
        state.counters["follow_ns"] = 1e9 * seconds_since(start) / static_cast<double>(ticks);
    }
    const auto before = history.before_last_move();
    if (!before) return fail(state, "no move was made");
    const auto start = std::chrono::steady_clock::now();
    if (!history.state_at(*before)) return fail(state, "the move was not undone");
    state.counters["undo_ms"] = 1e3 * seconds_since(start);
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
