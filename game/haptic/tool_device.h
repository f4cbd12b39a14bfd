// Devices that know the whole tool: the first at the wheel, mouse, touch or a recording. What others read of
// a hand moves that tool, and does not change what it is.
#pragma once

#include <concepts>
#include <memory>
#include <utility>

#include "engine/haptics/device_group.h"
#include "engine/haptics/haptic_device.h"
#include "game/record/session.h"
#include "game/tool/gesture.h"
#include "game/tool/tool_state.h"

namespace onggi::haptic {

class ToolDevice : public haptics::HapticDevice {
  public:
    // As read() of a HapticDevice.
    [[nodiscard]] virtual tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept = 0;

    [[nodiscard]] haptics::HandSample read(std::uint64_t tick, double dt_s) noexcept final {
        tool_ = read_tool(tick, dt_s);
        return tool::sample_of(tool_);
    }
    // That of the last read().
    [[nodiscard]] const tool::ToolState& last_tool() const noexcept { return tool_; }

  private:
    tool::ToolState tool_;
};

// What moves the tool, and the device among it that knows the tool.
class ToolDevices {
  public:
    template <std::derived_from<ToolDevice> Device>
    ToolDevices(std::unique_ptr<Device> only) : first_(only.get()),
                                                all_(std::move(only)) {}
    // Precondition: `first` is one of the group.
    ToolDevices(std::unique_ptr<haptics::DeviceGroup> group, const ToolDevice& first)
        : first_(&first),
          all_(std::move(group)) {}

    [[nodiscard]] haptics::HapticDevice& all() const noexcept { return *all_; }
    // Haptic thread, once a tick.
    [[nodiscard]] tool::ToolState read(std::uint64_t tick, double dt_s) noexcept {
        const haptics::HandSample sample = all_->read(tick, dt_s);
        return tool::moved_by(sample, first_->last_tool());
    }

  private:
    const ToolDevice* first_;
    std::unique_ptr<haptics::HapticDevice> all_;
};

// Recordings as devices: read tick by tick, and feel nothing. After its end the tool rests as it was last.

// Tick k of a gesture is at exactly (double)k / rate.
class GesturePlayer final : public ToolDevice {
  public:
    GesturePlayer(tool::Gesture gesture, double rate_hz) : gesture_(std::move(gesture)), rate_hz_(rate_hz) {}

    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override { return {.name = "gesture"}; }
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double /*dt_s*/) noexcept override {
        return gesture_.at_tick(tick, rate_hz_);
    }
    void write(const dvec3& /*force_n*/) noexcept override {}

  private:
    tool::Gesture gesture_;
    double rate_hz_;
};

class SessionPlayer final : public ToolDevice {
  public:
    explicit SessionPlayer(record::Session session) : session_(std::move(session)), cursor_(session_) {}
    // The cursor points into the session.
    SessionPlayer(const SessionPlayer&) = delete;
    SessionPlayer& operator=(const SessionPlayer&) = delete;

    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override { return {.name = "session"}; }
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double /*dt_s*/) noexcept override {
        return cursor_.at(tick);
    }
    void write(const dvec3& /*force_n*/) noexcept override {}

  private:
    record::Session session_;
    record::SessionCursor cursor_;
};

}  // namespace onggi::haptic
