// Makes a moon jar at the whole kiosk: two bowls by the pointer, joined, smoothed, decorated and kept; the
// kept jar is recomputed from its three sessions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "engine/files/read_file.h"
#include "game/app/command_line/performance.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/clay/studio/joining.h"
#include "game/heritage/jar.h"
#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using kiosk::Button;
using kiosk::JarStep;
using kiosk::Screen;

class MoonJar : public testing::Test {
  protected:
    void SetUp() override {
        const auto& places = kiosk.settings().exhibit_places;
        const auto& targets = kiosk.settings().targets;
        const auto place = std::find_if(places.begin(), places.end(),
                                        [&](std::size_t row) { return targets[row].id == "moon-jar-nmk"; });
        ASSERT_NE(place, places.end());
        target = &targets[*place];
        const int value = static_cast<int>(place - places.begin());
        kiosk.touch();
        ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kChoose; }));
        ASSERT_TRUE(kiosk.press(Button::kShelfNext, 4));
        ASSERT_TRUE(kiosk.press(Button::kTarget, value));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kJarStart; }, kSlowly));
        kiosk.look("1-start");
        ASSERT_TRUE(kiosk.press(Button::kBegin));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kThrow; }, kSlowly));
        ASSERT_EQ(step(), JarStep::kFirstBowl);
    }
    [[nodiscard]] JarStep step() const { return kiosk.state().throwing.jar.step; }
    // Opens the clay and pulls it up along the dots, repeating until it is a bowl.
    void throw_bowl() {
        constexpr int kTries = 12;
        const std::vector<vec2> outline = heritage::jar_of(*target).bowl_mm;
        const std::vector<dvec2> way(outline.begin(), outline.end());
        const auto top_mm = [&] { return kiosk.snapshot().pot->height_mm; };
        const auto depth_mm = [&] { return top_mm() - kiosk.snapshot().pot->floor_mm; };
        for (int tries = 0; tries < kTries && depth_mm() < 25.0; ++tries)
            kiosk.stroke({{0.0, top_mm() + 1.0}, {0.0, top_mm() - 38.0}}, 1.3, chance);
        for (int tries = 0; tries < kTries; ++tries) {
            if (tries > 2 && kiosk.state().throwing.jar.is_bowl) break;
            kiosk.stroke(way, 3.0, chance);
        }
        ASSERT_TRUE(kiosk.state().throwing.jar.is_bowl) << top_mm() << " mm high";
    }
    void end_bowl(JarStep then) {
        ASSERT_TRUE(kiosk.press(Button::kDone));
        ASSERT_TRUE(kiosk.until([&] { return step() == then; }, kSlowly));
    }
    [[nodiscard]] fs::path state_folder() const { return app::state_folder(folder.path()); }
    void expect_bowl(double height_mm) {
        ASSERT_TRUE(kiosk.until([&] { return kiosk.state().throwing.jar.is_bowl; }, kSlowly));
        EXPECT_TRUE(kiosk.until([&] { return std::fabs(kiosk.snapshot().pot->height_mm - height_mm) < 0.5; },
                                kSlowly))
            << kiosk.snapshot().pot->height_mm << " mm high instead of " << height_mm;
    }
    // Checks that the kept jar's session starts with its two joined bowls, and replays to the end.
    void expect_made_of_its_bowls(const nlohmann::json& note) {
        const auto pots = kept_pots(folder.path());
        ASSERT_FALSE(pots.empty());
        const fs::path& kept = pots.front().folder;
        const auto first = start_pot({.on = (kept / "bowl-1.onggi").string()});
        ASSERT_TRUE(first) << first.error().message;
        const auto second = start_pot({.on = (kept / "bowl-2.onggi").string()});
        ASSERT_TRUE(second) << second.error().message;
        const auto joined = clay::join_pots(
            **second, **first,
            {.bore_mm = clay::bore_at_width_mm(**first, note.at("mouth_mm").get<double>()),
             .shift_mm = {note.at("shift_mm").at(0).get<double>(), note.at("shift_mm").at(1).get<double>()}});
        ASSERT_TRUE(joined) << joined.error().message;
        const auto session = load_session((kept / "pot.onggi").string());
        ASSERT_TRUE(session) << session.error().message;
        EXPECT_EQ(session->start.state.studio()->state_hash(), joined->state_hash()) << "to the bit";
        const auto jar = start_pot({.on = (kept / "pot.onggi").string()});
        ASSERT_TRUE(jar) << jar.error().message;
        EXPECT_EQ((*jar)->ledger_error_mm3(), 0.0);
        EXPECT_NEAR(heritage::off_round_mm(**jar), 3.0, 1.5) << "set on 3 mm to the side";
        EXPECT_NEAR((*jar)->lump().mass_g, 2.0 * clay::StudioLump{}.mass_g, 1e-9);
    }

    const test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), looked_at()};
    const heritage::Target* target = nullptr;
    std::mt19937 chance{7};
};

// The disk after a power cut at this moment, at another kiosk: it offers the jar and resumes it.
struct AfterPowerCut {
    explicit AfterPowerCut(const fs::path& gallery) {
        fs::copy(gallery, folder.path(), fs::copy_options::recursive);
        kiosk = std::make_unique<UnseenKiosk>(folder.path());
    }
    void expect_goes_on(JarStep step, double height_mm) {
        ASSERT_TRUE(kiosk->until([&] { return kiosk->state().interrupted_session; }, kSlowly));
        kiosk->touch();
        ASSERT_TRUE(kiosk->until([&] { return kiosk->shown_screen() == Screen::kResume; }, kSlowly));
        ASSERT_TRUE(kiosk->press(Button::kResumeGo));
        EXPECT_EQ(kiosk->state().throwing.jar.step, step);
        // The last block of the journal may be missing.
        constexpr double kMostLostMm = 12.0;
        EXPECT_TRUE(kiosk->until(
            [&] { return std::fabs(kiosk->snapshot().pot->height_mm - height_mm) < kMostLostMm; }, kSlowly))
            << kiosk->snapshot().pot->height_mm << " mm high instead of " << height_mm;
        const bool has_bowl = step == JarStep::kSecondBowl;
        EXPECT_TRUE(kiosk->until(
            [&] {
                const auto view = kiosk->shown_view();
                return view && view->state.screen == Screen::kThrow && (view->aside != nullptr) == has_bowl;
            },
            kSlowly));
    }

    test::TemporaryFolder folder;
    std::unique_ptr<UnseenKiosk> kiosk;
};

TEST_F(MoonJar, IsThrownJoinedDecoratedAndKept) {
    throw_bowl();
    kiosk.look("2-bowl");
    const double first_mm = kiosk.snapshot().pot->height_mm;
    ASSERT_TRUE(kiosk.journal_catches_up());
    AfterPowerCut(folder.path()).expect_goes_on(JarStep::kFirstBowl, first_mm);
    end_bowl(JarStep::kAside);
    kiosk.look("3-aside");
    ASSERT_TRUE(kiosk.press(Button::kDone));
    throw_bowl();
    kiosk.look("4-second");
    const double second_mm = kiosk.snapshot().pot->height_mm;
    ASSERT_TRUE(kiosk.journal_catches_up());
    AfterPowerCut(folder.path()).expect_goes_on(JarStep::kSecondBowl, second_mm);
    end_bowl(JarStep::kJoin);
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kJoin; }, kSlowly));
    for (int mm = 0; mm < 3; ++mm)
        ASSERT_TRUE(kiosk.press(Button::kHandRight));
    EXPECT_EQ(kiosk.state().throwing.jar.shift_mm, 3);
    kiosk.look("5-join");
    ASSERT_TRUE(kiosk.press(Button::kJoinBowls));
    ASSERT_TRUE(kiosk.until([&] { return step() == JarStep::kSeam; }, kSlowly));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.snapshot().pot->height_mm > 140.0; }, kSlowly));
    kiosk.look("6-seam");
    EXPECT_EQ(kiosk.state().throwing.held, tool::Tool::kRib);
    const double middle_mm = 0.5 * kiosk.snapshot().pot->height_mm;
    kiosk.stroke({{95.0, middle_mm - 8.0}, {84.0, middle_mm}, {84.0, middle_mm + 8.0}}, 2.0, chance);
    kiosk.look("7-smoothed");
    const double jar_mm = kiosk.snapshot().pot->height_mm;
    ASSERT_TRUE(kiosk.journal_catches_up());
    AfterPowerCut(folder.path()).expect_goes_on(JarStep::kSeam, jar_mm);
    const auto note = files::read_file(state_folder() / "jar.json", 4096);
    ASSERT_TRUE(note) << note.error().message;
    ASSERT_TRUE(kiosk.press(Button::kDone));
    ASSERT_TRUE(kiosk.fires_it(true));
    ASSERT_TRUE(kiosk.press(Button::kGlaze, 1));
    ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kYourPot; }, kSlowly));
    kiosk.look("8-your-pot");
    ASSERT_TRUE(kiosk.press(Button::kKeep));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; },
                            kSlowly));
    kiosk.look("9-kept");
    expect_made_of_its_bowls(nlohmann::json::parse(*note));
    EXPECT_FALSE(fs::exists(state_folder() / "jar.json")) << "it is on the shelf";
    EXPECT_FALSE(fs::exists(state_folder() / "jar-1.onggi"));
}

TEST_F(MoonJar, IsTakenBackAcrossItsSteps) {
    throw_bowl();
    const double first_mm = kiosk.snapshot().pot->height_mm;
    end_bowl(JarStep::kAside);
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    EXPECT_EQ(step(), JarStep::kFirstBowl);
    expect_bowl(first_mm);
    end_bowl(JarStep::kAside);
    ASSERT_TRUE(kiosk.press(Button::kDone));
    throw_bowl();
    const double second_mm = kiosk.snapshot().pot->height_mm;
    end_bowl(JarStep::kJoin);
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    EXPECT_EQ(step(), JarStep::kSecondBowl);
    expect_bowl(second_mm);
    end_bowl(JarStep::kJoin);
    ASSERT_TRUE(kiosk.press(Button::kJoinBowls));
    ASSERT_TRUE(kiosk.until([&] { return step() == JarStep::kSeam; }, kSlowly));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.snapshot().pot->height_mm > 140.0; }, kSlowly));
    // Nothing was done to the jar yet: undo separates its bowls.
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    ASSERT_TRUE(kiosk.until([&] { return step() == JarStep::kSecondBowl; }, kSlowly));
    expect_bowl(second_mm);
    // And the second bowl's moves can be undone as before the joining.
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    ASSERT_TRUE(
        kiosk.until([&] { return std::fabs(kiosk.snapshot().pot->height_mm - second_mm) > 0.01; }, kSlowly));
    // New clay replaces the second bowl; the first one stays.
    ASSERT_TRUE(kiosk.press(Button::kNewClay));
    EXPECT_EQ(step(), JarStep::kSecondBowl);
    ASSERT_TRUE(kiosk.until([&] { return kiosk.snapshot().pot->height_mm < 60.0; }, kSlowly));
    EXPECT_FALSE(kiosk.state().throwing.jar.is_bowl);
    throw_bowl();
    end_bowl(JarStep::kJoin);
}

}  // namespace
}  // namespace onggi::app
