#include "engine/haptics/hid/tool_tracker.h"

#include <cmath>

namespace onggi::haptics::hid {

HandSample ToolTracker::moved(const DeviceInput& input, double dt_s) noexcept {
    silence_s_ = input.heartbeat == last_heartbeat_ ? silence_s_ + dt_s : 0.0;
    last_heartbeat_ = input.heartbeat;
    was_refreshed_ = input.refreshed != last_refreshed_;
    last_refreshed_ = input.refreshed;
    is_live_ = input.is_live && silence_s_ <= kSilenceS;

    if (is_live_) {
        const double most_mm = kFastestMmS * dt_s;
        place_mm_ += input.travelled_mm - travelled_mm_;
        if (input.motion == DeviceInput::Motion::kRate) place_mm_ += input.rate_mm_s * dt_s;
        if (input.motion == DeviceInput::Motion::kPlace) {
            const dvec2 way = input.place_mm - place_mm_;
            const double length = std::sqrt(way.x * way.x + way.y * way.y);
            place_mm_ = length <= most_mm ? input.place_mm : place_mm_ + way * (most_mm / length);
        }
        place_mm_ = reach_.within(place_mm_);
        press_mm_ += std::clamp(input.press_mm - press_mm_, -most_mm, most_mm);
        rev_min_ = std::clamp(input.rev_min > 0.0 ? input.rev_min : rev_min_ + input.change_rev_min_s * dt_s,
                              kSlowestRevMin, kFastestRevMin);
    }
    // Travel while the input was not live is dropped, which avoids a jump.
    travelled_mm_ = input.travelled_mm;
    if (is_live_) watch(input, dt_s);

    const dvec2 tool_mm = reach_.within({place_mm_.x - press_mm_, place_mm_.y});
    return {
        .position_mm = {tool_mm.x, tool_mm.y, 0.0}, .button = is_live_ && input.button, .rev_min = rev_min_};
}

// The hand's own motion, independent of the tool: a stick's position, a trigger's press, a push.
void ToolTracker::watch(const DeviceInput& input, double dt_s) noexcept {
    const bool pushes = input.motion == DeviceInput::Motion::kRate && input.rate_mm_s != dvec2(0.0);
    // A joystick's button may be a switch that stays on; a pedal has no switch.
    const bool foot_is_down = input.motion == DeviceInput::Motion::kNone && input.buttons != 0;
    const bool is_pushed = push_.moved_to({input.push.x, input.push.y, 0.0}, dt_s, pushes);
    const bool is_held =
        hold_.moved_to({input.place_mm.x, input.place_mm.y, input.press_mm}, dt_s, input.press_mm > kNoiseMm);
    const bool travels = travel_.moved_to({input.travelled_mm.x, input.travelled_mm.y, 0.0}, dt_s);
    const bool presses =
        buttons_.moved_to({static_cast<double>(input.buttons), 0.0, 0.0}, dt_s, foot_is_down);
    hand_lives_ = is_pushed || is_held || travels || presses;
    hand_moves_ = hand_lives_ || (pushes && push_.still_s() < kControlRestsS);
}

}  // namespace onggi::haptics::hid
