// From the hand's input to the tool, in the haptic thread: no clock, only the ticks' steps.
#include "engine/haptics/hid/tool_tracker.h"

#include <gtest/gtest.h>

namespace onggi::haptics::hid {
namespace {

constexpr double kStep = 0.001;

DeviceInput pushing(std::uint64_t heartbeat) {
    return {.motion = DeviceInput::Motion::kRate,
            .rate_mm_s = {-50.0, 20.0},
            .button = true,
            .is_live = true,
            .heartbeat = heartbeat};
}

TEST(ToolTracker, MovesByTheRateOfTheHand) {
    ToolTracker tracker;
    HandSample tool;
    for (std::uint64_t tick = 1; tick <= 1000; ++tick)
        tool = tracker.moved(pushing(tick), kStep);
    EXPECT_NEAR(tool.position_mm.x, 60.0, 1e-9);
    EXPECT_NEAR(tool.position_mm.y, 80.0, 1e-9);
    EXPECT_EQ(tool.position_mm.z, 0.0);
    EXPECT_TRUE(tool.button);
}

TEST(ToolTracker, StaysWhereItIsWhenTheIoThreadStandsStill) {
    ToolTracker tracker;
    HandSample tool;
    double moved_mm = 0.0;
    double x_mm = tracker.moved(pushing(1), kStep).position_mm.x;
    for (int tick = 0; tick < 1000; ++tick) {
        tool = tracker.moved(pushing(1), kStep);
        moved_mm += x_mm - tool.position_mm.x;
        x_mm = tool.position_mm.x;
    }
    EXPECT_LE(moved_mm, 50.0 * 0.051) << "50 ms at 50 mm/s";
    EXPECT_FALSE(tool.button);
    EXPECT_FALSE(tracker.input_is_live());
    EXPECT_TRUE(tracker.moved(pushing(2), kStep).button) << "and goes on when it goes on";
}

TEST(ToolTracker, TellsARefreshedPlaceFromAThreadThatLives) {
    ToolTracker tracker;
    DeviceInput input = pushing(1);
    input.refreshed = 1;
    (void)tracker.moved(input, kStep);
    EXPECT_TRUE(tracker.was_refreshed());
    (void)tracker.moved(input, kStep);
    EXPECT_FALSE(tracker.was_refreshed()) << "the same again";
    for (input.heartbeat = 2; input.heartbeat < 10; ++input.heartbeat) {
        (void)tracker.moved(input, kStep);
        EXPECT_FALSE(tracker.was_refreshed()) << "its heart beats, and the device is mute";
    }
    EXPECT_TRUE(tracker.input_is_live());
    input.refreshed = 2;
    (void)tracker.moved(input, kStep);
    EXPECT_TRUE(tracker.was_refreshed());
}

TEST(ToolTracker, StaysInPlaceWithoutADevice) {
    ToolTracker tracker;
    DeviceInput input = pushing(1);
    const HandSample before = tracker.moved(input, kStep);
    input.is_live = false;
    for (std::uint64_t tick = 2; tick < 100; ++tick) {
        input.heartbeat = tick;
        EXPECT_EQ(tracker.moved(input, kStep).position_mm, before.position_mm);
        EXPECT_FALSE(tracker.moved(input, kStep).button);
    }
}

TEST(ToolTracker, AddsTheHandsTravelOnceWithoutAJump) {
    ToolTracker tracker;
    DeviceInput input{.motion = DeviceInput::Motion::kRate, .travelled_mm = {500.0, 0.0}, .heartbeat = 1};
    const HandSample before = tracker.moved(input, kStep);
    input.is_live = true;
    input.heartbeat = 2;
    EXPECT_EQ(tracker.moved(input, kStep).position_mm, before.position_mm) << "travelled before it was heard";
    input.travelled_mm = {495.0, 3.0};
    input.heartbeat = 3;
    EXPECT_EQ(tracker.moved(input, kStep).position_mm, before.position_mm + dvec3(-5.0, 3.0, 0.0));
    EXPECT_TRUE(tracker.hand_moves());
    EXPECT_EQ(tracker.moved(input, kStep).position_mm, before.position_mm + dvec3(-5.0, 3.0, 0.0));
    EXPECT_FALSE(tracker.hand_moves());
}

TEST(ToolTracker, GoesOnFromWhereAnotherHandLeftTheTool) {
    ToolTracker tracker;
    (void)tracker.moved(pushing(1), kStep);
    tracker.put_at({80.0, 40.0, 7.0});
    const HandSample tool = tracker.moved(pushing(2), kStep);
    EXPECT_NEAR(tool.position_mm.x, 80.0 - 0.05, 1e-9);
    EXPECT_NEAR(tool.position_mm.y, 40.0 + 0.02, 1e-9);
}

TEST(ToolTracker, KeepsTheWheelsSpeedThatTheHandHasChanged) {
    ToolTracker tracker;
    DeviceInput input = pushing(1);
    EXPECT_EQ(tracker.moved(input, kStep).rev_min, 120.0);
    input.change_rev_min_s = 40.0;
    HandSample tool;
    for (std::uint64_t tick = 2; tick < 1002; ++tick) {
        input.heartbeat = tick;
        tool = tracker.moved(input, kStep);
    }
    EXPECT_NEAR(tool.rev_min, 160.0, 1e-6);
    input.change_rev_min_s = 0.0;
    input.rev_min = 77.0;
    EXPECT_EQ(tracker.moved(input, kStep).rev_min, 77.0) << "or said outright";
    input.rev_min = 1e9;
    EXPECT_EQ(tracker.moved(input, kStep).rev_min, 240.0);
}

TEST(ToolTracker, NeverLeavesItsReach) {
    const ToolReach reach;
    ToolTracker tracker(reach);
    DeviceInput input = pushing(1);
    input.rate_mm_s = {-1e6, 1e6};
    input.press_mm = 1e6;
    for (; input.heartbeat < 1000; ++input.heartbeat) {
        const HandSample tool = tracker.moved(input, kStep);
        EXPECT_GE(tool.position_mm.x, reach.least_radius_mm);
        EXPECT_LE(tool.position_mm.y, reach.most_height_mm);
    }
}

TEST(ToolTracker, DrawsTheToolToAStickInsteadOfTearingItThere) {
    ToolTracker tracker;  // starts at radius 110
    DeviceInput input{
        .motion = DeviceInput::Motion::kPlace, .place_mm = {20.0, 60.0}, .is_live = true, .heartbeat = 1};
    double x_mm = 110.0;
    for (; input.heartbeat < 150; ++input.heartbeat) {
        const double next_mm = tracker.moved(input, kStep).position_mm.x;
        EXPECT_LE(x_mm - next_mm, 600.0 * kStep + 1e-9);
        x_mm = next_mm;
    }
    EXPECT_NEAR(x_mm, 20.6, 0.01);  // 149 steps of 0.6 mm
    for (; input.heartbeat < 155; ++input.heartbeat)
        x_mm = tracker.moved(input, kStep).position_mm.x;
    EXPECT_EQ(x_mm, 20.0);
}

TEST(ToolTracker, PressesInwardsFromWhereItStands) {
    ToolTracker tracker;
    DeviceInput input{
        .motion = DeviceInput::Motion::kRate, .press_mm = 12.0, .is_live = true, .heartbeat = 1};
    HandSample tool;
    for (; input.heartbeat < 100; ++input.heartbeat)
        tool = tracker.moved(input, kStep);
    EXPECT_NEAR(tool.position_mm.x, 98.0, 1e-9);
    input.press_mm = 0.0;
    for (; input.heartbeat < 200; ++input.heartbeat)
        tool = tracker.moved(input, kStep);
    EXPECT_NEAR(tool.position_mm.x, 110.0, 1e-9);
}

}  // namespace
}  // namespace onggi::haptics::hid
