// Devices that provide a whole tool: the first device at the wheel (mouse, touch or a recording). Other
// devices move that tool and do not change its kind.
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
    // See HapticDevice::read().
    [[nodiscard]] virtual tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept = 0;

    [[nodiscard]] haptics::HandSample read(std::uint64_t tick, double dt_s) noexcept final {
        tool_ = read_tool(tick, dt_s);
        return tool::sample_of(tool_);
    }
    // The result of the last read().
    [[nodiscard]] const tool::ToolState& last_tool() const noexcept { return tool_; }

  private:
    tool::ToolState tool_;
};

// All devices at the wheel, and the first one, which provides the whole tool.
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
    // Haptic thread; call it once a tick.
    [[nodiscard]] tool::ToolState read(std::uint64_t tick, double dt_s) noexcept {
        const haptics::HandSample sample = all_->read(tick, dt_s);
        return tool::moved_by(sample, first_->last_tool());
    }

  private:
    const ToolDevice* first_;
    std::unique_ptr<haptics::HapticDevice> all_;
};

// Players of recordings: they read tick by tick and ignore forces. After the end, the tool keeps its last
// state.

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
