// The sound scene of a snapshot.
#include "game/app/kiosk/presentation/kiosk_sound.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "game/kiosk/strings.h"
#include "game/tool/tool.h"
#include "tests/support/comes_true.h"

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
    EXPECT_NEAR(scene.rev_min, 95.49, 0.01);
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
    snapshot.tool.tool = tool::Tool::kTrimmer;
    pot::Pot shape;
    shape.inner_mm = {50.0F};
    snapshot.pot = &shape;
    snapshot.hand_film = 0.3;
    const sound::SoundScene scene = scene_of(snapshot, 0.5);
    EXPECT_NEAR(scene.contact_n, 3.0, 1e-12);
    EXPECT_NEAR(scene.motor_load, 0.5, 1e-12);
    EXPECT_TRUE(scene.is_hard_tool);
    EXPECT_EQ(scene.wetness, 0.3);
}

TEST(KioskSound, HasCaptions) {
    EXPECT_EQ(caption_key({}), "") << "a wheel at rest";
    EXPECT_EQ(caption_key({.rev_min = 110.0}), "cap.wheel");
    EXPECT_EQ(caption_key({.rev_min = -110.0, .contact_n = 1.0, .wetness = 0.8}), "cap.water");
    EXPECT_EQ(caption_key({.rev_min = 110.0, .contact_n = 1.0, .wetness = 0.1}), "cap.wheel");
    EXPECT_EQ(caption_key({.contact_n = 1.0, .wetness = 0.8}), "") << "nothing passes under the hand";
    for (const kiosk::Language& language : kiosk::built_in_languages())
        for (const char* key : {"cap.wheel", "cap.water", "cap.kiln"})
            EXPECT_TRUE(language.has(key)) << language.code() << ' ' << key;
}

TEST(KioskSound, SlapsForEachLump) {
    haptic::Snapshot snapshot = touching();
    const auto before = scene_of(snapshot, 0.5).slaps;
    ++snapshot.run;
    EXPECT_EQ(scene_of(snapshot, 0.5).slaps, before + 1);
}

// A sound place without a device, which counts attempts.
class CountingPlace final : public sound::SoundPlace {
  public:
    explicit CountingPlace(std::atomic<int>& asked) : asked_(asked) {}
    Result<std::unique_ptr<sound::SoundPlayer>> open() override {
        ++asked_;
        return system_lacks("no loudspeaker");
    }

  private:
    std::atomic<int>& asked_;
};

std::string news_of(KioskSound& sound) {
    std::string line;
    test::comes_true([&] {
        sound.hear(touching());
        return !(line = sound.news()).empty();
    });
    return line;
}

TEST(KioskSound, OpensTheDeviceWhenTheVolumeFirstRisesAndNotBefore) {
    std::atomic<int> asked{0};
    int made = 0;
    KioskSound sound(0.0, false, [&] {
        ++made;
        return std::make_unique<CountingPlace>(asked);
    });
    sound.hear(touching());
    sound.set_volume(0.0);
    EXPECT_EQ(sound.news(), "");
    EXPECT_EQ(made, 0);
    sound.set_volume(0.4);
    EXPECT_EQ(news_of(sound), "sound: none; no loudspeaker");
    EXPECT_EQ(asked, 1);
    sound.set_volume(0.0);
    sound.set_volume(1.0);
    EXPECT_EQ(made, 1) << "once";
}

TEST(KioskSound, KeepsAFixedVolume) {
    KioskSound silent(0.0, true);
    silent.set_volume(1.0);
    EXPECT_FALSE(silent.is_audible());
    EXPECT_EQ(silent.device(), "");
    EXPECT_EQ(silent.lack(), "switched off for this run by --volume 0");
    EXPECT_EQ(silent.news(), "");
}

}  // namespace
}  // namespace onggi::app
