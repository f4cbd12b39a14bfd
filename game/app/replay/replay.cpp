#include "game/app/replay/replay.h"

#include <fmt/format.h>

#include <utility>

#include "game/app/replay/session_marks.h"
#include "game/haptic/pot_copy.h"

namespace onggi::app {

std::string sentence_for(const Difference& difference) {
    if (difference.after_all) return "every tick is as recorded, but " + difference.what;
    if (difference.first_tick == difference.last_tick) {
        return fmt::format("tick {} is the first that differs: {}", difference.first_tick, difference.what);
    }
    return fmt::format("the first tick that differs is one of {} to {}: {}", difference.first_tick,
                       difference.last_tick, difference.what);
}

Replay::Replay(const record::Session& session, haptic::Start start)
    : session_(session),
      start_(std::move(start)),
      cursor_(session) {}

std::optional<Difference> Replay::compare_start() const {
    if (start_.state.hash() == session_.header().start_state_hash) return std::nullopt;
    return Difference{.what = "the start state is not the one that was recorded"};
}

std::optional<Difference> Replay::step() {
    const std::uint64_t tick = ticks_++;
    last_ = haptic::tick(start_.state, cursor_.at(tick), start_.parameters);
    if (!session_.has_force_at(tick, last_.forces.total_n()))
        return Difference{
            .first_tick = tick, .last_tick = tick, .what = "its force is not the one that was recorded"};
    const record::Session::Block& block = session_.blocks()[block_];
    if (ticks_ < block.first_tick + block.tick_count) return std::nullopt;
    ++block_;
    if (start_.state.hash() == block.state_hash) return std::nullopt;
    return Difference{.first_tick = block.first_tick,
                      .last_tick = tick,
                      .what = "every force is as recorded, but the state after them is not"};
}

namespace {

std::optional<Difference> compare_decoration(const decoration::Recorded& recorded,
                                             const haptic::HapticState& state) {
    if (recorded.strokes.empty()) return std::nullopt;
    const pot::Pot pot = haptic::pot_of(state);
    if (pot.ring_count() == 0) return Difference{.what = "no pot is left for its strokes", .after_all = true};
    const auto canvas = decoration::Canvas::of(wall_of(pot), recorded.strokes);
    if (!canvas) return Difference{.what = canvas.error().message, .after_all = true};
    if (canvas->texture().hash() == recorded.texture_hash) return std::nullopt;
    return Difference{.what = "its strokes give another texture than recorded", .after_all = true};
}

}  // namespace

std::optional<Difference> find_difference(const record::Session& session, haptic::Start start,
                                          const decoration::Recorded& decoration,
                                          const std::function<void(std::uint64_t)>& reached) {
    Replay replay(session, std::move(start));
    if (auto difference = replay.compare_start()) return difference;
    while (!replay.is_over()) {
        if (auto difference = replay.step()) return difference;
        if (reached) reached(replay.ticks() - 1);
    }
    return compare_decoration(decoration, replay.state());
}

}  // namespace onggi::app
