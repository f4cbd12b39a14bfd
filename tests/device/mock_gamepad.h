// A gamepad as the kernel shows it, /dev/input/eventN, described to umockdev: the real GLFW finds it, asks
// what it has and reads its events. For tests, in a program that runs under umockdev-wrapper; one thread
// plugs pads in and out.
#pragma once

#include <umockdev.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace onggi::testing {

struct GamepadIdentity {
    int node = 0;  // /dev/input/event<node>
    std::string name = {};
    std::uint16_t bus = 3;  // USB
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::uint16_t version = 0;
};

// The unread events of a node, which umockdev's thread removes. The axes' positions are queried after each
// report.
struct EventQueue {
    GamepadIdentity pad = {};
    std::mutex lock = {};
    std::vector<std::uint8_t> bytes = {};
    std::array<std::int32_t, 64> axes = {};
};

// The layout of the kernel's xpad driver: two sticks, two triggers, a cross as a hat, eleven buttons.
class MockGamepad {
  public:
    MockGamepad(UMockdevTestbed* testbed, const GamepadIdentity& identity);
    ~MockGamepad();
    MockGamepad(const MockGamepad&) = delete;
    MockGamepad& operator=(const MockGamepad&) = delete;

    void press(std::uint16_t button, bool pressed);     // BTN_...
    void move(std::uint16_t axis, std::int32_t value);  // ABS_...
    void pull_out();

  private:
    void send(std::uint16_t type, std::uint16_t code, std::int32_t value);

    UMockdevTestbed* testbed_;
    std::string sysfs_;
    UMockdevIoctlBase* answers_;
    EventQueue queue_;
};

}  // namespace onggi::testing
