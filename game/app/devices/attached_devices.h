// Selects the devices that a command admits to the wheel, and follows them while it runs. The haptic job gets
// them as one device; the main thread asks here which are plugged in and which has the tool. Main thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/device_group.h"
#include "engine/haptics/hid/hid_device.h"
#include "game/haptic/tool_device.h"

namespace onggi::app {

// Whether the word names the devices that may hold the tool: `auto` (any device that is plugged in, now or
// later), a kind (joystick, spacemouse, dualsense, inverse3), a node (/dev/hidraw3) or numbers (256f:c635).
// Any other word is the name of the first device, which is then the only one. The foot pedal works with all
// but that.
[[nodiscard]] bool names_a_device(const std::string& word);

// A device that is no HID device.
struct OtherDevice {
    std::string word;  // its name until it reports one
    std::unique_ptr<haptics::HapticDevice> device;
    std::function<const haptics::hid::HidStatus&()> status;  // main thread
};

class AttachedDevices {
  public:
    // `first` is always present. A recording yields the tool to any device that is moved. System lacks: the
    // device named by node or numbers is not plugged in or not supported. `other`: one device more.
    static Result<AttachedDevices> make(const std::string& word, std::unique_ptr<haptic::ToolDevice> first,
                                        bool first_is_a_recording, std::optional<OtherDevice> other = {});

    // Passes the devices to the haptic job; call it once. The job owns them: do not call the functions below
    // after its end.
    [[nodiscard]] haptic::ToolDevices take() { return {std::move(group_), *first_}; }

    // Returns the changes since the last call, one line each: devices that were plugged in, unplugged, or
    // refused with the reason.
    [[nodiscard]] std::vector<std::string> news();
    // The device that has the tool; empty: the first.
    [[nodiscard]] std::string holder() const;
    // Whether a person changed a control of a device other than the first, or of a pedal, since the last
    // call.
    [[nodiscard]] bool somebody_moved();
    // The names of the devices that do not come to rest (control_sense.h).
    [[nodiscard]] std::vector<std::string> restless() const;
    // Whether a device other than the first is plugged in and works, as of the last news().
    [[nodiscard]] bool has_device() const;
    // The devices and pedals that are plugged in, as of the last news().
    struct Seen {
        std::string name;
        std::string ability;  // "moves the tool; pushes, 2 axes, 3.0 N"
        bool works = false;
        std::string why_not;  // one line
    };
    [[nodiscard]] std::vector<Seen> seen() const;
    // A DualSense's driver reads all its controls, so the window system's gamepad events from that device
    // must be ignored.
    [[nodiscard]] bool drives(std::uint16_t vendor_id, std::uint16_t product_id) const;

  private:
    struct Watched {
        haptics::HidKind kind = haptics::HidKind::kUnknown;  // kUnknown: no HID device
        std::string word = {};                               // its name until the device reports one
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
    void add(OtherDevice other, std::vector<std::unique_ptr<haptics::HapticDevice>>& devices);

    std::unique_ptr<haptics::DeviceGroup> group_;
    const haptics::DeviceGroup* watched_group_ = nullptr;
    const haptic::ToolDevice* first_ = nullptr;
    std::vector<Watched> tools_;  // in the order of the group's devices, from the second on
    std::vector<Watched> pedals_;
    std::uint64_t signs_of_life_ = 0;  // as of the last call
};

}  // namespace onggi::app
