// What a visitor by ear is told, frame by frame on a virtual clock.
#include "game/app/kiosk/visit/narrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

namespace onggi::app {
namespace {

using kiosk::Button;
using kiosk::Screen;

class NarratorTest : public testing::Test {
  protected:
    NarratorTest() {
        view.languages = std::make_shared<const std::vector<kiosk::Language>>(kiosk::built_in_languages());
        view.exhibits = std::make_shared<const std::vector<screens::Exhibit>>();
        pot.height_mm = 60.0;
        pot.floor_mm = 60.0;
        pot.outer_mm.assign(60, 60.0F);
        pot.inner_mm.assign(60, 0.0F);
        snapshot.pot = &pot;
    }
    // The texts of the lines that are due; an urgent one begins with "! ".
    std::vector<std::string> hears(double after_s = 0.1) {
        now_s += after_s;
        screens::Composed shown{std::make_shared<const screens::View>(view), {}};
        shown.composition.targets = targets;
        shown.composition.told = told;
        std::vector<std::string> texts;
        for (const SaidLine& line : narrator.look({.shown = shown,
                                    .focus = focus,
                                    .marker = marker,
                                    .device_is_at_buttons = device_is_at_buttons,
                                    .guard = guard,
                                    .snapshot = snapshot,
                                    .now_s = now_s,
                                    .is_quiet = is_quiet,
                                    .is_private = is_private,
                                    .has_device = has_device,
                                    .asks_where = asks_where}))
            texts.push_back((line.is_urgent ? "! " : "") + line.text);
        return texts;
    }
    void open_to(double wall_mm) {
        pot.floor_mm = 10.0;
        pot.inner_mm.assign(60, static_cast<float>(60.0 - wall_mm));
        std::fill_n(pot.inner_mm.begin(), 4, 0.0F);  // below the floor
    }

    screens::View view;
    std::vector<screens::Target> targets;
    std::vector<std::string> told;
    pot::Pot pot;
    haptic::Snapshot snapshot;
    int focus = -1;
    MarkerPlace marker = MarkerPlace::kNone;
    screens::CueGuard guard = screens::CueGuard::kNone;
    bool is_quiet = true;
    bool is_private = false;
    bool has_device = false;
    std::optional<bool> device_is_at_buttons;
    bool asks_where = false;
    double now_s = 100.0;
    Narrator narrator;
};

using Lines = std::vector<std::string>;

TEST_F(NarratorTest, SaysAScreenOnceAndHowToWorkItByKeysTheFirstTime) {
    view.state.screen = Screen::kChoose;
    const Lines first = hears();
    ASSERT_EQ(first.size(), 2U);
    EXPECT_TRUE(first[0].starts_with("! What will you make?")) << first[0];
    EXPECT_NE(first[1].find("W says where you are"), std::string::npos);
    EXPECT_EQ(hears(), Lines{});
    view.state.comfort.language = 1;
    EXPECT_EQ(hears().size(), 1U) << "in the other language";
}

TEST_F(NarratorTest, NamesAButtonWithItsPlaceWhenTheFocusComesAndItsSettingWhenItChanges) {
    view.state.screen = Screen::kGlaze;
    targets = {{.button = Button::kGlaze, .name = "Ash", .spoken = "Wood ash glaze"},
               {.button = Button::kTakeGlaze, .name = "This one", .spoken = "Use this glaze."}};
    EXPECT_EQ(hears().size(), 1U);
    focus = 0;
    EXPECT_EQ(hears(), Lines{"! Wood ash glaze, 1 of 2"});
    EXPECT_EQ(hears(), Lines{});
    targets[0].spoken += ", chosen";
    EXPECT_EQ(hears(), Lines{"! Wood ash glaze, chosen, 1 of 2"}) << "what has come of the press";
    focus = 1;
    EXPECT_EQ(hears(), Lines{"! Use this glaze. 2 of 2"});
    view.state.screen = Screen::kYourPot;
    const Lines next = hears();
    ASSERT_EQ(next.size(), 1U);
    EXPECT_EQ(next[0], "! Your pot") << "the ring is where it was";
}

TEST_F(NarratorTest, TellsTheClayAtAPaceAndOnlyWhatHasChanged) {
    view.state.screen = Screen::kThrow;
    static_cast<void>(hears());
    EXPECT_EQ(hears(10.0), Lines{}) << "nothing has changed";
    open_to(20.0);
    pot.height_mm = 90.0;
    EXPECT_EQ(hears(), (Lines{"Open, 9 centimetres high, walls up to 20 millimetres"}));
    pot.height_mm = 120.0;
    EXPECT_EQ(hears(), Lines{}) << "four seconds between two";
    is_quiet = false;
    EXPECT_EQ(hears(5.0), Lines{}) << "not over a line";
    is_quiet = true;
    EXPECT_EQ(hears(), Lines{"12 centimetres high"});
    pot.height_mm = 123.0;
    EXPECT_EQ(hears(10.0), Lines{}) << "too little to tell";
    snapshot.load.index = 0.72;
    EXPECT_EQ(hears(10.0), Lines{"70 percent of what it can bear"});
    snapshot.load.index = 0.3;
    EXPECT_EQ(hears(10.0), Lines{});
}

TEST_F(NarratorTest, SaysWhyTheClayDoesNotFollowOnceForAWhile) {
    view.state.screen = Screen::kThrow;
    static_cast<void>(hears());
    guard = screens::CueGuard::kAsHigh;
    is_quiet = false;
    EXPECT_EQ(hears(), Lines{}) << "not over a line";
    is_quiet = true;
    EXPECT_EQ(hears(), Lines{"This is as high as one pull goes. Let go and draw up once more."});
    EXPECT_EQ(hears(), Lines{});
    guard = screens::CueGuard::kNone;
    EXPECT_EQ(hears(3.0), Lines{});
    guard = screens::CueGuard::kAsHigh;
    EXPECT_EQ(hears(3.0), Lines{}) << "the next press ends at the same";
    guard = screens::CueGuard::kNearLimit;
    EXPECT_EQ(hears(), Lines{"Any more and the pot would sink."}) << "another reason";
    EXPECT_EQ(hears(20.0), Lines{"Any more and the pot would sink."});
}

TEST_F(NarratorTest, SaysWhatADeviceDoes) {
    view.state.screen = Screen::kThrow;
    has_device = true;
    const Lines first = hears();
    EXPECT_EQ(std::count_if(first.begin(), first.end(),
                            [](const auto& line) { return line.starts_with("The device in your hand"); }),
              1);
}

TEST_F(NarratorTest, TellsWhereADevicesTipIsAtAPaceAndWhetherItTouches) {
    view.state.screen = Screen::kThrow;
    device_is_at_buttons = false;
    snapshot.tool.position_mm = {85.0, 10.0, 0.0};
    snapshot.result.side = tool::Side::kFree;
    is_quiet = false;
    static_cast<void>(hears());
    snapshot.tool.position_mm = {3.0, 64.0, 4.0};
    static_cast<void>(hears());
    EXPECT_EQ(hears(2.0), Lines{}) << "the screen's explanation is not cut off";
    is_quiet = true;
    EXPECT_EQ(hears(), Lines{"! Over the middle"});
    snapshot.tool.position_mm = {85.0, 10.0, 0.0};
    EXPECT_EQ(hears(2.0), Lines{}) << "on its way";
    is_quiet = false;
    EXPECT_EQ(hears(0.5), Lines{"! Outside, at the base"}) << "another place cuts off what is said";
    snapshot.result.side = tool::Side::kOut;
    snapshot.result.forces.contacts = 3;
    static_cast<void>(hears());
    EXPECT_EQ(hears(2.0), Lines{}) << "a touch does not";
    is_quiet = true;
    EXPECT_EQ(hears(), Lines{"touching"});
    snapshot.tool.position_mm.y = 30.0;
    static_cast<void>(hears());
    EXPECT_EQ(hears(0.5), Lines{}) << "too soon after the last";
    EXPECT_EQ(hears(1.0), Lines{"half way up"});
    snapshot.tool.position_mm.y = 20.5;
    static_cast<void>(hears());
    EXPECT_EQ(hears(2.0), Lines{}) << "at the border of two places";
    open_to(10.0);
    snapshot.tool.position_mm = {40.0, 62.0, 40.0};
    snapshot.result.forces.contacts = 0;
    static_cast<void>(hears());
    EXPECT_EQ(hears(2.0), Lines{"! At the rim"}) << "a touch is told where there is one";
    device_is_at_buttons = true;
    static_cast<void>(hears(5.0));
    EXPECT_EQ(hears(2.0), Lines{"! At the buttons"});
}

// Each fragment stands in each language, and none of the places sounds like another.
TEST_F(NarratorTest, TellsADevicesPlacesApartInEveryLanguage) {
    view.state.screen = Screen::kThrow;
    device_is_at_buttons = false;
    for (std::size_t language = 0; language < view.languages->size(); ++language) {
        view.state.comfort.language = static_cast<int>(language);
        narrator.forget();
        std::set<std::string> told_places;
        const auto tells = [&](const dvec3& tip_mm, tool::Side side) {
            snapshot.tool.position_mm = tip_mm;
            snapshot.result.side = side;
            static_cast<void>(hears(5.0));
            const Lines lines = hears(2.0);
            ASSERT_EQ(lines.size(), 1U) << (*view.languages)[language].code();
            told_places.insert(lines.front());
        };
        static_cast<void>(hears());
        tells({0.0, 64.0, 0.0}, tool::Side::kTop);
        tells({55.0, 58.0, 0.0}, tool::Side::kTop);
        tells({80.0, 10.0, 0.0}, tool::Side::kOut);
        tells({20.0, 10.0, 0.0}, tool::Side::kIn);
        tells({130.0, 10.0, 20.0}, tool::Side::kFree);
        tells({-130.0, 10.0, 20.0}, tool::Side::kFree);
        tells({20.0, 90.0, 130.0}, tool::Side::kFree);
        tells({20.0, 90.0, -130.0}, tool::Side::kFree);
        EXPECT_EQ(told_places.size(), 8U) << (*view.languages)[language].code();
    }
}

TEST_F(NarratorTest, TellsWhenTheArrowKeysAreAHandAgain) {
    view.state.screen = Screen::kThrow;
    targets = {{.button = Button::kDone, .name = "Done", .spoken = "Done."}};
    focus = 0;
    static_cast<void>(hears());
    focus = -1;
    EXPECT_EQ(hears(), Lines{"! The arrow keys are your hand"});
    EXPECT_EQ(hears(), Lines{});
}

TEST_F(NarratorTest, ReadsTheStaffsPanelInEnglish) {
    view.state.comfort.language = 1;
    view.state.panel = kiosk::Panel::kStaff;
    told = {"Staff panel", "Health", "Rate: 1000 Hz"};
    targets = {{.button = Button::kStaffDeletePot, .name = "Delete", .spoken = "Delete Pot 7"}};
    EXPECT_EQ(hears(), Lines{"! Staff panel, Health, Rate: 1000 Hz"});
    told.back() = "Rate: 999 Hz";
    EXPECT_EQ(hears(20.0), Lines{}) << "a figure that changes by itself";
    focus = 0;
    EXPECT_EQ(hears(), Lines{"! Delete Pot 7, 1 of 1"});
    view.staff_notice = "The force test has ended: fine";
    EXPECT_EQ(hears(), Lines{"! The force test has ended: fine"});
    view.state.staff.page = kiosk::StaffPage::kVisits;
    told = {"Staff panel", "Visits"};
    EXPECT_EQ(hears(), Lines{"! Staff panel, Visits"});
}

// EN 301 549, 5.1.3.8: what is masked on the screen is not spoken either, unless in private.
TEST_F(NarratorTest, NamesTheDigitsOfAPinInPrivateAlone) {
    view.state.panel = kiosk::Panel::kPin;
    told = {"Staff PIN"};
    targets = {{.button = Button::kDigit, .value = 4, .name = "4", .spoken = "4"},
               {.button = Button::kPinClose, .name = "Close", .spoken = "Close"}};
    EXPECT_EQ(hears(), Lines{"! Staff PIN"});
    focus = 0;
    EXPECT_EQ(hears(), Lines{});
    focus = 1;
    EXPECT_EQ(hears(), Lines{"! Close, 2 of 2"});
    is_private = true;
    focus = 0;
    EXPECT_EQ(hears(), Lines{"! 4, 1 of 2"});
    view.state.staff.digits = 1;
    told = {"Staff PIN: 1"};
    EXPECT_EQ(hears(), Lines{"! Staff PIN: 1"});
}

TEST_F(NarratorTest, TellsEverythingToWhomeverAsks) {
    view.state.screen = Screen::kThrow;
    targets = {{.button = Button::kDone, .name = "Done", .spoken = "Done. Cut the pot off the wheel."}};
    focus = 0;
    static_cast<void>(hears());
    open_to(14.0);
    static_cast<void>(hears(10.0));
    asks_where = true;
    is_quiet = false;
    const Lines all = hears();
    ASSERT_EQ(all.size(), 3U);
    EXPECT_TRUE(all[0].starts_with("! Step one of three")) << all[0];
    EXPECT_EQ(all[1], "Done. Cut the pot off the wheel. 1 of 1");
    EXPECT_EQ(all[2], "Open, 6 centimetres high, walls up to 14 millimetres");
}

TEST_F(NarratorTest, SaysWhereTheKeysHandComesToTheRimOrTheMiddle) {
    view.state.screen = Screen::kThrow;
    static_cast<void>(hears());
    marker = MarkerPlace::kWall;
    EXPECT_EQ(hears(), Lines{});
    marker = MarkerPlace::kRim;
    EXPECT_EQ(hears(), Lines{"! At the rim"});
    marker = MarkerPlace::kMiddle;
    EXPECT_EQ(hears(), Lines{"! Over the middle"});
    EXPECT_EQ(hears(), Lines{});
}

TEST_F(NarratorTest, WarnsOfTheTimeOutAndOnceMoreBeforeItsEnd) {
    view.state.screen = Screen::kGlaze;
    static_cast<void>(hears());
    view.state.panel = kiosk::Panel::kIdle;
    view.seconds_left = 20;
    const Lines first = hears();
    ASSERT_EQ(first.size(), 1U);
    EXPECT_NE(first[0].find("in 20 seconds"), std::string::npos) << first[0];
    view.seconds_left = 11;
    EXPECT_EQ(hears(), Lines{});
    view.seconds_left = 10;
    ASSERT_EQ(hears().size(), 1U);
    view.seconds_left = 9;
    EXPECT_EQ(hears(), Lines{});
}

TEST_F(NarratorTest, TellsAPotInNumbersAndWords) {
    view.state.screen = Screen::kYourPot;
    auto fired = std::make_shared<screens::FiredPot>();
    fired->height_mm = 112.4;
    fired->width_mm = 98.0;
    fired->weight_g = 870.0;
    fired->capacity_l = 0.42;
    fired->good_key = "tip.good.wall";
    view.pot = fired;
    EXPECT_EQ(hears(), (Lines{"! Your pot",
                              "Height 112 millimetres, Width 98 millimetres, Weight 870 grams, "
                              "Capacity 0.4 litres",
                              "Good: a thin, light wall"}));
}

}  // namespace
}  // namespace onggi::app
