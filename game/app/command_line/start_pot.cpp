#include "game/app/command_line/start_pot.h"

#include <fmt/format.h>

#include <utility>

#include "engine/core/quote.h"
#include "game/app/command_line/performance.h"
#include "game/clay/studio/joining.h"

namespace onggi::app {
namespace {

// The pot at the end of a session, back on the wheel.
Result<clay::StudioClay> pot_left_by(const std::string& file) {
    auto loaded = load_session(file);
    if (!loaded) return loaded.error();
    haptic::HapticState& state = loaded->start.state;
    if (state.studio() == nullptr) {
        return bad_input(fmt::format("{}: expected a session of the studio clay, found one of the paper's",
                                     shown_path(file)));
    }
    const std::uint64_t ticks = loaded->session.tick_count();
    record::SessionPlayer hand(std::move(loaded->session));
    if (auto opened = hand.open(); !opened) return opened.error();
    for (std::uint64_t tick = 0; tick < ticks; ++tick)
        haptic::tick(state, hand.read(tick, loaded->start.parameters.dt_s()), loaded->start.parameters);
    hand.close();
    clay::StudioClay pot = std::move(*state.studio());
    pot.put_back();
    return pot;
}

}  // namespace

Result<std::optional<clay::StudioClay>> start_pot(const StartPot& options) {
    if (!options.on) return std::optional<clay::StudioClay>();
    auto lower = pot_left_by(*options.on);
    if (!lower) return lower.error();
    if (!options.joined) return std::optional(std::move(lower).value());
    auto upper = pot_left_by(*options.joined);
    if (!upper) return upper.error();
    auto pot = clay::join_pots(*lower, *upper, {.mouth_mm = options.mouth_mm.value_or(0.0)});
    if (!pot) return pot.error();
    return std::optional(std::move(pot).value());
}

}  // namespace onggi::app
