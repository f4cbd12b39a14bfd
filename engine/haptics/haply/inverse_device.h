// The Haply Inverse3 as a HapticDevice: three axes of force, through its maker's service on this machine (a
// WebSocket on 127.0.0.1). It may be plugged in and out at any time. It renders all of Eq. (3) to (7), which
// no joystick can.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/haptics/control_sense.h"
#include "engine/haptics/haply/inverse_session.h"
#include "engine/haptics/haptic_device.h"
#include "engine/jobs/io_thread.h"

namespace onggi::haptics {

namespace haply {

// The socket to the Inverse service: a WebSocket client (libwebsockets) as the work of one I/O thread. It
// tries to connect every two seconds, and exchanges messages for the session.
class InverseClient final : public jobs::IoWork {
  public:
    InverseClient(InverseLink& link, const InverseOptions& options);
    ~InverseClient() override;

    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace haply

class InverseDevice final : public HapticDevice {
  public:
    explicit InverseDevice(const haply::InverseOptions& options = {});
    ~InverseDevice() override { close(); }

    // Does not wait for the service. Error: the thread cannot start.
    Result<void> open() override;
    // Leaves the device without force.
    void close() noexcept override { thread_.stop(); }
    [[nodiscard]] DeviceCapabilities capabilities() const override;

    [[nodiscard]] HandSample read(std::uint64_t tick, double dt_s) noexcept override;
    [[nodiscard]] DeviceSigns signs() const noexcept override {
        return {.position_is_new = is_new_, .hand_is_there = is_here_, .force_fraction = force_fraction_};
    }
    void write(const dvec3& force_n) noexcept override;
    void silence() noexcept override { link_.silences.fetch_add(1, std::memory_order_relaxed); }
    [[nodiscard]] bool is_here() const noexcept override { return is_here_; }
    [[nodiscard]] bool is_moving() const noexcept override { return is_moving_; }
    [[nodiscard]] bool never_rests() const noexcept override { return sense_.never_rests(); }
    void take_over(const dvec3& position_mm) noexcept override;

    // Main thread, any time.
    [[nodiscard]] const hid::HidStatus& status() noexcept { return link_.status.latest(); }

  private:
    haply::InverseOptions options_;
    haply::InverseLink link_;
    haply::InverseClient client_;
    jobs::IoThread thread_;
    // Haptic thread only.
    dvec3 offset_mm_;  // from the cursor's position to the tool's
    HandSample sample_;
    std::uint64_t last_heartbeat_ = 0;
    double silence_s_ = 0.0;
    double force_fraction_ = 0.0;
    bool is_new_ = false;  // a message came since the previous read
    bool is_here_ = false;
    bool is_moving_ = false;
    ControlSense sense_;
    std::uint64_t ticks_ = 0;
};

}  // namespace onggi::haptics
