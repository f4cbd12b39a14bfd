// A pipe replaces the keyboard: both yield the kernel's events.
#include "engine/haptics/stop_key.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "tests/support/comes_true.h"

namespace onggi::haptics {
namespace {

struct Keyboard {
    Keyboard() { EXPECT_EQ(::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC), 0); }
    ~Keyboard() { pull_out(); }
    void press(int key, int value = 1) const {
        input_event event{};
        event.type = EV_KEY;
        event.code = static_cast<std::uint16_t>(key);
        event.value = value;
        EXPECT_EQ(::write(ends[1], &event, sizeof(event)), static_cast<ssize_t>(sizeof(event)));
    }
    void pull_out() {
        if (ends[1] >= 0) ::close(ends[1]);
        ends[1] = -1;
    }
    std::array<int, 2> ends{-1, -1};
};

StopKey::Find these(std::vector<int> files) {
    return [files = std::move(files)](const std::vector<std::string>& known) {
        std::vector<StopKeyboard> found;
        for (const int file : files)
            if (known.empty()) found.push_back({"event" + std::to_string(file), file});
        return found;
    };
}

TEST(StopKey, HearsOnlyPauseAndStop) {
    Keyboard keyboard;
    int presses = 0;
    StopKey key(these({keyboard.ends[0]}), [&] { ++presses; });
    keyboard.press(KEY_A);
    keyboard.press(KEY_PAUSE, 0);  // let go
    keyboard.press(KEY_PAUSE, 2);  // held
    (void)key.round(0);
    EXPECT_EQ(presses, 0);
    keyboard.press(KEY_PAUSE);
    (void)key.round(0);
    EXPECT_EQ(presses, 1);
    keyboard.press(KEY_STOP);
    (void)key.round(0);
    EXPECT_EQ(presses, 2);
    (void)key.round(0);  // nothing: comes back after its wait
    EXPECT_EQ(presses, 2);
}

TEST(StopKey, SurvivesAKeyboardThatIsPulledOut) {
    Keyboard gone;
    Keyboard there;
    int presses = 0;
    StopKey key(these({gone.ends[0], there.ends[0]}), [&] { ++presses; });
    gone.pull_out();
    (void)key.round(0);
    there.press(KEY_PAUSE);
    (void)key.round(0);
    EXPECT_EQ(presses, 1);
}

TEST(StopKey, WorksWhileEveryOtherThreadHangs) {
    // This thread is the one that hangs: it only sleeps.
    Keyboard keyboard;
    std::atomic<bool> stopped{false};
    StopKey key(these({keyboard.ends[0]}), [&] { stopped = true; });
    jobs::IoThread thread;
    ASSERT_TRUE(thread.start(key, "onggi-stop-key"));
    keyboard.press(KEY_PAUSE);
    EXPECT_TRUE(test::comes_true([&] { return stopped.load(); }));
    thread.stop();
}

TEST(StopKey, HearsAKeyboardThatIsPluggedInAgain) {
    Keyboard before;
    Keyboard after;
    std::vector<StopKeyboard> plugged{{"event3", before.ends[0]}};
    int presses = 0;
    StopKey key(
        [&](const std::vector<std::string>& known) {
            for (const StopKeyboard& one : plugged)
                EXPECT_EQ(std::count(known.begin(), known.end(), one.name), 0) << "opened twice";
            return std::exchange(plugged, {});
        },
        [&] { ++presses; });
    EXPECT_EQ(key.found(), 1U);
    std::int64_t now_ns = 1;
    (void)key.round(now_ns);
    before.pull_out();
    (void)key.round(now_ns);
    EXPECT_EQ(key.found(), 0U);
    plugged = {{"event3", after.ends[0]}};
    (void)key.round(now_ns += StopKey::kLooksEveryNs - 1);
    EXPECT_EQ(key.found(), 0U) << "not at every turn";
    (void)key.round(now_ns += 2);
    EXPECT_EQ(key.found(), 1U);
    after.press(KEY_STOP);
    (void)key.round(now_ns);
    EXPECT_EQ(presses, 1);
}

TEST(StopKey, FindsNoKeyboardWithoutAFolder) {
    EXPECT_TRUE(open_stop_keys({}, "/nowhere/at/all").empty());
}

}  // namespace
}  // namespace onggi::haptics
