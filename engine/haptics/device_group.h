// Several devices as one: whichever moves has the tool, the others wait. Devices come and go while the loop
// runs: each device's own mailbox tells whether it is here, so that nothing but values reaches the tick.
//
// The first device is always there (mouse, touch, or a recording).
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/haptics/haptic_device.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics {

// Which of several devices has the tool. Pure: no clock, time is the sum of the steps; no allocation. s.
struct DeviceChooserOptions {
    // A device that has the tool keeps it until it has been still for so long; then the next that moves takes
    // it. Two people do not tear the tool to and fro, and nobody waits for somebody who has gone.
    double still_s = 0.5;
    // Device 0 is no person but a recording, which always moves: others take the tool from it at once, and it
    // waits longer until it goes on.
    bool first_yields = false;
    double recording_waits_s = 3.0;
    // A device that has gone for so long is not coming back at once: the first, which is always there, has
    // the tool again, and takes it out of the work where it was left.
    double gone_s = 0.5;
};

// What is known of one device in this tick.
struct DeviceSeen {
    bool is_here = false;
    bool is_moving = false;
};

class DeviceChooser {
  public:
    explicit DeviceChooser(const DeviceChooserOptions& options = {}) : options_(options) {}

    // The device that has the tool now: device 0 at first. A holder that is gone keeps it a moment, without
    // moving it, unless another device moves. With several moving at once it is the one named last, so list
    // devices that push back after those that do not.
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
    // After a change of holders the tool goes from where it was to where the new one has it, not through the
    // work at once. Faster than a hand works.
    double fastest_mm_s = 600.0;
};

class DeviceGroup final : public HapticDevice {
  public:
    // At least the first.
    explicit DeviceGroup(std::vector<std::unique_ptr<HapticDevice>> devices,
                         const DeviceGroupOptions& options = {});
    ~DeviceGroup() override { close(); }

    // Something that turns the wheel and holds no tool. Before open().
    void add_pedal(std::unique_ptr<HapticDevice> pedal) { pedals_.push_back(std::move(pedal)); }

    // The first device's error. One that cannot be opened besides is never here.
    Result<void> open() override;
    void close() noexcept override;
    // The first device's: the loop is set up for what is always there, and no stiffer than the softest of
    // those that close a loop of forces. What else a device's motors bear is kept here.
    [[nodiscard]] DeviceCapabilities capabilities() const override;
    [[nodiscard]] std::vector<DeviceCapabilities> capabilities_of_devices() const override;

    // Where the holder has the tool, and how fast it turns the work; the button is anybody's.
    [[nodiscard]] HandSample read(std::uint64_t tick, double dt_s) noexcept override;
    // The holder's; nobody is there, and nothing is new, while it is gone. The fraction counts what write()
    // leaves of a force.
    [[nodiscard]] DeviceSigns signs() const noexcept override;
    void silence() noexcept override;
    // To the device that has the tool, through its own kMotorStages (safety_chain.h): after a change of
    // holders from nothing, never more than its motors bear for a moment and for ever. Nothing to all others.
    void write(const dvec3& force_n) noexcept override;
    void feel(const WorkFelt& work) noexcept override;

    // Any thread: the place, in the list of the constructor, of the device that has the tool.
    [[nodiscard]] std::size_t holder() const noexcept {
        return shown_holder_.load(std::memory_order_relaxed);
    }
    // Any thread: in how many reads so far somebody was seen to change something at a device besides the
    // first, or at a pedal.
    [[nodiscard]] std::uint64_t signs_of_life() const noexcept {
        return signs_of_life_.load(std::memory_order_relaxed);
    }
    // Any thread: which devices do not come to rest, a bit each: those of the constructor's list, then the
    // pedals.
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

    // Haptic thread only.
    DeviceChooser chooser_;
    std::vector<HandSample> samples_;  // what each said last
    std::vector<DeviceSeen> seen_;
    std::size_t holder_ = 0;
    HandSample last_;             // as given out last
    bool knows_a_place_ = false;  // there was a read() before
    bool approaches_ = false;     // on the way to the new holder's place
    double dt_s_ = 0.0;
    // Of each device, what its motors bear and how warm they are.
    struct Motors {
        SafetyLimits limits;
        SafetyState state;
        double given_fraction = 0.0;  // of the force written last
    };
    std::vector<Motors> motors_;
};

}  // namespace onggi::haptics
