#include "engine/haptics/hid/force_gate.h"

#include <algorithm>
#include <cmath>

namespace onggi::haptics::hid {

ForceOrder ForceGate::passed(const ForceOrder& order, std::int64_t now_ns) noexcept {
    ForceOrder allowed = order;
    allowed.force_n = dvec2(0.0);
    allowed.tangential_n = 0.0;

    if (order.ticks != last_ticks_) {
        last_ticks_ = order.ticks;
        last_order_ns_ = now_ns;
    }
    const bool is_silent = order.ticks == 0 || now_ns - last_order_ns_ > limits_.silence_ns;
    allowed.is_starved = order.ticks != 0 && now_ns - last_order_ns_ > limits_.starved_ns;
    const double size_n = std::sqrt(order.force_n.x * order.force_n.x + order.force_n.y * order.force_n.y +
                                    order.tangential_n * order.tangential_n);
    const bool is_number =
        std::isfinite(size_n) && std::isfinite(order.tool_mm.x) && std::isfinite(order.tool_mm.y);
    if (is_silent || !is_number) {
        restart();
        return allowed;
    }
    if (ramp_since_ns_ == kNotYet) {
        if (size_n > limits_.small_n) return allowed;
        ramp_since_ns_ = now_ns;
    }
    const double ramp = std::clamp(
        static_cast<double>(now_ns - ramp_since_ns_) / static_cast<double>(limits_.ramp_ns), 0.0, 1.0);
    fraction_ = ramp * (size_n > limits_.peak_n ? limits_.peak_n / size_n : 1.0);
    allowed.force_n = fraction_ * order.force_n;
    allowed.tangential_n = fraction_ * order.tangential_n;
    return allowed;
}

}  // namespace onggi::haptics::hid
