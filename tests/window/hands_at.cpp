// Simulates hands on a device: hands_at DEVICE PROGRAM [WORD ...] starts the program with devices described
// by umockdev, one of them DEVICE (gamepad or spacemouse), and reads one command per line: "push X Y SPEED"
// deflects the device so that the tool moves X mm to the right (the SpaceMouse's outwards) and Y mm up at
// that many mm/s; "hold BUTTON" and "let-go BUTTON", a or trigger of a gamepad, wheel of a SpaceMouse; "rest
// S". It answers each command with a line "done". Ends with the program's exit code. Runs under
// umockdev-wrapper.
#include <fmt/format.h>
#include <linux/input.h>
#include <poll.h>
#include <signal.h>  // NOLINT: SIGTERM
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "engine/haptics/hid/simple_drivers.h"
#include "game/app/devices/gamepad_finger.h"
#include "tests/device/mock_devices.h"
#include "tests/device/mock_gamepad.h"

namespace onggi {
namespace {

void rest(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// A person who knows how the kiosk responds to the device.
class Hands {
  public:
    virtual ~Hands() = default;

    void push(const dvec2& way_mm, double speed_mm_s) {
        const double length_mm = glm::length(way_mm);
        if (!(length_mm > 0.0) || !(speed_mm_s > 0.0)) return;
        const double speed = std::min(speed_mm_s, fastest_mm_s());
        stay_deflected(way_mm / length_mm, speed, length_mm / speed);
        deflect(dvec2(0.0), 0.0);
    }
    virtual void hold(const std::string& button, bool held) = 0;

  protected:
    // Deflects the device so that the tool moves at that speed; speed 0: release.
    virtual void deflect(const dvec2& direction, double speed_mm_s) = 0;
    // An event device reports changes only.
    virtual void stay_deflected(const dvec2& direction, double speed_mm_s, double seconds) {
        deflect(direction, speed_mm_s);
        rest(seconds);
    }
    [[nodiscard]] virtual double fastest_mm_s() const = 0;
};

class GamepadHands final : public Hands {
  public:
    GamepadHands() {
        // This folder exists on every machine, and GLFW watches it for new devices.
        std::filesystem::create_directories(std::filesystem::path(umockdev_testbed_get_root_dir(testbed_)) /
                                            "dev" / "input");
        pad_ = std::make_unique<testing::MockGamepad>(
            testbed_, testing::GamepadIdentity{.node = 7,
                                               .name = "Microsoft X-Box 360 pad",
                                               .vendor_id = 0x045e,
                                               .product_id = 0x028e,
                                               .version = 0x0110});
    }
    ~GamepadHands() override {
        pad_.reset();
        g_object_unref(testbed_);
    }
    void hold(const std::string& button, bool held) override {
        if (button == "trigger") pad_->move(ABS_RZ, held ? 255 : 0);
        if (button == "a") pad_->press(BTN_A, held);
    }

  private:
    void deflect(const dvec2& direction, double speed_mm_s) override {
        constexpr double kFarthest = 32767.0;
        const double fraction = std::cbrt(speed_mm_s / mapping_.fastest_mm_s);
        const dvec2 stick = direction * (mapping_.dead_band + (1.0 - mapping_.dead_band) * fraction);
        pad_->move(ABS_X, static_cast<int>(std::lround(kFarthest * stick.x)));
        pad_->move(ABS_Y, static_cast<int>(std::lround(-kFarthest * stick.y)));
    }
    [[nodiscard]] double fastest_mm_s() const override { return mapping_.fastest_mm_s; }

    const app::GamepadMapping mapping_;
    UMockdevTestbed* testbed_ = umockdev_testbed_new();
    std::unique_ptr<testing::MockGamepad> pad_;
};

class SpaceMouseHands final : public Hands {
  public:
    SpaceMouseHands() { bus_.plug_in(testing::kSpaceMouse); }
    // The first button starts and stops the wheel.
    void hold(const std::string& button, bool held) override {
        if (button == "wheel") bus_.at(testing::kSpaceMouse).report(held ? "03 01 00" : "03 00 00");
    }

  private:
    // Its axes are X right and Z down.
    void deflect(const dvec2& direction, double speed_mm_s) override {
        const dvec2 speed = direction * speed_mm_s;
        bus_.at(testing::kSpaceMouse)
            .report(fmt::format("01 {} 00 00 {} 00 00 00 00 00 00", axis(speed.x), axis(-speed.y)));
    }
    // It repeats its report, or it would count as silent.
    void stay_deflected(const dvec2& direction, double speed_mm_s, double seconds) override {
        constexpr double kReportS = 0.008;
        const auto begun = std::chrono::steady_clock::now();
        for (double gone_s = 0.0; gone_s < seconds;) {
            deflect(direction, speed_mm_s);
            rest(std::min(kReportS, seconds - gone_s));
            gone_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        }
    }
    [[nodiscard]] std::string axis(double speed_mm_s) const {
        const double fraction = std::cbrt(std::abs(speed_mm_s) / mapping_.fastest_mm_s);
        const double pushed =
            fraction > 0.0 ? mapping_.dead_band + (mapping_.full_scale - mapping_.dead_band) * fraction : 0.0;
        const auto value = static_cast<std::uint16_t>(std::lround(std::copysign(pushed, speed_mm_s)));
        return fmt::format("{:02x} {:02x}", value & 0xffU, value >> 8U);
    }
    [[nodiscard]] double fastest_mm_s() const override { return mapping_.fastest_mm_s; }

    const haptics::hid::SpaceMouseMapping mapping_;
    testing::MockBus bus_;
};

std::unique_ptr<Hands> hands_on(const std::string& device) {
    if (device == "gamepad") return std::make_unique<GamepadHands>();
    if (device == "spacemouse") return std::make_unique<SpaceMouseHands>();
    return nullptr;
}

void follow(Hands& hands, const std::string& line) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "push") {
        dvec2 way_mm(0.0);
        double speed_mm_s = 0.0;
        words >> way_mm.x >> way_mm.y >> speed_mm_s;
        hands.push(way_mm, speed_mm_s);
    } else if (what == "rest") {
        double seconds = 0.0;
        words >> seconds;
        rest(seconds);
    } else {
        std::string button;
        words >> button;
        hands.hold(button, what == "hold");
    }
    std::puts("done");
    std::fflush(stdout);
}

int start(char** words) {
    const int child = ::fork();
    if (child != 0) return child;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    ::execv(words[0], words);
    ::_exit(127);
}

// Line by line, until the program ends.
int play(Hands& hands, int child) {
    std::string waiting;
    for (;;) {
        int status = 0;
        if (::waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
        constexpr int kLookMs = 20;
        pollfd look{STDIN_FILENO, POLLIN, 0};
        if (::poll(&look, 1, kLookMs) <= 0 || (look.revents & POLLIN) == 0) {
            if ((look.revents & POLLHUP) != 0) rest(0.001 * kLookMs);
            continue;
        }
        char letter = 0;
        while (::read(STDIN_FILENO, &letter, 1) == 1 && letter != '\n')
            waiting += letter;
        if (letter != '\n') continue;
        follow(hands, waiting);
        waiting.clear();
    }
}

}  // namespace
}  // namespace onggi

int main(int argc, char** argv) {
    using namespace onggi;
    constexpr int kDevice = 1;
    constexpr int kProgram = 2;
    const auto hands = argc > kProgram ? hands_on(argv[kDevice]) : nullptr;
    if (!hands) {
        std::fputs("hands_at: expected gamepad or spacemouse, and PROGRAM [WORD ...]\n", stderr);
        return 2;
    }
    return play(*hands, start(argv + kProgram));
}
