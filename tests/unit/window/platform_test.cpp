// Which window system GLFW is asked for. The system's GLFW may be 3.3, which has one only: this program
// defines the two functions of 3.4 that the choice uses, and the linker takes them instead of GLFW's.
#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>
#include <vector>

#include "engine/window/window.h"

namespace {

using Hint = std::pair<int, int>;
std::vector<Hint> hints;

}  // namespace

extern "C" void glfwInitHint(int hint, int value) {
    hints.emplace_back(hint, value);
}
extern "C" int glfwGetPlatform() {
    return 0;
}

namespace onggi::window {
namespace {

// From GLFW 3.4's header.
constexpr Hint kX11{0x00050003, 0x00060004};
constexpr Hint kAny{0x00050003, 0x00060000};

std::vector<Hint> asked_with_display(const char* display) {
    hints.clear();
    if (display == nullptr) {
        ::unsetenv("DISPLAY");  // NOLINT: no other thread runs
    } else {
        ::setenv("DISPLAY", display, 1);  // NOLINT: no other thread runs
    }
    static_cast<void>(why_no_display());
    return hints;
}

TEST(ThePlatform, IsX11WhereAnXServerAnswersAndElseAnother) {
    EXPECT_EQ(asked_with_display(":no-such-server"), (std::vector<Hint>{kX11, kAny}));
}

TEST(ThePlatform, IsLeftToGlfwWithoutAnXServer) {
    EXPECT_EQ(asked_with_display(nullptr), std::vector<Hint>{kAny});
    EXPECT_EQ(asked_with_display(""), std::vector<Hint>{kAny});
}

}  // namespace
}  // namespace onggi::window
