// Through the whole moon jar at the whole kiosk: two bowls by the pointer, joined, smoothed, decorated and
// kept, and what is kept is worked out again from its three sessions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "engine/files/atomic_file.h"
#include "game/app/command_line/performance.h"
#include "game/app/command_line/start_pot.h"
#include "game/app/kiosk/exhibits.h"
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

// ONGGI_LOOK=FOLDER: pictures of every step, large enough to be looked at.
UnseenOptions options() {
    if (std::getenv("ONGGI_LOOK") == nullptr) return {};
    return {.plain = false, .width = 1280, .height = 720};
}

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
        look("1-start");
        ASSERT_TRUE(kiosk.press(Button::kBegin));
        ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kThrow; }, kSlowly));
        ASSERT_EQ(step(), JarStep::kFirstBowl);
    }
    [[nodiscard]] JarStep step() const { return kiosk.state().throwing.jar.step; }
    // Opens the clay and draws it up along the dots, again until it is a bowl.
    void throw_bowl() {
        constexpr int kTries = 12;
        const std::vector<vec2> outline = jar_of(*target).bowl_mm;
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
    void look(const std::string& name) {
        const char* const into = std::getenv("ONGGI_LOOK");
        if (into == nullptr) return;
        for (int i = 0; i < 120; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            kiosk.frame(0.01);
        }
        const auto png = asset::encode_png(kiosk.picture());
        ASSERT_TRUE(png);
        ASSERT_TRUE(files::write_file_atomically(fs::path(into) / (name + ".png"), *png));
    }

    const test::TemporaryFolder folder;
    UnseenKiosk kiosk{folder.path(), options()};
    const heritage::Target* target = nullptr;
    std::mt19937 chance{7};
};

TEST_F(MoonJar, IsThrownJoinedDecoratedAndKept) {
    throw_bowl();
    look("2-bowl");
    end_bowl(JarStep::kAside);
    look("3-aside");
    ASSERT_TRUE(kiosk.press(Button::kDone));
    throw_bowl();
    look("4-second");
    end_bowl(JarStep::kJoin);
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kJoin; }, kSlowly));
    for (int mm = 0; mm < 3; ++mm)
        ASSERT_TRUE(kiosk.press(Button::kHandRight));
    EXPECT_EQ(kiosk.state().throwing.jar.shift_mm, 3);
    look("5-join");
    ASSERT_TRUE(kiosk.press(Button::kJoinBowls));
    ASSERT_TRUE(kiosk.until([&] { return step() == JarStep::kSeam; }, kSlowly));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.snapshot().pot->height_mm > 140.0; }, kSlowly));
    look("6-seam");
    EXPECT_EQ(kiosk.state().throwing.held, kiosk::Held::kRib);
    const double middle_mm = 0.5 * kiosk.snapshot().pot->height_mm;
    kiosk.stroke({{95.0, middle_mm - 8.0}, {84.0, middle_mm}, {84.0, middle_mm + 8.0}}, 2.0, chance);
    look("7-smoothed");
    ASSERT_TRUE(kiosk.press(Button::kDone));
    ASSERT_TRUE(kiosk.fires_it(true));
    ASSERT_TRUE(kiosk.press(Button::kGlaze, 1));
    ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kYourPot; }, kSlowly));
    look("8-your-pot");
    ASSERT_TRUE(kiosk.press(Button::kKeep));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; },
                            kSlowly));
    look("9-kept");
}

}  // namespace
}  // namespace onggi::app
