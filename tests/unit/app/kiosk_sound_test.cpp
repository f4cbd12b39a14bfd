// What of a snapshot is heard.
#include "game/app/kiosk_sound.h"

#include <gtest/gtest.h>

namespace onggi::app {
namespace {

haptic::Snapshot touching() {
    haptic::Snapshot snapshot;
    snapshot.tool.position_mm = {60.0, 50.0, 80.0};
    snapshot.wheel_speed_rad_s = 10.0;
    snapshot.result.forces.stiffness_n = {1.2, 0.0, 1.6};
    return snapshot;
}

TEST(KioskSound, HearsTheWheelTheHandAndWhereItIs) {
    const sound::SoundScene scene = scene_of(touching(), 0.7);
    EXPECT_NEAR(scene.wheel_rev_min, 95.49, 0.01);
    EXPECT_NEAR(scene.contact_n, 2.0, 1e-12);
    EXPECT_NEAR(scene.slip_mm_s, 1000.0, 1e-9) << "10 rad/s at 100 mm";
    EXPECT_NEAR(scene.place, 0.4, 1e-12);
    EXPECT_EQ(scene.volume, 0.7);
    EXPECT_FALSE(scene.is_hard_tool);
}

TEST(KioskSound, HearsBothHandsTheEdgeTheLoadAndTheWater) {
    haptic::Snapshot snapshot = touching();
    snapshot.result.second_forces.stiffness_n = {0.0, 0.0, -1.0};
    snapshot.result.wheel_load_n_mm = -150.0;
    snapshot.tool.tool = haptics::ToolKind::kTrimmer;
    haptic::PotShape shape;
    shape.is_hollow = true;
    snapshot.shape = &shape;
    snapshot.hand_film = 0.3;
    const sound::SoundScene scene = scene_of(snapshot, 0.5);
    EXPECT_NEAR(scene.contact_n, 3.0, 1e-12);
    EXPECT_NEAR(scene.motor_load, 0.5, 1e-12);
    EXPECT_TRUE(scene.is_hard_tool);
    EXPECT_EQ(scene.wetness, 0.3);
}

TEST(KioskSound, SlapsForEachLump) {
    haptic::Snapshot snapshot = touching();
    const auto before = scene_of(snapshot, 0.5).slaps;
    ++snapshot.run;
    EXPECT_EQ(scene_of(snapshot, 0.5).slaps, before + 1);
}

TEST(KioskSound, AtVolumeNothingOpensNothingAndSaysNothing) {
    KioskSound sound(0.0);
    sound.hear(touching());
    EXPECT_EQ(sound.news(), "");
}

}  // namespace
}  // namespace onggi::app
