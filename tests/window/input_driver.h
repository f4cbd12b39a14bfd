// A device of the X server's input driver for tests (inputtest(4)): what is told here passes through the
// server's own handling to the programs, like the events of real hardware. The driver listens at a socket and
// accepts one program, and none after it. Errors are std::runtime_error.
#pragma once

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <xorg/xf86-input-inputtest-protocol.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace onggi::test {

class InputDriver {
  public:
    // The places of its screens and pens, from 0.
    static constexpr double kAxisSteps = 65536.0;

    explicit InputDriver(const std::string& path) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        if (path.size() >= sizeof address.sun_path) throw std::runtime_error(path + ": too long a path");
        std::copy(path.begin(), path.end(), address.sun_path);
        if (::connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            throw std::runtime_error(
                fmt::format("{}: expected an input device, found {}", path, std::strerror(errno)));
        xf86ITEventClientVersion version{};
        version.major = XF86IT_PROTOCOL_VERSION_MAJOR;
        version.minor = XF86IT_PROTOCOL_VERSION_MINOR;
        tell(version, XF86IT_EVENT_CLIENT_VERSION);
        xf86ITResponseServerVersion answer{};
        if (::recv(file_, &answer, sizeof answer, MSG_WAITALL) != static_cast<ssize_t>(sizeof answer))
            throw std::runtime_error(path + ": expected a driver's version, found none");
    }
    ~InputDriver() { ::close(file_); }
    InputDriver(const InputDriver&) = delete;
    InputDriver& operator=(const InputDriver&) = delete;

    // type: XI_TouchBegin, XI_TouchUpdate or XI_TouchEnd of XInput 2. A place is in fractions of the screen.
    void touch(std::uint32_t finger, std::uint32_t type, double x, double y) {
        xf86ITEventTouch event{};
        event.touchid = finger;
        event.touch_type = type;
        put_place(event.valuators, x, y);
        tell(event, XF86IT_EVENT_TOUCH);
    }
    // A pen goes to that place, with that pressure in the driver's units.
    void move(double x, double y, double pressure) {
        xf86ITEventMotion event{};
        event.is_absolute = 1;
        put_place(event.valuators, x, y);
        event.valuators.mask[0] |= 1U << kPressureAxis;
        event.valuators.valuators[kPressureAxis] = pressure;
        tell(event, XF86IT_EVENT_MOTION);
    }
    // Presses or releases a button; 1 is a pen's tip.
    void press(int button, bool presses) {
        xf86ITEventButton event{};
        event.is_absolute = 1;
        event.button = button;
        event.is_press = presses ? 1 : 0;
        tell(event, XF86IT_EVENT_BUTTON);
    }

  private:
    static constexpr unsigned kPressureAxis = 4;

    static void put_place(xf86ITValuatorData& values, double x, double y) {
        values.mask[0] = 0b11;
        values.valuators[0] = x * kAxisSteps;
        values.valuators[1] = y * kAxisSteps;
    }
    template <typename Event>
    void tell(Event& event, xf86ITEventType type) {
        event.header.length = sizeof event;
        event.header.type = type;
        if (::send(file_, &event, sizeof event, MSG_NOSIGNAL) != static_cast<ssize_t>(sizeof event))
            throw std::runtime_error("the X server no longer listens to its input device");
    }

    int file_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
};

}  // namespace onggi::test
