// The sound's I/O thread without its thread and without a device.
#include "engine/sound/sound_output.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "tests/support/comes_true.h"

namespace onggi::sound {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

struct FakeHall {
    bool has_a_device = true;
    bool is_gone = false;
    std::size_t wanted = kBlocksAhead;
    int times_opened = 0;
    int open_players = 0;
    int paused_ms = 0;
    std::vector<Sample> heard = {};
};

class FakePlayer final : public SoundPlayer {
  public:
    explicit FakePlayer(FakeHall& hall) : hall_(hall) { ++hall_.open_players; }
    ~FakePlayer() override { --hall_.open_players; }
    [[nodiscard]] std::string name() const override { return "hall"; }
    Result<std::size_t> blocks_wanted() override {
        if (hall_.is_gone) return failed("gone");
        return hall_.wanted;
    }
    Result<void> play(std::span<const Sample, kBlockFrames> block) override {
        hall_.heard.insert(hall_.heard.end(), block.begin(), block.end());
        return {};
    }
    void pause_ms(int milliseconds) override { hall_.paused_ms += milliseconds; }

  private:
    FakeHall& hall_;
};

class FakePlace final : public SoundPlace {
  public:
    explicit FakePlace(FakeHall& hall) : hall_(hall) {}
    Result<std::unique_ptr<SoundPlayer>> open() override {
        ++hall_.times_opened;
        if (!hall_.has_a_device) return system_lacks("no hall");
        hall_.is_gone = false;
        return std::unique_ptr<SoundPlayer>(std::make_unique<FakePlayer>(hall_));
    }

  private:
    FakeHall& hall_;
};

class SoundWorkTest : public ::testing::Test {
  protected:
    FakeHall hall_;
    SoundWork work_{std::make_unique<FakePlace>(hall_)};
};

TEST_F(SoundWorkTest, PlaysTheNewestSceneAsFarAheadAsIsWanted) {
    work_.scene.put({.rev_min = 120.0, .volume = 1.0});
    const std::int64_t rest_ns = work_.round(0);
    EXPECT_GT(rest_ns, 0);
    EXPECT_LT(rest_ns, kSecond / 100) << "less than a block";
    EXPECT_EQ(hall_.heard.size(), kBlocksAhead * kBlockFrames);
    EXPECT_TRUE(work_.status.latest().is_heard);
    EXPECT_EQ(work_.status.latest().device, "hall");
    EXPECT_EQ(work_.status.latest().blocks, kBlocksAhead);
    hall_.wanted = 0;
    (void)work_.round(rest_ns);
    EXPECT_EQ(hall_.heard.size(), kBlocksAhead * kBlockFrames);
    EXPECT_NE(hall_.heard.back().left, 0.0F);
}

TEST_F(SoundWorkTest, IsSilentWithoutADeviceAndLooksAgainLater) {
    hall_.has_a_device = false;
    EXPECT_GT(work_.round(0), 10 * kSecond);
    EXPECT_FALSE(work_.status.latest().is_heard);
    EXPECT_EQ(work_.status.latest().message, "no hall");
    (void)work_.round(kSecond);
    EXPECT_EQ(hall_.times_opened, 1) << "not every round";
    hall_.has_a_device = true;
    (void)work_.round(31 * kSecond);
    EXPECT_TRUE(work_.status.latest().is_heard);
    EXPECT_EQ(work_.status.latest().message, "");
}

TEST_F(SoundWorkTest, OutlivesADeviceThatIsPulledOut) {
    (void)work_.round(0);
    hall_.is_gone = true;
    (void)work_.round(kSecond);
    EXPECT_FALSE(work_.status.latest().is_heard);
    EXPECT_EQ(hall_.open_players, 0);
    (void)work_.round(32 * kSecond);
    EXPECT_TRUE(work_.status.latest().is_heard);
    EXPECT_EQ(hall_.open_players, 1);
}

// What OpenAL shows of a sound server that ended: connected, and nothing is taken.
TEST_F(SoundWorkTest, ClosesADeviceThatTakesNoSoundForTwoSecondsAndLooksAgain) {
    (void)work_.round(0);
    hall_.wanted = 0;
    (void)work_.round(2 * kSecond);
    EXPECT_TRUE(work_.status.latest().is_heard) << "late, not stuck";
    hall_.wanted = 1;
    (void)work_.round(3 * kSecond);
    hall_.wanted = 0;
    (void)work_.round(5 * kSecond);
    EXPECT_EQ(hall_.open_players, 1) << "it took a block two seconds ago";
    (void)work_.round(5 * kSecond + kSecond / 100);
    EXPECT_EQ(hall_.open_players, 0);
    EXPECT_FALSE(work_.status.latest().is_heard);
    EXPECT_EQ(work_.status.latest().message, "the sound device takes no more sound");
    hall_.wanted = kBlocksAhead;
    (void)work_.round(36 * kSecond);
    EXPECT_EQ(hall_.open_players, 1);
    (void)work_.round(37 * kSecond);
    EXPECT_TRUE(work_.status.latest().is_heard);
}

TEST_F(SoundWorkTest, FadesOutAtTheEnd) {
    work_.scene.put({.rev_min = 120.0, .volume = 1.0});
    for (int round = 0; round < 20; ++round)
        (void)work_.round(round * kSecond / 200);
    work_.finish();
    EXPECT_EQ(hall_.open_players, 0);
    EXPECT_LE(hall_.paused_ms, 150);
    EXPECT_LT(std::abs(hall_.heard.back().left), 1e-4F);
    work_.finish();
}

TEST(SoundOutput, RunsOnItsOwnThreadAndEnds) {
    FakeHall hall;
    hall.has_a_device = false;
    SoundOutput sound(std::make_unique<FakePlace>(hall));
    ASSERT_TRUE(sound.open());
    ASSERT_TRUE(sound.open()) << "a second time changes nothing";
    sound.play({.rev_min = 60.0});
    test::comes_true([&] { return !sound.status().message.empty(); });
    EXPECT_EQ(sound.status().message, "no hall");
    sound.close();
    EXPECT_EQ(hall.times_opened, 1);
}

}  // namespace
}  // namespace onggi::sound
