// The SpaceMouse's reports, as captured in public, and what they do to the tool.
#include "engine/haptics/hid/simple_drivers.h"

#include <gtest/gtest.h>

#include "tests/support/hex.h"
#include "tests/support/scripted_hid.h"

namespace onggi::haptics::hid {
namespace {

using testing::as_hex;
using testing::hex;

SpaceMouseState after(std::initializer_list<std::string_view> reports) {
    SpaceMouseState state;
    for (const std::string_view report : reports)
        EXPECT_TRUE(take_space_mouse_report(hex(report), state)) << report;
    return state;
}

TEST(SpaceMouse, ReadsTheCompactsCapturedReports) {
    // SpaceMouse Compact, CloudCompare pull request 2339.
    const SpaceMouseState first = after({"02 20 00 00 00 17 00", "01 12 00 00 00 f8 00"});
    EXPECT_EQ(first.translation, (std::array<std::int16_t, 3>{18, 0, 248}));
    EXPECT_EQ(first.rotation, (std::array<std::int16_t, 3>{32, 0, 23}));
    const SpaceMouseState last =
        after({"02 20 00 00 00 17 00", "01 12 00 00 00 f8 00", "02 20 00 00 00 19 00", "01 12 00 00 00 12 01",
               "02 1d 00 00 00 1b 00", "01 0d 00 00 00 25 01"});
    EXPECT_EQ(last.translation, (std::array<std::int16_t, 3>{13, 0, 293}));
    EXPECT_EQ(last.rotation, (std::array<std::int16_t, 3>{29, 0, 27}));
}

TEST(SpaceMouse, ReadsTheNavigatorsCapturedReports) {
    // SpaceNavigator, AndunHH/spacemouse.
    EXPECT_EQ(after({"02 00 00 e2 ff 00 00"}).rotation, (std::array<std::int16_t, 3>{0, -30, 0}));
    EXPECT_TRUE(after({"01 12 00 00 00 12 01", "01 00 00 00 00 00 00"}).at_rest());
    EXPECT_EQ(after({"03 01 00"}).buttons, 1U);
    EXPECT_EQ(after({"03 02 00"}).buttons, 2U);
    EXPECT_EQ(after({"03 03 00"}).buttons, 3U);
    EXPECT_EQ(after({"03 03 00", "03 00 00"}).buttons, 0U);
}

TEST(SpaceMouse, ReadsBothHalvesOfALongReport) {
    // Synthetic: the wireless model's layout is known from its descriptor, but no motion reports are public.
    const SpaceMouseState state = after({"01 12 00 00 00 12 01 20 00 00 00 19 00"});
    EXPECT_EQ(state.translation, (std::array<std::int16_t, 3>{18, 0, 274}));
    EXPECT_EQ(state.rotation, (std::array<std::int16_t, 3>{32, 0, 25}));
    EXPECT_EQ(after({"17 5f 00"}).battery_percent, 95);
}

TEST(SpaceMouse, FindsTheSparseButtonsOfTheBigModels) {
    // SpaceMouse Pro: the lowest and highest of its buttons, SHIFT at byte 4 bit 0 and MENU at byte 1 bit 0.
    EXPECT_EQ(after({"03 01 00 00 01"}).buttons, (1U << 0U) | (1U << 24U));
}

TEST(SpaceMouse, RejectsReportsThatAreCutOrUnknown) {
    SpaceMouseState state = after({"01 12 00 00 00 12 01"});
    for (const char* report : {"", "01", "01 00 00 00 00 00", "02 00 00 00 00 00", "03", "05 00 00", "17"})
        EXPECT_FALSE(take_space_mouse_report(hex(report), state)) << report;
    EXPECT_EQ(state.translation, (std::array<std::int16_t, 3>{18, 0, 274}));
}

TEST(SpaceMouse, TurnsItsLampOnAndOff) {
    EXPECT_EQ(as_hex(space_mouse_lamp(true).view()), "04 01");
    EXPECT_EQ(as_hex(space_mouse_lamp(false).view()), "04 00");
}

TEST(SpaceMouse, MovesTheToolAlthoughItsLampCannotBeSwitched) {
    const auto script = std::make_shared<testing::ScriptedHid>();
    script->write_fails = true;
    testing::ScriptedPort port(script);
    SpaceMouseDriver driver;
    ASSERT_TRUE(driver.start({}, port));
    driver.take_report(hex("01 5e 01 00 00 00 00"), 0);
    EXPECT_GT(driver.input(0).rate_mm_s.x, 0.0);
}

TEST(SpaceMouse, RestsInsideItsDeadBandAndKeepsItsSpeedLimit) {
    const SpaceMouseMapping mapping;
    for (const int value : {0, 1, 15, -15})
        EXPECT_EQ(shaped_axis(static_cast<std::int16_t>(value), mapping), 0.0) << value;
    EXPECT_GT(shaped_axis(16, mapping), 0.0);
    EXPECT_LT(shaped_axis(16, mapping), 1e-6) << "no jump at the edge of the dead band";
    EXPECT_EQ(shaped_axis(350, mapping), 1.0);
    EXPECT_EQ(shaped_axis(500, mapping), 1.0) << "real units exceed their descriptor";
    EXPECT_EQ(shaped_axis(-32768, mapping), -1.0);
    double before = 0.0;
    for (std::int16_t value = 16; value <= 350; ++value) {
        const double shaped = shaped_axis(value, mapping);
        EXPECT_GT(shaped, before) << value;
        EXPECT_EQ(shaped_axis(static_cast<std::int16_t>(-value), mapping), -shaped);
        before = shaped;
    }
}

TEST(SpaceMouse, MovesTheToolOutwardsToTheRightAndDownwardsWhenPressed) {
    const SpaceMouseMapping mapping;
    const dvec2 right = space_mouse_rate_mm_s(after({"01 5e 01 00 00 00 00"}), mapping);  // X = 350
    EXPECT_EQ(right, dvec2(mapping.fastest_mm_s, 0.0));
    const dvec2 pressed = space_mouse_rate_mm_s(after({"01 00 00 00 00 5e 01"}), mapping);  // Z = 350
    EXPECT_EQ(pressed, dvec2(0.0, -mapping.fastest_mm_s));
    const dvec2 towards = space_mouse_rate_mm_s(after({"01 00 00 5e 01 00 00"}), mapping);  // Y: a round pot
    EXPECT_EQ(towards, dvec2(0.0));
}

}  // namespace
}  // namespace onggi::haptics::hid
