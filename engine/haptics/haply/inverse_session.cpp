#include "engine/haptics/haply/inverse_session.h"

#include <fmt/format.h>

#include <utility>

namespace onggi::haptics::haply {
namespace {

using hid::HidStatus;
using hid::kMs;

constexpr double kMmPerM = 1000.0;
constexpr double kNsPerS = 1e9;
// The service may lose a message, so it is repeated after this time.
constexpr std::int64_t kSayAgainNs = 100 * kMs;
constexpr std::int64_t kSilenceNs = 2000 * kMs;
// The poll interval while no device is plugged in.
constexpr std::int64_t kAskNs = 1000 * kMs;

}  // namespace

InverseSession::InverseSession(InverseLink& link, const InverseOptions& options)
    : link_(link),
      options_(options),
      gate_({.peak_n = options.peak_n}) {}

void InverseSession::opened() {
    is_open_ = true;
    has_spoken_ = was_heard_ = false;
    is_answered_ = true;
    device_id_.clear();
    gate_.restart();
}

Result<void> InverseSession::take(std::string_view message, std::int64_t now_ns) {
    const auto state = inverse_state(message);
    if (!state) return state.error();
    heard_ns_ = now_ns;
    was_heard_ = true;
    is_answered_ = true;
    if (!*state) {
        if (!device_id_.empty()) {
            device_id_.clear();
            link_.input.put({.heartbeat = ++heartbeat_});
            publish({});
        }
        return {};
    }
    const InverseState& now = **state;
    if (now.device_id != device_id_) {
        // Another device, or this one plugged in again: restart its force ramp and its position.
        device_id_ = now.device_id;
        first_m_ = now.cursor_m;
        gate_.restart();
        publish({.state = HidStatus::State::kReady,
                 .name = "Haply Inverse3 " + device_id_,
                 .path = fmt::format("{}:{}", options_.host, options_.port),
                 .is_heard = true,
                 .times_found = status_.times_found + 1});
    }
    link_.input.put({.place_mm = wheel_from_service(now.cursor_m - first_m_) * kMmPerM,
                     .is_live = true,
                     .force_fraction = gate_.fraction(),
                     .heartbeat = ++heartbeat_});
    return {};
}

std::string InverseSession::next_message(std::int64_t now_ns) {
    if (!is_open_ || !was_heard_) return {};  // the service sends the first message
    const std::int64_t since_ns = now_ns - sent_ns_;
    const bool is_first = !has_spoken_;
    if (device_id_.empty()) {
        if (!is_first && since_ns < kAskNs) return {};
        has_spoken_ = true;
        is_answered_ = false;
        sent_ns_ = now_ns;
        return is_first ? R"({"session":{"configure":{"profile":{"name":"onggi"}}}})" : "{}";
    }
    const std::uint32_t silences = link_.silences.load(std::memory_order_relaxed);
    if (std::exchange(silences_, silences) != silences) {
        gate_.restart();
        has_spoken_ = true;
        is_answered_ = false;
        sent_ns_ = now_ns;
        return probe_message(device_id_, is_first);
    }
    const auto period_ns = static_cast<std::int64_t>(kNsPerS / options_.rate_hz);
    if (!is_first && since_ns < (is_answered_ ? period_ns : kSayAgainNs)) return {};
    has_spoken_ = true;
    is_answered_ = false;
    sent_ns_ = now_ns;

    const SpaceOrder& order = link_.order.latest();
    const hid::ForceOrder allowed = gate_.passed({.force_n = {order.force_n.x, order.force_n.y},
                                                  .tangential_n = order.force_n.z,
                                                  .ticks = order.ticks},
                                                 now_ns);
    const dvec3 force_n(allowed.force_n.x, allowed.force_n.y, allowed.tangential_n);
    if (force_n == dvec3(0.0)) return probe_message(device_id_, is_first);
    return force_message(device_id_, service_from_wheel(force_n), options_.force_name, is_first);
}

std::string InverseSession::last_message() const {
    return device_id_.empty() ? std::string()
                              : force_message(device_id_, dvec3(0.0), options_.force_name, false);
}

bool InverseSession::is_silent(std::int64_t now_ns) const {
    return is_open_ && has_spoken_ && !is_answered_ && now_ns - heard_ns_ > kSilenceNs;
}

void InverseSession::closed(const std::string& why) {
    is_open_ = false;
    device_id_.clear();
    link_.input.put({.heartbeat = ++heartbeat_});
    if (why.empty()) return publish({});
    publish({.state = HidStatus::State::kFailed,
             .name = "Haply Inverse service",
             .path = fmt::format("{}:{}", options_.host, options_.port),
             .message = why});
}

void InverseSession::publish(HidStatus status) {
    status.times_found = std::max(status.times_found, status_.times_found);
    status_ = std::move(status);
    link_.status.put(status_);
}

}  // namespace onggi::haptics::haply
