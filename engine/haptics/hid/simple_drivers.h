// Drivers of the devices that only speak: SpaceMouse and foot pedal. I/O thread. Never tried on hardware by
// this project.
#pragma once

#include "engine/haptics/hid/hid_driver.h"
#include "engine/haptics/hid/space_mouse.h"
#include "engine/haptics/hid/vec_pedal.h"

namespace onggi::haptics::hid {

// Push to move the tool (rate control); button 1 starts and stops the wheel, a twist changes its speed; the
// lamp burns while it is heard.
class SpaceMouseDriver final : public HidDriver {
  public:
    explicit SpaceMouseDriver(const SpaceMouseMapping& mapping = {}) : mapping_(mapping) {}

    [[nodiscard]] DeviceCapabilities capabilities() const override;
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] HandInput input(std::int64_t now_ns) const noexcept override;
    Result<void> send(HidPort&, const ForceOrder&, std::int64_t) override { return {}; }
    void stop(HidPort& port) noexcept override;

  private:
    SpaceMouseMapping mapping_;
    SpaceMouseState state_;
    bool wheel_turns_ = false;
    std::int64_t heard_ns_ = 0;
};

// Any pedal down turns the wheel; the right one makes it faster meanwhile, the left one slower.
class VecPedalDriver final : public HidDriver {
  public:
    [[nodiscard]] DeviceCapabilities capabilities() const override;
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] HandInput input(std::int64_t now_ns) const noexcept override;
    Result<void> send(HidPort&, const ForceOrder&, std::int64_t) override { return {}; }
    void stop(HidPort&) noexcept override {}

  private:
    VecPedalState state_;
};

}  // namespace onggi::haptics::hid
