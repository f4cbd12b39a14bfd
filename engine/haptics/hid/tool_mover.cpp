#include "engine/haptics/hid/tool_mover.h"

#include <cmath>

namespace onggi::haptics::hid {

ToolState ToolMover::moved(const HandInput& input, double dt_s) noexcept {
    silence_s_ = input.heartbeat == last_heartbeat_ ? silence_s_ + dt_s : 0.0;
    last_heartbeat_ = input.heartbeat;
    is_live_ = input.is_live && silence_s_ <= kSilenceS;

    if (is_live_) {
        const double most_mm = kFastestMmS * dt_s;
        if (input.motion == HandInput::Motion::kRate) place_mm_ += input.rate_mm_s * dt_s;
        if (input.motion == HandInput::Motion::kPlace) {
            const dvec2 way = input.place_mm - place_mm_;
            const double length = std::sqrt(way.x * way.x + way.y * way.y);
            place_mm_ = length <= most_mm ? input.place_mm : place_mm_ + way * (most_mm / length);
        }
        place_mm_ = reach_.within(place_mm_);
        press_mm_ += std::clamp(input.press_mm - press_mm_, -most_mm, most_mm);
    }
    const dvec2 tool_mm = reach_.within({place_mm_.x - press_mm_, place_mm_.y});
    return {.position_mm = {tool_mm.x, tool_mm.y, 0.0},
            .radius_mm = reach_.tool_radius_mm,
            .wheel_button = is_live_ && input.wheel_button};
}

}  // namespace onggi::haptics::hid
