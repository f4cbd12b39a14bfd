// Which devices a command lets at the wheel, and what becomes of them while it runs. The haptic job gets them
// as one device; the main thread asks here who is plugged in and who has the tool. Main thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/device_group.h"
#include "engine/haptics/hid/hid_device.h"
#include "game/haptic/tool_device.h"

namespace onggi::app {

// A word for the devices that may hold the tool: `auto` (whatever is plugged in, now or later), or one
// device: a kind (joystick, spacemouse, dualsense, inverse3), a node (/dev/hidraw3) or numbers (256f:c635).
// Any other word is the first device's name: nothing besides it. The foot pedal serves beside all but that.
[[nodiscard]] bool names_a_device(const std::string& word);

class AttachedDevices {
  public:
    // `first` is always there. A recording yields to whoever moves a device. System lacks: a device named by
    // node or numbers is not plugged in, or is none that is driven here.
    static Result<AttachedDevices> make(const std::string& word, std::unique_ptr<haptic::ToolDevice> first,
                                        bool first_is_a_recording);

    // For the haptic job, once. It owns the devices: ask nothing below after it is gone.
    [[nodiscard]] haptic::ToolDevices take() { return {std::move(group_), *first_}; }

    // What has changed since the last call, a line each: who came, who went, who is refused and why.
    [[nodiscard]] std::vector<std::string> news();
    // The device that has the tool; empty: the first.
    [[nodiscard]] std::string holder() const;
    // Whether somebody has changed something at a device besides the first, or at a pedal, since the last
    // call.
    [[nodiscard]] bool somebody_moved();
    // The names of those that do not come to rest (control_sense.h).
    [[nodiscard]] std::vector<std::string> restless() const;
    // Whether a device besides the first is plugged in and works, as of the last news().
    [[nodiscard]] bool has_device() const;
    // The devices and pedals that are plugged in, as of the last news().
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

    AttachedDevices() = default;
    void add(haptics::HidKind kind, const std::string& only,
             std::vector<std::unique_ptr<haptics::HapticDevice>>& devices);
    void add_inverse(std::vector<std::unique_ptr<haptics::HapticDevice>>& devices);

    std::unique_ptr<haptics::DeviceGroup> group_;
    const haptics::DeviceGroup* watched_group_ = nullptr;
    const haptic::ToolDevice* first_ = nullptr;
    std::vector<Watched> tools_;  // in the order of the hands, from the second on
    std::vector<Watched> pedals_;
    std::uint64_t signs_of_life_ = 0;  // as of the last look
};

}  // namespace onggi::app
