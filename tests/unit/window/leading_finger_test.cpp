#include "engine/window/touch_screen.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

namespace onggi::window {
namespace {

using Phase = Touch::Phase;

// Fingers on a screen, and the equivalent events as text: "at 10,20 down at 11,20 up", and of a second finger
// "2 down 50,60".
class AScreen : public testing::Test {
  protected:
    void touch(Phase phase, std::uint32_t finger, double x, double y, std::uint32_t time_ms) {
        std::vector<Event> events;
        leading_.follow({phase, finger, x, y, time_ms}, events);
        for (const Event& event : events) {
            if (!seen_.empty()) seen_ += ' ';
            if (const auto* pointer = std::get_if<PointerEvent>(&event))
                seen_ += fmt::format("at {:.0f},{:.0f}", pointer->x_px, pointer->y_px);
            else if (const auto* second = std::get_if<SecondFingerEvent>(&event))
                seen_ += fmt::format("2 {} {:.0f},{:.0f}",
                                     second->phase == Phase::kBegin  ? "down"
                                     : second->phase == Phase::kMove ? "at"
                                                                     : "up",
                                     second->x_px, second->y_px);
            else
                seen_ += std::get<ButtonEvent>(event).pressed ? "down" : "up";
        }
    }
    std::string seen() { return std::exchange(seen_, {}); }

    LeadingFinger leading_;
    std::string seen_;
};

TEST_F(AScreen, IsAPointerToOneFinger) {
    touch(Phase::kBegin, 7, 10, 20, 1000);
    touch(Phase::kMove, 7, 11, 20, 1010);
    touch(Phase::kEnd, 7, 12, 20, 1020);
    EXPECT_EQ(seen(), "at 10,20 down at 11,20 at 12,20 up");
    touch(Phase::kBegin, 8, 50, 60, 1030);
    EXPECT_EQ(seen(), "at 50,60 down");
}

TEST_F(AScreen, HasASecondFingerThatIsNoPointerAndIgnoresAThird) {
    touch(Phase::kBegin, 1, 100, 100, 0);
    for (std::uint32_t step = 1; step <= 10; ++step)
        touch(Phase::kMove, 1, 100, 100 + 30.0 * step, 1000 * step);
    static_cast<void>(seen());
    touch(Phase::kBegin, 2, 600, 600, 12000);
    touch(Phase::kMove, 2, 610, 600, 12010);
    EXPECT_EQ(seen(), "2 down 600,600 2 at 610,600");
    touch(Phase::kBegin, 3, 700, 100, 12015);
    touch(Phase::kMove, 3, 720, 100, 12016);
    touch(Phase::kEnd, 3, 720, 100, 12017);
    EXPECT_EQ(seen(), "");
    touch(Phase::kEnd, 2, 610, 600, 12020);
    EXPECT_EQ(seen(), "2 up 610,600");
    touch(Phase::kEnd, 1, 100, 400, 12030);
    EXPECT_EQ(seen(), "at 100,400 up");
}

TEST_F(AScreen, LeavesTheSecondFingerTheSecondWhereTheFirstLifts) {
    touch(Phase::kBegin, 1, 100, 100, 0);
    touch(Phase::kBegin, 2, 600, 600, 100);
    touch(Phase::kEnd, 1, 100, 100, 200);
    touch(Phase::kMove, 2, 610, 600, 300);
    EXPECT_EQ(seen(), "at 100,100 down 2 down 600,600 at 100,100 up 2 at 610,600");
    touch(Phase::kBegin, 3, 50, 60, 400);
    EXPECT_EQ(seen(), "at 50,60 down") << "the next finger is the pointer again";
}

TEST_F(AScreen, KeepsAStillFingerThatHoldsTheClay) {
    touch(Phase::kBegin, 1, 600, 300, 0);
    leading_.keep(true, false);
    static_cast<void>(seen());
    touch(Phase::kBegin, 2, 500, 300, 10'000);
    EXPECT_EQ(seen(), "2 down 500,300") << "a child's finger is not taken for a palm";
    touch(Phase::kBegin, 3, 550, 300, 20'000);
    EXPECT_EQ(seen(), "2 up 500,300 2 down 550,300") << "the second was an elbow beside the clay";
    leading_.keep(true, true);
    touch(Phase::kBegin, 4, 560, 300, 30'000);
    EXPECT_EQ(seen(), "");
    touch(Phase::kBegin, 5, 560, 300, 300'000);
    EXPECT_EQ(seen(), "at -1,-1 up at 560,300 down") << "nobody holds still for minutes";
}

TEST_F(AScreen, LetsANewFingerReplaceOneThatLiesStill) {
    touch(Phase::kBegin, 1, 3, 500, 0);
    for (std::uint32_t wander = 0; wander < 100; ++wander)
        touch(Phase::kMove, 1, 3.0 + wander % 5, 500, 100 * wander);
    static_cast<void>(seen());
    touch(Phase::kBegin, 2, 600, 300, 10000);
    EXPECT_EQ(seen(), "at -1,-1 up at 600,300 down") << "nothing is pressed where it lies";
    touch(Phase::kMove, 1, 300, 500, 10010);
    EXPECT_EQ(seen(), "") << "it is ignored now";
    touch(Phase::kEnd, 2, 600, 300, 10020);
    EXPECT_EQ(seen(), "at 600,300 up");
    touch(Phase::kMove, 1, 310, 500, 10030);
    touch(Phase::kEnd, 1, 310, 500, 10040);
    EXPECT_EQ(seen(), "") << "and stays so until it is lifted";
    touch(Phase::kBegin, 1, 310, 500, 10050);
    EXPECT_EQ(seen(), "at 310,500 down");
}

TEST_F(AScreen, LetsANewFingerReplaceOneThatIsNeverLifted) {
    touch(Phase::kBegin, 1, 300, 500, 1000);
    std::uint32_t time_ms = 1000;
    const auto wanders_until = [&](std::uint32_t end_ms) {
        for (; time_ms < end_ms; time_ms += 500)
            touch(Phase::kMove, 1, 300.0 + 40.0 * (time_ms / 500 % 2), 500, time_ms);
        static_cast<void>(seen());
    };
    wanders_until(300'000);
    touch(Phase::kBegin, 2, 600, 300, 300'000);
    EXPECT_EQ(seen(), "2 down 600,300");
    wanders_until(301'000);
    touch(Phase::kBegin, 3, 600, 300, 301'000);
    EXPECT_EQ(seen(), "at -1,-1 up at 600,300 down") << "a drop of water kept everybody out";
}

TEST_F(AScreen, WaitsBeforeItTakesAFingerForAHandThatLies) {
    touch(Phase::kBegin, 1, 640, 300, std::numeric_limits<std::uint32_t>::max() - 500);
    static_cast<void>(seen());
    touch(Phase::kBegin, 2, 600, 300, 2000);  // two seconds and a half later, over the end of the count
    EXPECT_EQ(seen(), "2 down 600,300");
    touch(Phase::kBegin, 3, 600, 300, 2600);
    EXPECT_EQ(seen(), "at -1,-1 up at 600,300 down");
}

TEST(PointerArrow, IsShownOnlyWhileAMouseMoves) {
    PointerArrow arrow(false);
    EXPECT_FALSE(arrow.is_shown(0.0)) << "a touch kiosk has none from the start";
    arrow.moved(640.0, 360.0, 1.0);
    EXPECT_FALSE(arrow.is_shown(1.0)) << "the display server has put it there";
    for (int shake = 0; shake < 50; ++shake)
        arrow.moved(640.0 + shake % 2 * 9.0, 360.0, 2.0 + 0.02 * shake);
    EXPECT_FALSE(arrow.is_shown(3.0)) << "somebody bumped into the desk";
    for (int step = 0; step < 5; ++step)
        arrow.moved(640.0 + 10.0 * step, 360.0, 5.0 + 0.01 * step);
    EXPECT_TRUE(arrow.is_shown(5.1));
    EXPECT_TRUE(arrow.is_shown(20.0));
    EXPECT_FALSE(arrow.is_shown(30.0)) << "left alone";
    for (int step = 0; step < 5; ++step)
        arrow.moved(640.0 - 10.0 * step, 360.0, 40.0 + 0.01 * step);
    EXPECT_TRUE(arrow.is_shown(40.1));
    arrow.touched();
    EXPECT_FALSE(arrow.is_shown(40.2));
}

}  // namespace
}  // namespace onggi::window
