// Simulated visitors decorate a pot: their strokes appear where they drew them, in the picture and in the
// kept files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "game/app/command_line/performance.h"
#include "game/app/replay/replay.h"
#include "game/app/replay/session_marks.h"
#include "game/haptic/pot_copy.h"
#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using kiosk::Button;
using kiosk::Screen;

constexpr double kMostOffMm = 2.0;

class Decorators : public testing::Test {
  protected:
    void SetUp() override {
        std::mt19937 chance(24);
        ASSERT_TRUE(kiosk.begins_to_throw());
        ASSERT_TRUE(kiosk.throw_a_pot(chance));
        ASSERT_TRUE(kiosk.ends_throwing());
        ASSERT_TRUE(kiosk.dries());
        ASSERT_TRUE(kiosk.press(Button::kTurning));  // it rests
        const pot::Pot& wet = *kiosk.snapshot().pot;
        const double scale = clay::shrunk_scale(wet.body, clay::Firing::kDry);
        radius_mm_ = scale * double{wet.outer_mm[wet.outer_mm.size() / 2]};
        height_mm_ = scale * wet.height_mm;
        px_per_mm_ = (at(1.0, 0.0).x - at(-1.0, 0.0).x) / (2.0 * radius_mm_);
    }
    // A pixel on the visible half of the wall: across from its middle, 1 is its side; up from its middle, 0.5
    // is its rim.
    [[nodiscard]] dvec2 at(double across, double up) const {
        const double beside_mm = across * radius_mm_;
        const auto px = kiosk.seen(
            {beside_mm, (0.5 + up) * height_mm_, std::sqrt(radius_mm_ * radius_mm_ - beside_mm * beside_mm)});
        EXPECT_TRUE(px);
        return px.value_or(dvec2(0.0));
    }
    // A kiosk on a copy of the disk offers the pot to the next visitor.
    static bool offers_to_resume(UnseenKiosk& again) {
        if (!again.until([&] { return again.state().interrupted_session; }, kSlowly)) return false;
        again.touch();
        return again.until([&] { return again.shown_screen() == Screen::kResume; }, kSlowly);
    }
    // The picture, with the pointer on the ledge.
    asset::Image still() {
        EXPECT_TRUE(kiosk.point_at(Button::kUndo));
        for (int i = 0; i < 30; ++i)
            kiosk.frame();
        return kiosk.picture();
    }
    void draw(const std::vector<dvec2>& way) {
        kiosk.point(way.front().x, way.front().y);
        kiosk.frame();
        kiosk.hold(true);
        kiosk.frame();
        for (const dvec2& px : way) {
            kiosk.point(px.x, px.y);
            kiosk.frame();
        }
        kiosk.hold(false);
        kiosk.frame();
    }
    // The pixels of the pot that have changed.
    [[nodiscard]] std::vector<dvec2> changed(const asset::Image& before, const asset::Image& after) const {
        constexpr int kLevels = 24;
        std::vector<dvec2> found;
        const dvec2 low(at(-1.0, 0.0).x, at(-1.0, 0.5).y);
        const dvec2 high(at(1.0, 0.0).x, at(0.0, -0.5).y);
        for (int y = static_cast<int>(low.y); y < static_cast<int>(high.y); ++y) {
            for (int x = static_cast<int>(low.x); x < static_cast<int>(high.x); ++x) {
                const auto first = static_cast<std::size_t>(4 * (y * before.width + x));
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    if (std::abs(before.rgba[first + channel] - after.rgba[first + channel]) < kLevels)
                        continue;
                    found.push_back({x + 0.5, y + 0.5});
                    break;
                }
            }
        }
        return found;
    }
    static double nearest(const std::vector<dvec2>& places, const dvec2& to) {
        double least = 1e9;
        for (const dvec2& place : places)
            least = std::min(least, glm::length(place - to));
        return least;
    }
    // Checks that the whole path is drawn, and nothing farther from it than half the brush's width.
    void expect_drawn_along(const std::vector<dvec2>& way, double half_mm) {
        const asset::Image before = still();
        draw(way);
        const std::vector<dvec2> drawn = changed(before, still());
        ASSERT_FALSE(drawn.empty());
        double missed_px = 0.0;
        double beside_px = 0.0;
        for (const dvec2& px : way)
            missed_px = std::max(missed_px, nearest(drawn, px));
        for (const dvec2& px : drawn)
            beside_px = std::max(beside_px, nearest(way, px) - half_mm * px_per_mm_);
        std::printf("missed by %.2f mm, beside by %.2f mm, %.2f px a mm\n", missed_px / px_per_mm_,
                    beside_px / px_per_mm_, px_per_mm_);
        EXPECT_LT(missed_px / px_per_mm_, kMostOffMm);
        EXPECT_LT(beside_px / px_per_mm_, kMostOffMm);
    }
    static std::vector<dvec2> between(const std::vector<dvec2>& corners) {
        constexpr int kSteps = 24;
        std::vector<dvec2> way;
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
            for (int k = 0; k <= kSteps; ++k)
                way.push_back(glm::mix(corners[i], corners[i + 1], static_cast<double>(k) / kSteps));
        }
        return way;
    }
    // Keeps the pot and reads the session and its strokes' marks.
    void keep_and_read(decoration::Recorded& recorded, decoration::Marks& marks) {
        ASSERT_TRUE(kiosk.press(Button::kDone));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kGlaze; }, 0.1));
        ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
        ASSERT_TRUE(kiosk.press(Button::kKeep));
        ASSERT_TRUE(kiosk.until(
            [&] { return kiosk.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; }, 0.002));
        for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
            if (entry.path().filename() != "pot.onggi") continue;
            auto session = load_session(entry.path().string());
            ASSERT_TRUE(session) << session.error().message;
            recorded = session->decoration;
            Replay replay(session->session, std::move(session->start));
            while (!replay.is_over())
                ASSERT_FALSE(replay.step());
            marks = {wall_of(haptic::pot_of(replay.state())), recorded};
        }
        EXPECT_EQ(decoration::texture_of(marks).hash(), recorded.texture_hash);
    }

    const test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), {.width = 960, .height = 540}};
    double radius_mm_ = 0.0;  // of the dry pot, half way up
    double height_mm_ = 0.0;
    double px_per_mm_ = 1.0;
};

TEST_F(Decorators, DrawAWaveAndAScribbleOfIron) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 1));
    std::vector<dvec2> wave;
    for (int i = 0; i <= 60; ++i)
        wave.push_back(at(-0.6 + 0.02 * i, 0.1 + 0.1 * std::sin(0.3 * i)));
    expect_drawn_along(wave, 2.0);
    std::mt19937 chance(5);
    std::vector<dvec2> corners;
    for (int i = 0; i < 8; ++i) {
        const double height = -0.35 + 0.03 * static_cast<double>(chance() % 9);
        const double across = -0.5 + 0.125 * static_cast<double>(chance() % 9);
        corners.push_back(at(across, height));
    }
    expect_drawn_along(between(corners), 2.0);
    EXPECT_EQ(kiosk.state().decorating.strokes, 2);
}

TEST_F(Decorators, InlayALineAndTakeItBack) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, kiosk::kInlayTool));
    ASSERT_TRUE(kiosk.press(Button::kSlip, 1));
    const asset::Image blank = still();
    expect_drawn_along(between({at(-0.5, -0.2), at(0.4, 0.25)}), 1.0);
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    EXPECT_EQ(kiosk.state().decorating.strokes, 0);
    EXPECT_TRUE(changed(blank, still()).empty());
}

TEST_F(Decorators, BandAPotThatTurnsAndSetMotifsAllRoundIt) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 2));
    ASSERT_TRUE(kiosk.press(Button::kTurning));
    const dvec2 finger = at(0.0, 0.2);
    kiosk.point(finger.x, finger.y);
    kiosk.hold(true);
    for (int i = 0; i < 640; ++i)  // ten seconds and a little more
        kiosk.frame();
    kiosk.hold(false);
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, kiosk::kMotifTool));
    ASSERT_TRUE(kiosk.press(Button::kAllRound));
    const dvec2 place = at(0.0, -0.15);
    kiosk.point(place.x, place.y);
    kiosk.frame();
    kiosk.hold(true);
    kiosk.frame();
    kiosk.hold(false);
    kiosk.frame();
    decoration::Recorded recorded;
    decoration::Marks marks;
    keep_and_read(recorded, marks);
    ASSERT_EQ(recorded.strokes.size(), 2U);
    EXPECT_GE(recorded.strokes[1].repeats, 3);
    const auto height_of = [](const decoration::StrokePoint& point) {
        return point.height / decoration::kHeightUnitsPerMm;
    };
    // The band has one height all round, as far above the motifs as the fingers were.
    const double band_mm = height_of(recorded.strokes[0].points.front());
    for (const decoration::StrokePoint& point : recorded.strokes[0].points)
        ASSERT_NEAR(height_of(point), band_mm, kMostOffMm);
    const decoration::Texture texture = decoration::texture_of(marks);
    const int row = decoration::row_at(static_cast<float>(band_mm) / marks.wall.height_mm);
    for (int column = 0; column < decoration::kColumns; ++column)
        ASSERT_EQ(texture.at(column, row).pigment, decoration::Pigment::kCobalt) << column;
    EXPECT_NEAR(band_mm - height_of(recorded.strokes[1].points.front()), 0.35 * marks.wall.height_mm,
                0.05 * marks.wall.height_mm);
}

TEST_F(Decorators, SeeTheirStrokeUnderTheFingerInTheVeryFrame) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 1));
    asset::Image before = still();
    kiosk.point(at(-0.4, 0.0).x, at(-0.4, 0.0).y);
    kiosk.hold(true);
    kiosk.frame();
    for (int i = 1; i < 10; ++i) {
        const asset::Image last = kiosk.picture();
        const dvec2 px = at(-0.4 + 0.08 * i, 0.0);
        kiosk.point(px.x, px.y);
        kiosk.frame();
        ASSERT_LT(nearest(changed(last, kiosk.picture()), px), kMostOffMm * px_per_mm_) << i;
    }
    kiosk.hold(false);
    kiosk.frame();
}

TEST_F(Decorators, FindTheirStrokesAfterAPowerCut) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 1));
    draw(between({at(-0.5, 0.2), at(0.4, 0.2)}));
    draw(between({at(-0.5, 0.0), at(0.4, -0.1)}));
    ASSERT_TRUE(kiosk.until([&] { return fs::exists(folder.path() / "state" / "drawing"); }, kSlowly));
    ASSERT_TRUE(kiosk.journal_catches_up());
    const test::TemporaryFolder after;
    fs::copy(folder.path(), after.path(), fs::copy_options::recursive);
    UnseenKiosk again(after.path());
    ASSERT_TRUE(offers_to_resume(again));
    ASSERT_TRUE(again.press(Button::kResumeGo));
    ASSERT_TRUE(again.dries()) << "it was cut off already";
    ASSERT_TRUE(again.until([&] { return again.state().decorating.strokes == 2; }, kSlowly))
        << again.state().decorating.strokes << " strokes";
    // Discarding the pot discards its decoration.
    ASSERT_TRUE(kiosk.press(Button::kDone));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kGlaze; }, 0.1));
    ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
    ASSERT_TRUE(kiosk.press(Button::kKeep));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; },
                            kSlowly));
    EXPECT_FALSE(fs::exists(folder.path() / "state" / "drawing"));
}

// The program dies in the moment in which the visitor keeps the pot.
TEST_F(Decorators, FindDecorationAndGlazeAfterAPowerCutWhileThePotIsKept) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 1));
    draw(between({at(-0.5, 0.2), at(0.4, 0.2)}));
    ASSERT_TRUE(kiosk.press(Button::kDone));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kGlaze; }, 0.1));
    ASSERT_TRUE(kiosk.press(Button::kGlaze, 4));
    ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kYourPot; }, kSlowly));
    ASSERT_TRUE(kiosk.journal_catches_up());
    const std::shared_ptr<const screens::FiredPot> before = kiosk.shown_view()->pot;
    ASSERT_TRUE(before && before->shape.marks);
    const test::TemporaryFolder after;
    fs::copy(folder.path(), after.path(), fs::copy_options::recursive);
    UnseenKiosk again(after.path());
    ASSERT_TRUE(offers_to_resume(again));
    EXPECT_TRUE(again.shown_view()->left_over) << "the pot itself, and no lump";
    ASSERT_TRUE(again.press(Button::kResumeGo));
    ASSERT_TRUE(again.dries()) << "the throwing is over";
    ASSERT_TRUE(again.until([&] { return again.state().decorating.strokes == 1; }, kSlowly));
    ASSERT_TRUE(again.press(Button::kDone));
    ASSERT_TRUE(again.until([&] { return again.screen() == Screen::kGlaze; }, 0.1));
    EXPECT_EQ(again.state().glaze, 4);
    ASSERT_TRUE(again.press(Button::kTakeGlaze));
    ASSERT_TRUE(again.until([&] { return again.shown_screen() == Screen::kYourPot; }, kSlowly));
    const std::shared_ptr<const screens::FiredPot> found = again.shown_view()->pot;
    ASSERT_TRUE(found && found->shape.marks);
    EXPECT_EQ(found->shape.hash(), before->shape.hash()) << "outline and decoration";
    EXPECT_EQ(found->weight_g, before->weight_g);
    EXPECT_EQ(again.state().glaze, kiosk.state().glaze);
    ASSERT_TRUE(again.press(Button::kKeep));
    ASSERT_TRUE(again.until([&] { return again.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; },
                            kSlowly));
    EXPECT_FALSE(fs::exists(after.path() / "state" / "place.json"));
}

TEST_F(Decorators, TakeTheGlazeOffAndDrawOn) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 1));
    draw(between({at(-0.5, 0.2), at(0.4, 0.2)}));
    ASSERT_TRUE(kiosk.press(Button::kDone));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kGlaze; }, 0.1));
    ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
    ASSERT_TRUE(kiosk.press(Button::kOtherGlaze));
    ASSERT_TRUE(kiosk.press(Button::kDecorateAgain));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kDecorate; }, 0.1));
    EXPECT_EQ(kiosk.state().decorating.strokes, 1);
    ASSERT_TRUE(kiosk.press(Button::kTurning));
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 1));
    draw(between({at(-0.4, -0.2), at(0.4, -0.2)}));
    draw(between({at(-0.4, -0.3), at(0.4, -0.3)}));
    ASSERT_TRUE(kiosk.press(Button::kUndo));
    decoration::Recorded recorded;
    decoration::Marks marks;
    keep_and_read(recorded, marks);
    EXPECT_EQ(recorded.strokes.size(), 2U);
}

TEST_F(Decorators, DrawByKeysAlone) {
    ASSERT_TRUE(kiosk.press(Button::kDrawingTool, 1));
    const auto key = [&](window::Key which) { kiosk.press_key(which); };
    key(window::Key::kUp);
    key(window::Key::kEnter);
    for (int i = 0; i < 5; ++i)
        key(window::Key::kRight);
    key(window::Key::kEnter);
    key(window::Key::kRight);
    EXPECT_EQ(kiosk.state().decorating.strokes, 1);
    EXPECT_FALSE(kiosk.state().decorating.brush_down);
    decoration::Recorded recorded;
    decoration::Marks marks;
    keep_and_read(recorded, marks);
    ASSERT_EQ(recorded.strokes.size(), 1U);
    const auto& points = recorded.strokes[0].points;
    ASSERT_EQ(points.size(), 6U);
    const auto on = static_cast<std::uint16_t>(points.back().turn - points.front().turn);
    EXPECT_NEAR(on / decoration::kTurnUnits * double{marks.wall.round_mm[decoration::kRows / 2]}, 20.0, 4.0);
}

}  // namespace
}  // namespace onggi::app
