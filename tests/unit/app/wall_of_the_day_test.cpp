// The wall of the day on a real disk.
#include "game/app/kiosk/gallery/wall_of_the_day.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

constexpr const char* kToday = "2026-11-24";

WallPot pot_called(const std::string& name) {
    return {
        .gallery_name = name, .glaze = 3, .shape = pot::hollowed({{40, 0}, {55, 50}, {45, 100}}, 5.0F, 8.0F)};
}

class WallTest : public testing::Test {
  protected:
    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "state" / "wall.json";
    WallOfTheDay wall_{file_};
};

TEST_F(WallTest, OutlivesAStartInTheMiddleOfADayAndNoNight) {
    ASSERT_TRUE(wall_.open(kToday));
    ASSERT_TRUE(wall_.put(pot_called("2026-11-24/pot-001"), kToday));
    ASSERT_TRUE(wall_.put(pot_called("2026-11-24/pot-002"), kToday));
    WallOfTheDay later(file_);
    ASSERT_TRUE(later.open(kToday));
    ASSERT_EQ(later.pots().size(), 2U);
    EXPECT_EQ(later.pots()[0].gallery_name, "2026-11-24/pot-001");
    EXPECT_EQ(later.pots()[0].glaze, 3);
    EXPECT_EQ(later.pots()[0].shape.hash(), wall_.pots()[0].shape.hash()) << "to the bit";
    WallOfTheDay tomorrow(file_);
    ASSERT_TRUE(tomorrow.open("2026-11-25"));
    EXPECT_TRUE(tomorrow.pots().empty());
}

TEST_F(WallTest, KeepsHowAPotIsOffRound) {
    pot::OffRound map{.centre_mm = {{0.0F, 0.0F}, {1.83F, -0.7F}},
                      .dents_mm = std::vector<float>(2 * pot::OffRound::kCorners, 0.0F)};
    map.dents_mm.back() = -2.34F;
    WallPot pot = pot_called("pot-001");
    pot.shape.off_round = std::make_shared<const pot::OffRound>(map);
    ASSERT_TRUE(wall_.open(kToday));
    ASSERT_TRUE(wall_.put(pot, kToday));
    WallOfTheDay later(file_);
    ASSERT_TRUE(later.open(kToday));
    ASSERT_TRUE(later.pots().at(0).shape.off_round);
    EXPECT_EQ(later.pots()[0].shape.hash(), pot.shape.hash()) << "to the bit";
    EXPECT_FLOAT_EQ(later.pots()[0].shape.off_round->dent_at(1.0F, -1.0F / pot::OffRound::kCorners), -2.34F);
}

TEST_F(WallTest, HoldsEachPotOnceAndTheNewestOfThem) {
    for (int i = 0; i < 30; ++i)
        ASSERT_TRUE(wall_.put(pot_called("pot-" + std::to_string(i)), kToday));
    ASSERT_EQ(wall_.pots().size(), WallOfTheDay::kMostPots);
    EXPECT_EQ(wall_.pots().front().gallery_name, "pot-3");
    ASSERT_TRUE(wall_.put(pot_called("pot-10"), kToday));
    EXPECT_EQ(wall_.pots().size(), WallOfTheDay::kMostPots);
    EXPECT_EQ(wall_.pots().back().gallery_name, "pot-10");
    ASSERT_TRUE(wall_.take("pot-10"));
    ASSERT_TRUE(wall_.take("nobody's"));
    EXPECT_EQ(wall_.pots().back().gallery_name, "pot-29");
    ASSERT_TRUE(wall_.put(pot_called("early"), "2026-11-25"));
    EXPECT_EQ(wall_.pots().size(), 1U) << "yesterday's are gone";
    ASSERT_TRUE(wall_.clear());
    WallOfTheDay later(file_);
    ASSERT_TRUE(later.open("2026-11-25"));
    EXPECT_TRUE(later.pots().empty());
}

TEST_F(WallTest, ContinuesUntilTheClockIsSet) {
    ASSERT_TRUE(wall_.put(pot_called("before the power cut"), kToday));
    WallOfTheDay started(file_);
    ASSERT_TRUE(started.open("1970-01-01"));
    ASSERT_TRUE(started.put(pot_called("after it"), "1970-01-01"));
    EXPECT_EQ(started.pots().size(), 2U);
    ASSERT_TRUE(started.turn_to(kToday));
    EXPECT_EQ(started.pots().size(), 2U);
    ASSERT_TRUE(started.turn_to("2026-11-25"));
    EXPECT_TRUE(started.pots().empty());
}

TEST_F(WallTest, StartsEmptyIfItsFileIsDamaged) {
    std::filesystem::create_directories(file_.parent_path());
    for (const char* damage :
         {"", "{", "[]", R"({"day":"2026-11-24"})", R"({"day":"2026-11-24","pots":[{}]})",
          R"({"day":"2026-11-24","pots":[{"pot":"a","glaze":1,"outside":[[-1,0],[1e9,1]],"inside":[]}]})",
          R"({"format":77777777777777777777777777,"day":"2026-11-24","pots":[]})",
          R"({"day":"2026-11-24","pots":[{"pot":"a","glaze":3e99,"outside":[],"inside":[]}]})",
          R"({"day":"2026-11-24","pots":[{"pot":"a","glaze":"b","outside":[],"inside":[]}]})"}) {
        std::ofstream(file_) << damage;
        const auto opened = wall_.open(kToday);
        ASSERT_FALSE(opened) << damage;
        EXPECT_NE(opened.error().message.find("wall.json: expected the pots of a wall"), std::string::npos);
        EXPECT_TRUE(wall_.pots().empty());
    }
    ASSERT_TRUE(wall_.put(pot_called("new"), kToday));
    EXPECT_TRUE(wall_.open(kToday));
    EXPECT_EQ(wall_.pots().size(), 1U);
}

TEST_F(WallTest, ShowsAPotThatTheDiskCannotStore) {
    std::ofstream(folder_.path() / "state") << "a file where the folder should be";
    EXPECT_FALSE(wall_.put(pot_called("new"), kToday));
    EXPECT_EQ(wall_.pots().size(), 1U);
}

}  // namespace
}  // namespace onggi::app
