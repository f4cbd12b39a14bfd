// The log: every event once, and no flood.
#include "game/app/system/report.h"

#include <gtest/gtest.h>

namespace onggi::app {
namespace {

TEST(LogLines, SayEveryLineAtOnce) {
    LogLines lines;
    EXPECT_EQ(lines.say("device: a pedal is here", 0.0), "device: a pedal is here");
    EXPECT_EQ(lines.say("device: a pedal is gone", 0.0), "device: a pedal is gone");
}

TEST(LogLines, CountRepetitionsWithinAMinute) {
    LogLines lines;
    EXPECT_TRUE(lines.say("the wheel rests", 0.0));
    for (int second = 5; second < 60; second += 5)
        EXPECT_FALSE(lines.say("the wheel rests", second));
    EXPECT_EQ(lines.say("the wheel rests", 60.0), "the wheel rests (and 11 times in between)");
    EXPECT_FALSE(lines.say("the wheel rests", 119.0));
    EXPECT_EQ(lines.say("the wheel rests", 300.0), "the wheel rests (and 1 times in between)");
    EXPECT_EQ(lines.say("the wheel rests", 400.0), "the wheel rests");
}

TEST(LogLines, StayFewInADayOfALooseCable) {
    LogLines lines;
    int said = 0;
    for (int second = 0; second < 86'400; ++second) {
        said += lines.say("device: a stick is here", second) ? 1 : 0;
        said += lines.say("device: a stick is gone", second + 0.5) ? 1 : 0;
    }
    EXPECT_EQ(said, 2 * 24 * 60);
}

TEST(LogLines, RememberNoMoreThanAFew) {
    LogLines lines;
    for (int line = 0; line < 1000; ++line)
        EXPECT_TRUE(lines.say("pot " + std::to_string(line), 0.0));
    EXPECT_TRUE(lines.say("pot 0", 1.0)) << "long forgotten";
    EXPECT_FALSE(lines.say("pot 999", 1.0));
}

}  // namespace
}  // namespace onggi::app
