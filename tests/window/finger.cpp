// A finger on a touch screen: finger SOCKET WIDTH HEIGHT [turned] reads one command per line, in xdotool's
// syntax: "mousemove X Y", in pixels of a screen of that size, "mousedown 1", "mouseup 1", "sleep S"; and
// "palm X Y", a hand that is laid on the screen there and stays; "second X Y" and "secondup 1", another
// finger that comes, moves and lifts. It answers each command with a line "done". SOCKET: see input_driver.h.
// With "pen:" before it, it is a pen's: it hovers until its tip comes down, whose pressure rises and then
// stays.
#include <X11/X.h>
#include <X11/extensions/XI2.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "tests/window/input_driver.h"

namespace onggi {
namespace {

class Finger {
  public:
    Finger(const std::string& socket, double width, double height, bool is_turned)
        : is_pen_(socket.starts_with(kPen)),
          screen_(is_pen_ ? socket.substr(kPen.size()) : socket),
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
                if (is_pen_) {
                    lead_pen();
                } else if (is_down_) {
                    touch(kFinger, XI_TouchUpdate, x_, y_);
                }
            } else if (word == "sleep") {
                std::this_thread::sleep_for(std::chrono::duration<double>(number(words)));
            } else if (word == "mousedown" || word == "mouseup") {
                if (number(words) != 1.0) throw std::runtime_error("a finger is button 1");
                is_down_ = word == "mousedown";
                if (is_pen_) {
                    pressure_ = 0.0;
                    screen_.press(1, is_down_);
                    lead_pen();
                    continue;
                }
                touch(kFinger, is_down_ ? XI_TouchBegin : XI_TouchEnd, x_, y_);
            } else if (word == "palm") {
                const double x = (number(words) + 0.5) / width_;
                touch(kPalm, XI_TouchBegin, x, (number(words) + 0.5) / height_);
            } else if (word == "second") {
                second_x_ = (number(words) + 0.5) / width_;
                second_y_ = (number(words) + 0.5) / height_;
                touch(kSecond, std::exchange(second_is_down_, true) ? XI_TouchUpdate : XI_TouchBegin,
                      second_x_, second_y_);
            } else if (word == "secondup") {
                second_is_down_ = number(words) == 0.0;
                touch(kSecond, XI_TouchEnd, second_x_, second_y_);
            } else {
                throw std::runtime_error(fmt::format("expected a move of a finger, found '{}'", word));
            }
        }
    }

  private:
    static constexpr std::string_view kPen = "pen:";
    static constexpr std::uint32_t kFinger = 1;
    static constexpr std::uint32_t kPalm = 2;
    static constexpr std::uint32_t kSecond = 3;

    void lead_pen() {
        constexpr double kStep = 100.0;
        constexpr double kMost = 700.0;  // of 1000
        pressure_ = is_down_ ? std::min(pressure_ + kStep, kMost) : 0.0;
        screen_.move(x_, y_, pressure_);
    }
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

    bool is_pen_;
    double pressure_ = 0.0;  // of a pen's tip, in the driver's units
    test::InputDriver screen_;
    double width_;
    double height_;
    bool is_turned_;
    double x_ = 0.0;  // in fractions of the screen
    double y_ = 0.0;
    bool is_down_ = false;
    double second_x_ = 0.0;
    double second_y_ = 0.0;
    bool second_is_down_ = false;
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
