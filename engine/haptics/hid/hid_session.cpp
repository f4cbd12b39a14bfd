#include "engine/haptics/hid/hid_session.h"

#include <algorithm>
#include <array>
#include <utility>

namespace onggi::haptics::hid {

HidSession::HidSession(HidLink& link, std::unique_ptr<HidBus> bus, std::unique_ptr<HidDriver> driver,
                       const HidSessionOptions& options)
    : link_(link),
      bus_(std::move(bus)),
      driver_(std::move(driver)),
      options_(options),
      gate_(options.force) {}

std::int64_t HidSession::round(std::int64_t now_ns) noexcept {
    if (!port_ && (!next_search_ns_ || now_ns >= *next_search_ns_)) search(now_ns);
    if (!port_) return std::max<std::int64_t>(*next_search_ns_ - now_ns, 1);
    exchange(now_ns);
    return port_ ? 0 : std::max<std::int64_t>(*next_search_ns_ - now_ns, 1);
}

void HidSession::search(std::int64_t now_ns) {
    next_search_ns_ = now_ns + kSearchIntervalNs;
    const auto devices = bus_->list();
    if (!devices) {
        publish(HidStatus{.state = HidStatus::State::kFailed, .message = devices.error().message});
        return;
    }
    // Uses the first device that starts. If none does, reports the first failure; if none may be used, the
    // reason.
    HidStatus told;
    rivals_.clear();
    for (const HidDeviceInfo& device : *devices) {
        if (device.kind != options_.kind) continue;
        if (!options_.only.empty() && device.path != options_.only) continue;
        if (port_) {
            if (device.refusal.empty()) rivals_.push_back({.info = device, .port = nullptr, .firsts = {}});
            continue;
        }
        HidStatus status = begin(device);
        if (status.state == HidStatus::State::kReady) {
            gate_.restart();
            next_presence_ns_ = now_ns + kPresenceIntervalNs;
            ++status.times_found;
            publish(std::move(status));
            continue;
        }
        const bool is_worse =
            told.state != HidStatus::State::kFailed && status.state == HidStatus::State::kFailed;
        if (told.state == HidStatus::State::kAbsent || is_worse) told = std::move(status);
    }
    if (!port_) publish(std::move(told));
}

bool HidSession::has_moved(FirstReports& firsts, std::span<const std::uint8_t> report) const {
    const auto first = std::ranges::find_if(firsts, [&](const Report& known) {
        return known.size == report.size() && known.bytes[0] == report[0];
    });
    if (first != firsts.end()) return driver_->has_moved(first->view(), report);
    constexpr std::size_t kMostIds = 16;
    if (firsts.size() < kMostIds) {
        Report& added = firsts.emplace_back();
        added.size = report.size();
        std::ranges::copy(report, added.bytes.begin());
    }
    return driver_->has_moved({}, report);
}

void HidSession::hear_rivals(std::int64_t now_ns) {
    for (Rival& rival : rivals_) {
        if (!rival.port) {
            auto opened = bus_->open(rival.info);
            if (!opened) continue;
            rival.port = std::move(opened).value();
        }
        if (hear(rival, now_ns)) return;
    }
}

bool HidSession::hear(Rival& rival, std::int64_t now_ns) {
    std::array<std::uint8_t, kMaxReportBytes> report{};
    for (int count = 0; count < kMostReportsARound; ++count) {
        const auto size = rival.port->read(report, 0);
        if (!size || *size == 0) return false;
        const bool moved = has_moved(rival.firsts, std::span(report).first(std::min(*size, report.size())));
        if (!moved && !firsts_.empty()) continue;
        driver_->stop(*port_);
        port_.reset();
        const HidDeviceInfo chosen = rival.info;
        FirstReports firsts = std::move(rival.firsts);
        // One that only leans gives the node back to a hand.
        rival = {.info = used_, .port = nullptr, .firsts = std::move(firsts_)};
        if (moved) rivals_.clear();
        HidStatus status = begin(chosen);
        firsts_ = std::move(firsts);
        if (status.state != HidStatus::State::kReady) next_search_ns_ = now_ns;
        gate_.restart();
        publish(std::move(status));
        return true;
    }
    return false;
}

HidStatus HidSession::begin(const HidDeviceInfo& device) {
    HidStatus status{.state = HidStatus::State::kReady,
                     .name = device.name,
                     .path = device.path,
                     .times_found = status_.times_found};
    if (!device.refusal.empty()) {
        status.state = HidStatus::State::kRefused;
        status.message = device.refusal + (device.remedy.empty() ? "" : "; " + device.remedy);
        return status;
    }
    auto opened = bus_->open(device);
    auto started = opened ? driver_->start(device, **opened) : Result<void>(opened.error());
    if (!started) {
        status.state = HidStatus::State::kFailed;
        status.message = started.error().message;
        return status;
    }
    port_ = std::move(opened).value();
    used_ = device;
    firsts_.clear();
    return status;
}

bool HidSession::hear(std::int64_t now_ns) {
    std::array<std::uint8_t, kMaxReportBytes> report{};
    int wait_ms = kReadWaitMs;
    // Reads the whole queue, oldest first: after a stall only the state after the last report is published.
    for (int count = 0; count < kMostReportsARound; ++count) {
        const auto size = port_->read(report, wait_ms);
        if (!size) return false;
        if (*size == 0) return true;
        const std::span<const std::uint8_t> taken = std::span(report).first(std::min(*size, report.size()));
        if (!rivals_.empty() && has_moved(firsts_, taken)) rivals_.clear();
        driver_->take_report(taken, now_ns);
        wait_ms = 0;
    }
    return true;
}

void HidSession::exchange(std::int64_t now_ns) {
    if (!hear(now_ns)) return lose(now_ns);
    if (now_ns >= next_presence_ns_) {
        next_presence_ns_ = now_ns + kPresenceIntervalNs;
        if (!port_->is_there()) return lose(now_ns);
        hear_rivals(now_ns);
        if (!port_) return;
    }
    const DeviceInput input = driver_->input(now_ns);
    if (input.is_live != status_.is_heard || input.buttons != status_.buttons) {
        HidStatus status = status_;
        status.is_heard = input.is_live;
        status.buttons = input.buttons;
        publish(std::move(status));
    }

    ForceOrder order = gate_.passed(link_.force.latest(), now_ns);
    const std::uint32_t silences = link_.silences.load(std::memory_order_relaxed);
    if (!input.is_live || std::exchange(silences_, silences) != silences) {
        // The force was computed for a position or a time that is no longer current.
        gate_.restart();
        order.force_n = dvec2(0.0);
        order.tangential_n = 0.0;
    }
    publish(input);
    if (auto sent = driver_->send(*port_, order, now_ns); !sent) lose(now_ns);
}

void HidSession::lose(std::int64_t now_ns) {
    port_.reset();
    rivals_.clear();
    next_search_ns_ = now_ns + kSearchIntervalNs;
    publish(DeviceInput{});
    publish(HidStatus{});
}

void HidSession::publish(const DeviceInput& input) {
    DeviceInput published = input;
    published.heartbeat = ++heartbeat_;
    if (published.is_fresh) ++refreshed_;
    published.refreshed = refreshed_;
    published.force_fraction = gate_.fraction();
    link_.input.put(published);
}

void HidSession::publish(HidStatus status) {
    status.times_found = std::max(status.times_found, status_.times_found);
    status_ = std::move(status);
    link_.status.put(status_);
}

void HidSession::finish() noexcept {
    if (!port_) return;
    driver_->stop(*port_);
    lose(0);
    next_search_ns_.reset();
}

}  // namespace onggi::haptics::hid
