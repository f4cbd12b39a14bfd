// All the hands there are as one device: whichever moves has the tool, the others wait. Devices come and go
// while the loop runs: each hand's own mailbox tells whether it is here, so that nothing but values reaches
// the tick.
//
// The first hand is the one that is always there (mouse, touch, or a recording). What a tool is besides its
// place - its radius, its kind, whatever a screen says of it - is always the first hand's affair.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "engine/haptics/hand.h"
#include "engine/haptics/hand_chooser.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics {

struct HandsOptions {
    HandChooserOptions chooser = {};
    // After a change of hands the tool goes from where it was to where the new hand has it, not through the
    // work at once. Faster than a hand works.
    double fastest_mm_s = 600.0;
};

class Hands final : public HapticDevice {
  public:
    // At least the first.
    explicit Hands(std::vector<std::unique_ptr<Hand>> hands, const HandsOptions& options = {});
    ~Hands() override { close(); }

    // Something that turns the wheel and holds no tool. Before open().
    void add_pedal(std::unique_ptr<HapticDevice> pedal) { pedals_.push_back(std::move(pedal)); }

    // The first hand's error. One that cannot be opened besides is never here.
    Result<void> open() override;
    void close() noexcept override;
    // The first hand's: the loop is set up for what is always there, and no stiffer than the softest of those
    // that close a loop of forces. What else a hand's motors bear is kept here.
    [[nodiscard]] DeviceCapabilities capabilities() const override;
    [[nodiscard]] std::vector<DeviceCapabilities> capabilities_of_hands() const override;

    [[nodiscard]] ToolState read(std::uint64_t tick, double dt_s) noexcept override;
    // The holder's; nobody is there, and nothing is new, while it is gone. The fraction counts what write()
    // leaves of a force.
    [[nodiscard]] HandSigns signs() const noexcept override;
    void silence() noexcept override;
    // To the hand that has the tool, through its own kMotorStages (safety_chain.h): after a change of hands
    // from nothing, never more than its motors bear for a moment and for ever. Nothing to all others.
    void write(const dvec3& force_n) noexcept override;
    void feel(const WorkFelt& work) noexcept override;

    // Any thread: the place, in the list of the constructor, of the hand that has the tool.
    [[nodiscard]] std::size_t holder() const noexcept {
        return shown_holder_.load(std::memory_order_relaxed);
    }
    // Any thread: in how many reads so far somebody was seen to do something with a hand besides the first,
    // or with a pedal.
    [[nodiscard]] std::uint64_t signs_of_life() const noexcept {
        return signs_of_life_.load(std::memory_order_relaxed);
    }

  private:
    std::vector<std::unique_ptr<Hand>> hands_;
    std::vector<std::unique_ptr<HapticDevice>> pedals_;
    HandsOptions options_;
    std::atomic<std::size_t> shown_holder_{0};
    std::atomic<std::uint64_t> signs_of_life_{0};

    // Haptic thread only.
    HandChooser chooser_;
    std::vector<ToolState> tools_;  // what each said last
    std::vector<HandSeen> seen_;
    std::size_t holder_ = 0;
    ToolState tool_;             // as given out last
    bool knows_a_tool_ = false;  // there was a read() before
    bool approaches_ = false;    // on the way to the new holder's place
    double dt_s_ = 0.0;
    // Of each hand, what its motors bear and how warm they are.
    struct Motors {
        SafetyLimits limits;
        SafetyState state;
        double given_fraction = 0.0;  // of the force written last
    };
    std::vector<Motors> motors_;
};

}  // namespace onggi::haptics
