// Combines several devices into one: the device that moves has the tool, the others wait. Devices come and go
// while the loop runs: each device's mailbox tells whether it is present, so that the tick gets only values.
//
// The first device (mouse, touch, or a recording) is always present.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/haptics/haptic_device.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics {

// Decides which of several devices has the tool. Pure: no clock (time is the sum of the steps) and no
// allocation. s.
struct DeviceChooserOptions {
    // The holder of the tool keeps it until it has been still for this time; then the next device that moves
    // takes it. So two people do not fight over the tool, and a device that was left idle does not block it.
    double still_s = 0.5;
    // Device 0 is not a person but a recording, which always moves: other devices take the tool from it at
    // once, and it waits longer before it continues.
    bool first_yields = false;
    double recording_waits_s = 3.0;
    // After this time an absent holder loses the tool to the first device, which is always present and moves
    // the tool out of the work.
    double gone_s = 0.5;
};

// The state of one device in this tick.
struct DeviceSeen {
    bool is_here = false;
    bool is_moving = false;
};

class DeviceChooser {
  public:
    explicit DeviceChooser(const DeviceChooserOptions& options = {}) : options_(options) {}

    // Returns the device that has the tool; initially device 0. An absent holder keeps the tool for a moment,
    // without moving it, unless another device moves. If several move at the same time, the last one gets it,
    // so list devices with force after those without.
    [[nodiscard]] std::size_t choose(std::span<const DeviceSeen> devices, double dt_s) noexcept {
        const DeviceSeen& holder = devices[holder_];
        const bool is_at_work = holder.is_here && holder.is_moving;
        still_s_ = is_at_work ? 0.0 : still_s_ + dt_s;
        const bool yields = options_.first_yields && holder_ == 0;
        for (std::size_t other = devices.size(); other-- > 0;) {
            if (other == holder_ || !devices[other].is_here || !devices[other].is_moving) continue;
            const double wait_s =
                options_.first_yields && other == 0 ? options_.recording_waits_s : options_.still_s;
            if (!holder.is_here || yields || still_s_ >= wait_s) {
                holder_ = other;
                still_s_ = 0.0;
                break;
            }
        }
        if (!devices[holder_].is_here && devices[0].is_here && still_s_ >= options_.gone_s) {
            holder_ = 0;
            still_s_ = 0.0;
        }
        return holder_;
    }

  private:
    DeviceChooserOptions options_;
    std::size_t holder_ = 0;
    double still_s_ = 0.0;
};

struct DeviceGroupOptions {
    DeviceChooserOptions chooser = {};
    // After a change of holders the tool moves to the new holder's position at this speed, instead of jumping
    // through the work. Faster than a hand works.
    double fastest_mm_s = 600.0;
};

class DeviceGroup final : public HapticDevice {
  public:
    // Needs at least one device.
    explicit DeviceGroup(std::vector<std::unique_ptr<HapticDevice>> devices,
                         const DeviceGroupOptions& options = {});
    ~DeviceGroup() override { close(); }

    // Adds a device that turns the wheel and does not hold a tool. Call it before open().
    void add_pedal(std::unique_ptr<HapticDevice> pedal) { pedals_.push_back(std::move(pedal)); }

    // Returns the first device's error. Another device that cannot be opened counts as absent.
    Result<void> open() override;
    void close() noexcept override;
    // The first device's capabilities, because the loop is set up for the device that is always present; the
    // stiffness is at most that of the softest device that closes a force loop. The limits of the other
    // devices' motors are applied in write().
    [[nodiscard]] DeviceCapabilities capabilities() const override;
    [[nodiscard]] std::vector<DeviceCapabilities> capabilities_of_devices() const override;

    // The holder's position of the tool and its speed of the work; the button of any device turns the work.
    [[nodiscard]] HandSample read(std::uint64_t tick, double dt_s) noexcept override;
    // The holder's signs, and whether the first device is alone; while the holder is absent, hand_is_there
    // and position_is_new are false. The force fraction includes the reduction by write().
    [[nodiscard]] DeviceSigns signs() const noexcept override;
    void silence() noexcept override;
    // Sends the force to the tool's holder through its own kMotorStages (safety_chain.h): from zero after a
    // change of holders, and never more than its motors' peak and continuous force. The others get zero.
    void write(const dvec3& force_n) noexcept override;
    void feel(const WorkFelt& work) noexcept override;

    // Any thread: the index of the holder in the constructor's list.
    [[nodiscard]] std::size_t holder() const noexcept {
        return shown_holder_.load(std::memory_order_relaxed);
    }
    // Any thread: the number of reads in which a person changed a control of a device other than the first,
    // or of a pedal.
    [[nodiscard]] std::uint64_t signs_of_life() const noexcept {
        return signs_of_life_.load(std::memory_order_relaxed);
    }
    // Any thread: one bit for each device that does not come to rest, in the order of the constructor's list,
    // then the pedals.
    [[nodiscard]] std::uint32_t restless() const noexcept {
        return restless_.load(std::memory_order_relaxed);
    }

  private:
    std::vector<std::unique_ptr<HapticDevice>> devices_;
    std::vector<std::unique_ptr<HapticDevice>> pedals_;
    DeviceGroupOptions options_;
    std::atomic<std::size_t> shown_holder_{0};
    std::atomic<std::uint64_t> signs_of_life_{0};
    std::atomic<std::uint32_t> restless_{0};

    // Only for the haptic thread.
    DeviceChooser chooser_;
    std::vector<HandSample> samples_;  // the last read() of each device
    std::vector<DeviceSeen> seen_;
    std::size_t holder_ = 0;
    HandSample last_;             // the last returned sample
    bool knows_a_place_ = false;  // read() was called before
    bool is_alone_ = true;        // no device but the first is plugged in
    bool approaches_ = false;     // on the way to the new holder's position
    double dt_s_ = 0.0;
    // The limits of each device's motors, and their heat.
    struct Motors {
        SafetyLimits limits;
        SafetyState state;
        double given_fraction = 0.0;  // of the force written last
    };
    std::vector<Motors> motors_;
};

}  // namespace onggi::haptics
