// A gamepad in somebody's hands: gamepad_at PROGRAM [WORD ...] starts the program among devices that umockdev
// describes, a gamepad among them, and is told what the hands do, a line each: "push X Y SPEED", the left
// stick so far and so long that a finger goes X mm to the right and Y mm up at that many mm/s; "hold BUTTON"
// and "let-go BUTTON", a or trigger; "rest S". It answers each with a line "done" when it is done. Ends with
// the program, and with its exit code. Runs under umockdev-wrapper.
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
#include <sstream>
#include <string>
#include <thread>

#include "game/app/gamepad_hand.h"
#include "tests/device/mock_gamepad.h"

namespace onggi {
namespace {

using testing::GamepadIdentity;
using testing::MockGamepad;

constexpr int kFarthest = 32767;  // of a stick

void rest(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// As a hand that knows how the kiosk answers a stick.
void push(MockGamepad& pad, const dvec2& way_mm, double speed_mm_s) {
    const app::GamepadMapping mapping;
    const double length_mm = glm::length(way_mm);
    if (!(length_mm > 0.0)) return;
    const double share = std::min(speed_mm_s / mapping.fastest_mm_s, 1.0);
    const double deflection = mapping.dead_band + (1.0 - mapping.dead_band) * std::cbrt(share);
    const dvec2 stick = way_mm * (deflection / length_mm);
    pad.move(ABS_X, static_cast<int>(std::lround(kFarthest * stick.x)));
    pad.move(ABS_Y, static_cast<int>(std::lround(-kFarthest * stick.y)));
    rest(length_mm / (share * mapping.fastest_mm_s));
    pad.move(ABS_X, 0);
    pad.move(ABS_Y, 0);
}

void hold(MockGamepad& pad, const std::string& button, bool held) {
    if (button == "trigger") pad.move(ABS_RZ, held ? 255 : 0);
    if (button == "a") pad.press(BTN_A, held);
}

void obey(MockGamepad& pad, const std::string& line) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "push") {
        dvec2 way_mm(0.0);
        double speed_mm_s = 0.0;
        words >> way_mm.x >> way_mm.y >> speed_mm_s;
        push(pad, way_mm, speed_mm_s);
    } else if (what == "rest") {
        double seconds = 0.0;
        words >> seconds;
        rest(seconds);
    } else {
        std::string button;
        words >> button;
        hold(pad, button, what == "hold");
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
int play(MockGamepad& pad, int child) {
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
        obey(pad, waiting);
        waiting.clear();
    }
}

}  // namespace
}  // namespace onggi

int main(int argc, char** argv) {
    using namespace onggi;
    if (argc < 2) {
        std::fputs("gamepad_at: expected PROGRAM [WORD ...]\n", stderr);
        return 2;
    }
    UMockdevTestbed* testbed = umockdev_testbed_new();
    // It is there on every machine, and GLFW looks at it for what comes later.
    std::filesystem::create_directories(std::filesystem::path(umockdev_testbed_get_root_dir(testbed)) /
                                        "dev" / "input");
    int status = 0;
    {
        MockGamepad pad(testbed, {.node = 7,
                                  .name = "Microsoft X-Box 360 pad",
                                  .vendor_id = 0x045e,
                                  .product_id = 0x028e,
                                  .version = 0x0110});
        status = play(pad, start(argv + 1));
    }
    g_object_unref(testbed);
    return status;
}
