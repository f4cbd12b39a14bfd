// A scripted HID bus and device, for tests: queued reports, answers, faults, and a log of everything sent. No
// thread and no time: reads never wait, pauses are added up.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/haptics/hid/hid_port.h"
#include "tests/support/hex.h"

namespace onggi::testing {

// Shared by the test and the fake.
struct ScriptedHid {
    haptics::HidDeviceInfo info;
    std::vector<haptics::HidDeviceInfo> others;  // listed before it; opened, they are the same device
    bool is_plugged_in = true;
    bool read_fails = false;  // the first sign of a removal at a real port
    bool write_fails = false;
    std::string refused;                          // writes that begin so ("0c 08") fail, the device stays
    std::deque<std::vector<std::uint8_t>> queue;  // reports not read yet
    std::vector<std::string> sent;                // "w 04 01", "s 11 01 00 00" and "g 12", in order
    // Answers by report id, used in order; the last one repeats. Empty: the device is gone.
    std::map<std::uint8_t, std::deque<std::vector<std::uint8_t>>> features;
    int times_opened = 0;
    int open_ports = 0;
    int paused_ms = 0;
    int waited_ms = 0;

    void report(std::string_view text) { queue.push_back(hex(text)); }
    // The reports sent since the last call.
    std::vector<std::string> take_sent() { return std::exchange(sent, {}); }
};

class ScriptedPort final : public haptics::hid::HidPort {
  public:
    explicit ScriptedPort(std::shared_ptr<ScriptedHid> script) : script_(std::move(script)) {
        ++script_->open_ports;
    }
    ~ScriptedPort() override { --script_->open_ports; }

    Result<std::size_t> read(std::span<std::uint8_t> report, int timeout_ms) override {
        if (script_->read_fails) return failed("read");
        if (script_->queue.empty()) {
            script_->waited_ms += timeout_ms;
            return std::size_t{0};
        }
        const std::vector<std::uint8_t> bytes = script_->queue.front();
        script_->queue.pop_front();
        const std::size_t size = std::min(bytes.size(), report.size());
        std::copy_n(bytes.begin(), size, report.begin());
        return size;
    }
    Result<void> write(std::span<const std::uint8_t> report) override {
        const bool is_refused = !script_->refused.empty() && as_hex(report).starts_with(script_->refused);
        if (script_->write_fails || is_refused) return failed("write");
        script_->sent.push_back("w " + as_hex(report));
        return {};
    }
    Result<void> set_feature(std::span<const std::uint8_t> report) override {
        if (script_->write_fails) return failed("set feature");
        script_->sent.push_back("s " + as_hex(report));
        return {};
    }
    Result<std::size_t> get_feature(std::span<std::uint8_t> report) override {
        script_->sent.push_back("g " + as_hex(report.first(1)));
        auto& answers = script_->features[report[0]];
        if (answers.empty()) return failed("get feature");
        const std::vector<std::uint8_t> bytes = answers.front();
        if (answers.size() > 1) answers.pop_front();
        const std::size_t size = std::min(bytes.size(), report.size());
        std::copy_n(bytes.begin(), size, report.begin());
        return size;
    }
    bool is_there() override { return script_->is_plugged_in; }
    void pause_ms(int milliseconds) override { script_->paused_ms += milliseconds; }

  private:
    std::shared_ptr<ScriptedHid> script_;
};

class ScriptedBus final : public haptics::hid::HidBus {
  public:
    explicit ScriptedBus(std::shared_ptr<ScriptedHid> script) : script_(std::move(script)) {}

    Result<std::vector<haptics::HidDeviceInfo>> list() override {
        if (!script_->is_plugged_in) return std::vector<haptics::HidDeviceInfo>{};
        std::vector<haptics::HidDeviceInfo> all = script_->others;
        all.push_back(script_->info);
        return all;
    }
    Result<std::unique_ptr<haptics::hid::HidPort>> open(const haptics::HidDeviceInfo& /*info*/) override {
        ++script_->times_opened;
        script_->read_fails = script_->write_fails = false;
        return std::unique_ptr<haptics::hid::HidPort>(std::make_unique<ScriptedPort>(script_));
    }

  private:
    std::shared_ptr<ScriptedHid> script_;
};

}  // namespace onggi::testing
