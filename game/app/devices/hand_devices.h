// Which hands a command lets at the wheel, and what becomes of them while it runs. The haptic job gets them
// as one device; the main thread asks here who is plugged in and who has the tool. Main thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/hand.h"
#include "engine/haptics/hands.h"
#include "engine/haptics/hid/hid_device.h"

namespace onggi::app {

// A word for the devices that may hold the tool: `auto` (whatever is plugged in, now or later), or one
// device: a kind (joystick, spacemouse, dualsense, inverse3), a node (/dev/hidraw3) or numbers (256f:c635).
// Any other word is the first hand's name: nothing besides it. The foot pedal serves beside all but that.
[[nodiscard]] bool names_a_device(const std::string& word);

class HandDevices {
  public:
    // `first` is always there. A recording yields to whoever moves a device. System lacks: a device named by
    // node or numbers is not plugged in, or is none that is driven here.
    static Result<HandDevices> make(const std::string& word, std::unique_ptr<haptics::Hand> first,
                                    bool first_is_a_recording);

    // For the haptic job, once. It owns the hands: ask nothing below after it is gone.
    [[nodiscard]] std::unique_ptr<haptics::HapticDevice> take() { return std::move(hands_); }

    // What has changed since the last call, a line each: who came, who went, who is refused and why.
    [[nodiscard]] std::vector<std::string> news();
    // The hand that has the tool; empty: the first.
    [[nodiscard]] std::string holder() const;
    // Whether somebody has done something with a hand besides the first, or a pedal, since the last call.
    [[nodiscard]] bool somebody_moved();
    // Whether a hand besides the first is plugged in and works, as of the last news().
    [[nodiscard]] bool has_hand() const;
    // The hands and pedals that are plugged in, as of the last news().
    struct Seen {
        std::string name;
        std::string ability;  // "moves the tool; pushes, 2 axes, 3.0 N"
        bool works = false;
        std::string why_not;  // one line
    };
    [[nodiscard]] std::vector<Seen> seen() const;
    // A DualSense is driven whole, so that the window system's idea of it counts for nothing.
    [[nodiscard]] bool drives(std::uint16_t vendor_id, std::uint16_t product_id) const;

  private:
    struct Watched {
        haptics::HidKind kind = haptics::HidKind::kUnknown;  // kUnknown: no HID device
        std::string word = {};                               // what it is called while it has no name
        std::function<const haptics::hid::HidStatus&()> status = {};
        std::string ability = {};
        haptics::hid::HidStatus last = {};

        [[nodiscard]] std::string name_of(const haptics::hid::HidStatus& now) const {
            return now.name.empty() ? word : now.name;
        }
    };
    static Watched watch(haptics::HidDevice& device);

    HandDevices() = default;
    void add(haptics::HidKind kind, const std::string& only,
             std::vector<std::unique_ptr<haptics::Hand>>& hands);
    void add_inverse(std::vector<std::unique_ptr<haptics::Hand>>& hands);

    std::unique_ptr<haptics::Hands> hands_;
    const haptics::Hands* watched_hands_ = nullptr;
    std::vector<Watched> tools_;  // in the order of the hands, from the second on
    std::vector<Watched> pedals_;
    std::uint64_t signs_of_life_ = 0;  // as of the last look
};

// Anything that plays, as a hand that is always at work.
class RecordedHand final : public haptics::Hand {
  public:
    explicit RecordedHand(std::unique_ptr<haptics::HapticDevice> player) : player_(std::move(player)) {}

    Result<void> open() override { return player_->open(); }
    void close() noexcept override { player_->close(); }
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override {
        return player_->capabilities();
    }
    [[nodiscard]] haptics::ToolState read(std::uint64_t tick, double dt_s) noexcept override {
        return player_->read(tick, dt_s);
    }
    void write(const dvec3& force_n) noexcept override { player_->write(force_n); }
    [[nodiscard]] bool is_here() const noexcept override { return true; }
    [[nodiscard]] bool is_moving() const noexcept override { return true; }
    void take_over(const haptics::ToolState&) noexcept override {}  // it is where it is written to be

  private:
    std::unique_ptr<haptics::HapticDevice> player_;
};

}  // namespace onggi::app
