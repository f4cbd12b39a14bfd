// A visitor trims the foot at the whole kiosk: the removed clay is gone from the pot, its files and its
// weight, and the session replays it.
#include <gtest/gtest.h>

#include "game/app/command_line/performance.h"
#include "game/app/kiosk/finger/kiosk_touch.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/clay/studio/studio_clay.h"
#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using kiosk::Button;
using kiosk::Screen;

class Trimming : public testing::Test {
  protected:
    void SetUp() override {
        std::mt19937 thrower(24);
        ASSERT_TRUE(kiosk.begins_to_throw());
        ASSERT_TRUE(kiosk.throw_a_pot(thrower));
        ASSERT_TRUE(kiosk.ends_throwing());
        ASSERT_TRUE(kiosk.until([&] { return kiosk.state().trimming.is_offered; }, kSlowly));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kTrim; }, 0.1));
    }
    // A finger that presses beside the foot, which is on top now, and moves in by in_mm.
    void shave(double from_top_mm, double in_mm) {
        const pot::Pot& pot = *kiosk.snapshot().pot;
        const double y_mm = pot.height_mm - from_top_mm;
        const double x_mm = wall_at(pot, from_top_mm).outer_mm;
        kiosk.stroke({{x_mm + 1.0, y_mm}, {x_mm - in_mm, y_mm}, {x_mm - in_mm, y_mm}}, 1.5, chance);
    }
    // Takes pictures of the trimmer at that depth in the wall.
    void look_at_work(double from_top_mm, double in_mm) {
        const pot::Pot& pot = *kiosk.snapshot().pot;
        const auto px =
            kiosk.seen({wall_at(pot, from_top_mm).outer_mm - in_mm, pot.height_mm - from_top_mm, 0.0});
        ASSERT_TRUE(px);
        kiosk.point(px->x, px->y);
        kiosk.hold(true);
        for (const char* name : {"trim-shaving-1", "trim-shaving-2", "trim-shaving-3"})
            kiosk.look(name, 0.3);
        kiosk.hold(false);
        kiosk.passes(0.1);  // a slow wheel cuts until it learns of the release
    }
    [[nodiscard]] double on_wheel_g() {
        return kiosk.snapshot().on_wheel_mm3 * clay::studio::kDensityGPerMm3;
    }
    void keep() {
        ASSERT_TRUE(kiosk.press(Button::kDone));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kDecorate; }, kSlowly));
        ASSERT_TRUE(kiosk.press(Button::kDone));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kGlaze; }, 0.1));
        ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
        ASSERT_TRUE(kiosk.press(Button::kKeep));
        ASSERT_TRUE(kiosk.until(
            [&] { return kiosk.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; }, kSlowly));
    }
    [[nodiscard]] std::string session() const {
        return (kept_pots(folder.path()).at(0).folder / "pot.onggi").string();
    }

    const test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), looked_at()};
    std::mt19937 chance{3};
};

TEST_F(Trimming, RemovesTheShownMassFromTheKeptPot) {
    kiosk.look("trim-1");
    const double before_g = on_wheel_g();
    const double before_mm = wall_at(*kiosk.snapshot().pot, 6.0).outer_mm;
    shave(6.0, 5.0);
    shave(14.0, 4.0);
    kiosk.look("trim-2");
    look_at_work(10.0, 6.0);
    const int taken_g = kiosk.state().trimming.taken_g;
    EXPECT_GT(taken_g, 5);
    EXPECT_NEAR(before_g - on_wheel_g(), taken_g, 0.51);
    EXPECT_LT(wall_at(*kiosk.snapshot().pot, 6.0).outer_mm, before_mm - 2.0);
    keep();
    const auto pot = start_pot({.on = session()});
    ASSERT_TRUE(pot) << pot.error().message;
    EXPECT_EQ((*pot)->ledger_error_mm3(), 0.0);
    EXPECT_NEAR((*pot)->volume_mm3() * clay::studio::kDensityGPerMm3, before_g - taken_g, 0.51);
    EXPECT_TRUE((*pot)->is_leather_hard());
    const auto view = kiosk.shown_view();
    ASSERT_TRUE(view && view->pot);
    const auto measures = clay::measure_pot((*pot)->rings(), (*pot)->lump().body, clay::Firing::kGlaze);
    EXPECT_NEAR(view->pot->weight_g, measures.mass_g, 0.5) << "the displayed weight equals the kept one";
}

TEST_F(Trimming, NeverCutsThroughHoweverHardAVisitorPresses) {
    for (const double from_top_mm : {4.0, 10.0, 16.0, 24.0, 34.0})
        shave(from_top_mm, 60.0);
    keep();
    const auto pot = start_pot({.on = session()});
    ASSERT_TRUE(pot) << pot.error().message;
    const clay::studio::Rings& rings = (*pot)->rings();
    for (int i = rings.first_hollow; i < rings.count; ++i)
        EXPECT_GE(rings.wall_mm(i), clay::studio::kTrimmedWallMm - 1e-6) << "at " << rings.centre_mm(i);
    EXPECT_EQ((*pot)->failure().cause, clay::studio::Cause::kNone);
}

TEST_F(Trimming, CanBeUndoneButNotTheThrowing) {
    const double before_g = on_wheel_g();
    shave(8.0, 5.0);
    ASSERT_GT(kiosk.state().trimming.taken_g, 2);
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.state().trimming.taken_g == 0; }, kSlowly));
    EXPECT_NEAR(on_wheel_g(), before_g, 1e-6);
    const double height_mm = kiosk.snapshot().pot->height_mm;
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    for (int i = 0; i < 60; ++i)
        kiosk.frame(kSlowly);
    EXPECT_NEAR(kiosk.snapshot().pot->height_mm, height_mm, 1e-6) << "the throwing is over";
}

TEST_F(Trimming, IsDoneByKeysToo) {
    const double before_g = on_wheel_g();
    for (int i = 0; i < 6; ++i) {
        kiosk.press_key(window::Key::kLeft);
        kiosk.passes(0.6);
    }
    EXPECT_LT(on_wheel_g(), before_g - 1.0);
    EXPECT_GT(kiosk.state().trimming.taken_g, 0);
}

}  // namespace
}  // namespace onggi::app
