// A finger on a touch screen: finger SOCKET WIDTH HEIGHT [turned] reads one command per line, in xdotool's
// syntax: "mousemove X Y", in pixels of a screen of that size, "mousedown 1", "mouseup 1", "sleep S"; and
// "palm X Y", a hand that is laid on the screen there and stays. It answers each command with a line "done".
// SOCKET is where the X server's input driver for tests listens (inputtest(4), which accepts one program and
// none after it): the touches pass through the server's touch handling to the program, like those of a real
// touch screen.
#include <X11/X.h>
#include <X11/extensions/XI2.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <xorg/xf86-input-inputtest-protocol.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

namespace onggi {
namespace {

// The axes of the driver's touch screens.
constexpr double kAxisSteps = 65536.0;

class TouchScreen {
  public:
    explicit TouchScreen(const std::string& path) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        if (path.size() >= sizeof address.sun_path) throw std::runtime_error(path + ": too long a path");
        std::copy(path.begin(), path.end(), address.sun_path);
        if (::connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            throw std::runtime_error(
                fmt::format("{}: expected a touch screen, found {}", path, std::strerror(errno)));
        xf86ITEventClientVersion version{};
        version.major = XF86IT_PROTOCOL_VERSION_MAJOR;
        version.minor = XF86IT_PROTOCOL_VERSION_MINOR;
        tell(version, XF86IT_EVENT_CLIENT_VERSION);
        xf86ITResponseServerVersion answer{};
        if (::recv(file_, &answer, sizeof answer, MSG_WAITALL) != static_cast<ssize_t>(sizeof answer))
            throw std::runtime_error(path + ": expected a driver's version, found none");
    }
    ~TouchScreen() { ::close(file_); }
    TouchScreen(const TouchScreen&) = delete;
    TouchScreen& operator=(const TouchScreen&) = delete;

    // XI_TouchBegin, XI_TouchUpdate or XI_TouchEnd of a finger, at a place in fractions of the screen.
    void touch(std::uint32_t finger, std::uint32_t type, double x, double y) {
        xf86ITEventTouch event{};
        event.touchid = finger;
        event.touch_type = type;
        event.valuators.mask[0] = 0b11;
        event.valuators.valuators[0] = x * kAxisSteps;
        event.valuators.valuators[1] = y * kAxisSteps;
        tell(event, XF86IT_EVENT_TOUCH);
    }

  private:
    template <typename Event>
    void tell(Event& event, xf86ITEventType type) {
        event.header.length = sizeof event;
        event.header.type = type;
        if (::send(file_, &event, sizeof event, MSG_NOSIGNAL) != static_cast<ssize_t>(sizeof event))
            throw std::runtime_error("the X server no longer listens to its touch screen");
    }

    int file_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
};

class Finger {
  public:
    Finger(const std::string& socket, double width, double height, bool is_turned)
        : screen_(socket),
          width_(width),
          height_(height),
          is_turned_(is_turned) {}

    // Throws std::runtime_error for an invalid command.
    void follow(const std::string& line) {
        std::istringstream words(line);
        for (std::string word; words >> word;) {
            if (word == "mousemove") {
                x_ = (number(words) + 0.5) / width_;
                y_ = (number(words) + 0.5) / height_;
                if (is_down_) touch(kFinger, XI_TouchUpdate, x_, y_);
            } else if (word == "sleep") {
                std::this_thread::sleep_for(std::chrono::duration<double>(number(words)));
            } else if (word == "mousedown" || word == "mouseup") {
                if (number(words) != 1.0) throw std::runtime_error("a finger is button 1");
                is_down_ = word == "mousedown";
                touch(kFinger, is_down_ ? XI_TouchBegin : XI_TouchEnd, x_, y_);
            } else if (word == "palm") {
                const double x = (number(words) + 0.5) / width_;
                touch(kPalm, XI_TouchBegin, x, (number(words) + 0.5) / height_);
            } else {
                throw std::runtime_error(fmt::format("expected a move of a finger, found '{}'", word));
            }
        }
    }

  private:
    static constexpr std::uint32_t kFinger = 1;
    static constexpr std::uint32_t kPalm = 2;

    // On a panel mounted on its side the picture is turned clockwise by a quarter, but its sensor is not.
    void touch(std::uint32_t finger, std::uint32_t type, double x, double y) {
        if (is_turned_)
            screen_.touch(finger, type, y, 1.0 - x);
        else
            screen_.touch(finger, type, x, y);
    }
    static double number(std::istringstream& words) {
        double value = 0.0;
        if (!(words >> value)) throw std::runtime_error("expected a number, found none: " + words.str());
        return value;
    }

    TouchScreen screen_;
    double width_;
    double height_;
    bool is_turned_;
    double x_ = 0.0;  // in fractions of the screen
    double y_ = 0.0;
    bool is_down_ = false;
};

}  // namespace
}  // namespace onggi

int main(int argc, char** argv) {
    const bool is_turned = argc == 5 && std::string(argv[4]) == "turned";
    if (argc != 4 && !is_turned) {
        std::fputs("finger: expected SOCKET WIDTH HEIGHT [turned]\n", stderr);
        return 2;
    }
    try {
        onggi::Finger finger(argv[1], std::atof(argv[2]), std::atof(argv[3]), is_turned);
        for (std::string line; std::getline(std::cin, line);) {
            finger.follow(line);
            std::puts("done");
            std::fflush(stdout);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "finger: {}\n", error.what());
        return 2;
    }
}
