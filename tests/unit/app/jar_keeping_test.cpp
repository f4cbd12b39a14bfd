// An unfinished jar's files: damaged, partly written, abandoned.
#include "game/app/kiosk/gallery/jar_keeping.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

haptic::HapticParameters parameters() {
    haptic::HapticParameters all;
    all.set_rate_hz(500.0);
    return all;
}

haptic::HapticState bowl(double outer_mm) {
    clay::StudioClay clay = *test::studio_start().studio();
    clay.set_wall(outer_mm, 6.0, 10.0, 60.0, 400);
    return haptic::HapticState(std::move(clay));
}

haptic::History history_of(const haptic::HapticState& state) {
    haptic::History history(state, parameters());
    for (int tick = 0; tick < 40; ++tick)
        history.add_played({.position_mm = {0.0, 300.0, 0.0}});
    return history;
}

JarKeeping jar_in(const fs::path& folder) {
    return JarKeeping(folder, bowl(50.0), parameters());
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

struct JarKeepingTest : testing::Test {
    // Reads the files as at a start, and collects the messages.
    JarKeeping found() {
        JarKeeping jar = jar_in(folder.path());
        remarks.clear();
        EXPECT_TRUE(jar.look(remarks));
        return jar;
    }
    // A jar whose first bowl is set aside.
    JarKeeping begun() {
        JarKeeping jar = jar_in(folder.path());
        EXPECT_TRUE(jar.begin("moon-jar-nmk"));
        EXPECT_TRUE(jar.set_aside(history_of(bowl(50.0))));
        return jar;
    }

    const test::TemporaryFolder folder;
    std::vector<std::string> remarks;
};

TEST_F(JarKeepingTest, DropsDamagedFilesWithOneLine) {
    for (const std::string text : {"", "{", "[]", R"({"format":1})",
                                   R"({"format":2,"stage":1,"target":"x","shift_mm":[0,0],"mouth_mm":0})",
                                   R"({"format":1,"stage":3e99,"target":"x","shift_mm":[0,0],"mouth_mm":0})",
                                   R"({"format":1,"stage":7,"target":"x","shift_mm":[0,0],"mouth_mm":0})",
                                   R"({"format":1,"stage":1,"target":"x","shift_mm":[0],"mouth_mm":0})",
                                   R"({"format":1,"stage":1,"target":4,"shift_mm":[0,0],"mouth_mm":0})"}) {
        write(folder / "jar.json", text);
        const JarKeeping jar = found();
        ASSERT_EQ(remarks.size(), 1U) << text;
        EXPECT_EQ(remarks[0].find('\n'), std::string::npos);
        EXPECT_NE(remarks[0].find("jar.json"), std::string::npos) << remarks[0];
        EXPECT_EQ(jar.stage(), JarStage::kNone);
        EXPECT_FALSE(fs::exists(folder / "jar.json"));
    }
}

TEST_F(JarKeepingTest, IsRestoredWithBothBowlsToTheBit) {
    JarKeeping jar = begun();
    haptic::History second = history_of(bowl(50.0));
    ASSERT_TRUE(jar.note(JarStage::kSecondBowl));
    const auto joined = jar.join(second, {.shift_mm = {2.0, 1.0}, .mouth_mm = 0.0});
    ASSERT_TRUE(joined) << joined.error().message;
    ASSERT_TRUE(jar.note(JarStage::kJar));

    JarKeeping again = found();
    int rounds = 0;
    for (auto more = again.restore(7); more && *more; more = again.restore(7))
        ++rounds;
    EXPECT_GT(rounds, 5) << "a few ticks at a time";
    EXPECT_TRUE(remarks.empty());
    EXPECT_EQ(again.stage(), JarStage::kJar);
    EXPECT_EQ(again.sessions().size(), 2U);
    EXPECT_EQ(again.start().hash(), joined->state().hash());
    const auto left = again.left_over();
    ASSERT_TRUE(left && *left) << "nothing was done to the jar yet";
    EXPECT_EQ((*left)->history().state().hash(), joined->state().hash());
}

TEST_F(JarKeepingTest, IsForgottenWithOneErrorWhereABowlCannotBeRead) {
    ASSERT_TRUE(begun().note(JarStage::kSecondBowl));
    write(folder / "jar-1.onggi", "no session");
    JarKeeping jar = found();
    const auto more = jar.restore(100);
    ASSERT_FALSE(more);
    EXPECT_NE(more.error().message.find("jar-1.onggi"), std::string::npos);
    EXPECT_EQ(jar.stage(), JarStage::kNone);
    EXPECT_FALSE(fs::exists(folder / "jar-1.onggi"));
}

TEST_F(JarKeepingTest, GoesOnWithTheBowlItHasWhereItsJournalIsGone) {
    begun();  // the power goes before it is noted that the bowl was set aside
    JarKeeping jar = found();
    EXPECT_EQ(jar.stage(), JarStage::kFirstBowl);
    const auto bowl = jar.left_over();
    ASSERT_TRUE(bowl && *bowl);
    while ((*bowl)->work(100).value()) {
    }
    EXPECT_EQ((*bowl)->history().ticks(), 40U);
}

TEST_F(JarKeepingTest, GivesBackTheBowlThatWasDoneLast) {
    JarKeeping jar = jar_in(folder.path());
    EXPECT_EQ(jar.to_take_back(false), nullptr);
    ASSERT_TRUE(jar.set_aside(history_of(bowl(50.0))));
    haptic::History second = history_of(bowl(51.0));
    const std::uint64_t second_hash = second.state().hash();
    EXPECT_EQ(jar.to_take_back(true), nullptr) << "there is no second one yet";
    ASSERT_TRUE(jar.join(second, {}));
    EXPECT_EQ(jar.to_take_back(false), nullptr) << "not while it is part of a jar";
    ASSERT_NE(jar.to_take_back(true), nullptr);
    EXPECT_EQ(jar.take_back().state().hash(), second_hash);
    EXPECT_TRUE(jar.sessions().empty());
    ASSERT_NE(jar.to_take_back(false), nullptr);
    EXPECT_EQ(jar.take_back().ticks(), 40U);
    EXPECT_FALSE(jar.has_bowl());
}

TEST_F(JarKeepingTest, LeavesNoFileWhenForgotten) {
    JarKeeping jar = begun();
    haptic::History second = history_of(bowl(50.0));
    ASSERT_TRUE(jar.join(second, {}));
    jar.forget();
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST_F(JarKeepingTest, ReportsRimsThatDoNotMeetWithoutAChange) {
    JarKeeping jar = jar_in(folder.path());
    ASSERT_TRUE(jar.set_aside(history_of(bowl(50.0))));
    haptic::History second = history_of(bowl(70.0));
    EXPECT_FALSE(jar.rims_mm(*second.state().studio(), 0.0));
    EXPECT_FALSE(jar.join(second, {}));
    EXPECT_EQ(second.ticks(), 40U);
    const auto near_mm = jar.rims_mm(*bowl(53.0).studio(), 0.0);
    ASSERT_TRUE(near_mm);
    EXPECT_NEAR(*near_mm, 3.0, 1e-9);
}

}  // namespace
}  // namespace onggi::app
