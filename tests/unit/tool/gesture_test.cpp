#include "game/tool/gesture.h"

#include <gtest/gtest.h>

#include <clocale>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "game/tool/tool.h"
#include "tests/support/places.h"
#include "tests/support/refusal.h"

namespace onggi::tool {
namespace {

const std::string kHeader = std::string(kGestureHeader) + "\n";

// The gesture of these rows; the test fails if there is none.
Gesture gesture_of(const std::string& rows, const std::string& header = kHeader) {
    auto gesture = parse_gesture(header + rows, "g.csv");
    if (!gesture) {
        ADD_FAILURE() << gesture.error().message;
        return *parse_gesture(kHeader + "0,0,0,0,0,10\n", "g.csv");
    }
    return std::move(gesture).value();
}

// The one line with which a text is refused.
std::string refusal(const std::string& text) {
    const std::string line = test::refusal(parse_gesture(text, "g.csv"));
    EXPECT_LT(line.size(), 300U);
    return line;
}

TEST(Gesture, IsReadRowByRow) {
    const Gesture gesture = gesture_of("0,95,10,-3.5,0,10\n0.25,60.5,1e1,0,1,12.25\n");
    ASSERT_EQ(gesture.rows().size(), 2U);
    EXPECT_EQ(gesture.rows()[1].t_s, 0.25);
    EXPECT_EQ(gesture.rows()[0].tool,
              (ToolState{.position_mm = {95, 10, -3.5}, .radius_mm = 10, .wheel_button = false}));
    EXPECT_EQ(gesture.rows()[1].tool,
              (ToolState{.position_mm = {60.5, 10, 0}, .radius_mm = 12.25, .wheel_button = true}));
}

TEST(Gesture, MayEndItsLinesAsWindowsDoesAndTheLastNotAtAll) {
    const std::string text = "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm\r\n0,1,2,3,0,10\r\n1,1,2,3,1,10";
    const auto gesture = parse_gesture(text, "g.csv");
    ASSERT_TRUE(gesture) << gesture.error().message;
    EXPECT_EQ(gesture->rows().size(), 2U);
    EXPECT_EQ(gesture->rows()[1].tool.radius_mm, 10);
}

TEST(Gesture, PassesItsExtraColumnsToTheStudiosClay) {
    const Gesture gesture = gesture_of(
        "0,60,20,0,1,8,sponge,inner,1,90,6.5,3,rim,88,-30,20,5,7,rib\n"
        "1,60,40,0,1,8,,,,,,,,,-30,60,5,,\n"
        "2,60,40,0,1,8,hand,auto,0,200,0,0,off,1,,,,,\n",
        std::string(kGestureHeader) +
            ",tool,side,water,wheel_rev_min,assist_gap_mm,shaft_mm,wire,wire_y_mm,hand2_x_mm,hand2_y_mm,"
            "hand2_z_mm,hand2_radius_mm,hand2_tool\n");
    ASSERT_EQ(gesture.rows().size(), 3U);
    const ToolState& first = gesture.rows()[0].tool;
    EXPECT_EQ(first.tool, Tool::kSponge);
    EXPECT_EQ(first.side, Side::kIn);
    EXPECT_EQ(first.water, 1.0);
    EXPECT_EQ(first.wheel_speed_rev_min, 90.0);
    EXPECT_EQ(first.assist_gap_mm, 6.5);
    EXPECT_EQ(first.shaft_mm, 3.0);
    EXPECT_EQ(first.wire, tool::Wire::kCutRim);
    EXPECT_EQ(first.wire_height_mm, 88.0);
    EXPECT_EQ(
        first.second,
        (SecondHand{
            .present = true, .tool = tool::Tool::kRib, .radius_mm = 7.0, .position_mm = {-30.0, 20.0, 5.0}}));
    // Empty fields have their defaults; a second hand is as large as the first.
    const ToolState& second = gesture.rows()[1].tool;
    EXPECT_EQ(second.tool, Tool::kHand);
    EXPECT_EQ(second.wheel_speed_rev_min, ToolState{}.wheel_speed_rev_min);
    EXPECT_EQ(second.second.radius_mm, 8.0);
    EXPECT_EQ(gesture.rows()[2].tool.wire, Wire::kCutOff);
    EXPECT_FALSE(gesture.rows()[2].tool.second.present);
    EXPECT_EQ(gesture.rows()[2].tool.second, SecondHand{});
    // The second hand goes straight from row to row, as the first does, and its settings hold.
    EXPECT_EQ(gesture.at(0.5).second.position_mm, dvec3(-30.0, 40.0, 5.0));
    EXPECT_EQ(gesture.at(0.5).second.tool, Tool::kRib);
    EXPECT_EQ(gesture.at(1.5).second.position_mm, dvec3(-30.0, 60.0, 5.0)) << "there is nowhere to go";
}

TEST(Gesture, SaysWhenAFingerIsFollowedAndWhenItPresses) {
    const Gesture gesture = gesture_of(
        "0,60,20,0,1,8,1,0\n"
        "1,50,40,0,1,8,1,1\n"
        "2,70,40,0,1,8,,\n"
        "3,70,40,0,1,8,0,0\n",
        std::string(kGestureHeader) + ",guided,pressing\n");
    const auto bits_at = [&](double t_s) {
        return std::pair{gesture.at(t_s).guided, gesture.at(t_s).pressing};
    };
    // From their row's own time until the next, as the button does, while the finger goes straight on.
    EXPECT_EQ(bits_at(0.0), std::pair(true, false));
    EXPECT_EQ(bits_at(0.999), std::pair(true, false));
    EXPECT_EQ(gesture.at(0.5).position_mm, dvec3(55, 30, 0));
    EXPECT_EQ(bits_at(1.0), std::pair(true, true));
    EXPECT_EQ(gesture.at(1.5).position_mm, dvec3(60, 40, 0));
    EXPECT_EQ(bits_at(1.999), std::pair(true, true));
    EXPECT_EQ(bits_at(2.0), std::pair(false, true)) << "what a row leaves empty is as without the column";
    EXPECT_EQ(bits_at(3.0), std::pair(false, false));
    EXPECT_EQ(bits_at(9.0), std::pair(false, false));
    EXPECT_TRUE(gesture_of("0,60,20,0,1,8\n").at(0.0).pressing);
    EXPECT_FALSE(gesture_of("0,60,20,0,1,8\n").at(0.0).guided);
}

TEST(Gesture, LeavesColumnsItDoesNotKnowAlone) {
    const Gesture gesture =
        gesture_of("0,1,2,3,0,10,anything at all,-\n", std::string(kGestureHeader) + ",mood,weather\n");
    EXPECT_EQ(gesture.rows()[0].tool,
              (ToolState{.position_mm = {1, 2, 3}, .radius_mm = 10, .wheel_button = false}));
}

TEST(RejectsGesture, WithInvalidValuesInExtraColumns) {
    const auto with = [](const std::string& columns, const std::string& fields) {
        return refusal(std::string(kGestureHeader) + "," + columns + "\n0,1,2,3,0,10," + fields + "\n");
    };
    EXPECT_EQ(with("tool", "spoon"), "g.csv:2: tool: expected hand, rib, sponge, trimmer, found 'spoon'");
    EXPECT_EQ(with("side", "left"), "g.csv:2: side: expected auto, outer, inner, rim, found 'left'");
    EXPECT_EQ(with("water", "2"), "g.csv:2: water: expected 0 to 1, found '2'");
    EXPECT_EQ(with("water", "nan"), "g.csv:2: water: expected a finite number, found 'nan'");
    EXPECT_EQ(with("wheel_rev_min", "301"), "g.csv:2: wheel_rev_min: expected 0 to 300, found '301'");
    EXPECT_EQ(with("assist_gap_mm", "-1"), "g.csv:2: assist_gap_mm: expected 0 to 60, found '-1'");
    EXPECT_EQ(with("shaft_mm", "1e9"), "g.csv:2: shaft_mm: expected 0 to 40, found '1e9'");
    EXPECT_EQ(with("guided", "2"), "g.csv:2: guided: expected 0 or 1, found '2'");
    EXPECT_EQ(with("guided", "nan"), "g.csv:2: guided: expected 0 or 1, found 'nan'");
    EXPECT_EQ(with("guided", "1.0"), "g.csv:2: guided: expected 0 or 1, found '1.0'");
    EXPECT_EQ(with("pressing", "yes"), "g.csv:2: pressing: expected 0 or 1, found 'yes'");
    EXPECT_EQ(with("pressing", "-0"), "g.csv:2: pressing: expected 0 or 1, found '-0'");
    EXPECT_EQ(with("guided,pressing", "1, 1"), "g.csv:2: pressing: expected 0 or 1, found ' 1'");
    EXPECT_EQ(with("wire,wire_y_mm", "cut,5"), "g.csv:2: wire: expected none, rim, off, found 'cut'");
    EXPECT_EQ(with("wire", "rim"), "g.csv:1: expected a column wire_y_mm beside the others, found none");
    EXPECT_EQ(with("hand2_x_mm,hand2_z_mm", "1,2"),
              "g.csv:1: expected a column hand2_y_mm beside the others, found none");
    EXPECT_EQ(with("hand2_x_mm,hand2_y_mm,hand2_z_mm", "1,1001,2"),
              "g.csv:2: hand2_y_mm: expected -1000 to 1000, found '1001'");
    EXPECT_EQ(with("hand2_x_mm,hand2_y_mm,hand2_z_mm", "1,,2"),
              "g.csv:2: hand2_y_mm: expected a number beside the other two coordinates, found ''");
    EXPECT_EQ(with("hand2_x_mm,hand2_y_mm,hand2_z_mm", ",4,2"),
              "g.csv:2: hand2_x_mm: expected a number beside the other two coordinates, found ''");
}

TEST(Gesture, MayHaveColumnsToTheRight) {
    const Gesture gesture =
        gesture_of("0,1,2,3,0,10,inner,0.5\n1,1,2,3,0,10,,\n", std::string(kGestureHeader) + ",side,water\n");
    ASSERT_EQ(gesture.rows().size(), 2U);
    EXPECT_EQ(gesture.rows()[0].tool.side, Side::kIn);
    EXPECT_EQ(gesture.rows()[0].tool.water, 0.5);
    EXPECT_EQ(gesture.rows()[1].tool.water, 0.0) << "an empty field is as by default";
}

TEST(Gesture, IsTheSameInEveryLocale) {
    // In a locale with a decimal comma a locale-dependent parser reads 95.5 as 95.
    const char* before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "ko_KR.UTF-8", "C"}) {
        std::setlocale(LC_ALL, locale);
        EXPECT_EQ(gesture_of("0,95.5,0,0,0,10\n").rows()[0].tool.position_mm.x, 95.5);
    }
    std::setlocale(LC_ALL, before);
}

TEST(Gesture, MovesInStraightLinesBetweenRows) {
    const Gesture gesture = gesture_of("0,90,100,0,0,10\n0.2,69,100,8,0,10\n1.2,69,100,8,0,10\n");
    EXPECT_EQ(gesture.at(0.0).position_mm, dvec3(90, 100, 0));
    EXPECT_DOUBLE_EQ(gesture.at(0.1).position_mm.x, 79.5);
    EXPECT_DOUBLE_EQ(gesture.at(0.05).position_mm.z, 2.0);
    EXPECT_EQ(gesture.at(0.2).position_mm, dvec3(69, 100, 8));
    EXPECT_EQ(gesture.at(0.7).position_mm, dvec3(69, 100, 8));
}

TEST(Gesture, HoldsButtonAndRadiusFromTheirRowsOwnTime) {
    const Gesture gesture = gesture_of("0,0,0,0,0,10\n0.5,0,0,0,1,12\n1,0,0,0,0,20\n");
    EXPECT_FALSE(gesture.at(0.4999).wheel_button);
    EXPECT_EQ(gesture.at(0.4999).radius_mm, 10);
    EXPECT_TRUE(gesture.at(0.5).wheel_button);
    EXPECT_EQ(gesture.at(0.5).radius_mm, 12);
    EXPECT_TRUE(gesture.at(0.9999).wheel_button);
    EXPECT_FALSE(gesture.at(1.0).wheel_button);
    EXPECT_EQ(gesture.at(1.0).radius_mm, 20);
}

TEST(Gesture, RestsAtItsEnds) {
    const Gesture gesture = gesture_of("0,1,2,3,0,10\n1,4,5,6,1,11\n");
    EXPECT_EQ(gesture.at(-1.0), gesture.rows()[0].tool);
    EXPECT_EQ(gesture.at(1.0), gesture.rows()[1].tool);
    EXPECT_EQ(gesture.at(1e9), gesture.rows()[1].tool);
}

TEST(Gesture, HasATickAtItsLastRowEvenWhenTheNumberFallsShort) {
    EXPECT_EQ(gesture_of("0,0,0,0,0,10\n").tick_count(1000), 1U);
    EXPECT_EQ(gesture_of("0,0,0,0,0,10\n1.4,0,0,0,0,10\n").tick_count(1000), 1401U);
    EXPECT_EQ(gesture_of("0,0,0,0,0,10\n1.4,0,0,0,0,10\n").tick_count(100), 141U);
    EXPECT_EQ(gesture_of("0,0,0,0,0,10\n0.0095,0,0,0,0,10\n").tick_count(1000), 10U);
    // 0.29 * 100 is 28.999999999999996.
    EXPECT_EQ(gesture_of("0,0,0,0,0,10\n0.29,0,0,0,0,10\n").tick_count(100), 30U);
    EXPECT_EQ(gesture_of("0,0,0,0,0,10\n3600,0,0,0,0,10\n").tick_count(10000), 36000001U);
}

TEST(Gesture, ReadsTheSampleGestures) {
    for (const char* name : {"vase", "touch-still", "press-and-hold"}) {
        std::ifstream file(test::in_checkout("assets/gestures/") + name + ".csv", std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const auto gesture = parse_gesture(text, name);
        EXPECT_TRUE(gesture) << gesture.error().message;
    }
}

TEST(RejectsGesture, EmptyOrWithoutRows) {
    EXPECT_EQ(refusal(""),
              "g.csv:1: expected the header t_s,x_mm,y_mm,z_mm,button,tool_radius_mm, found an empty file");
    EXPECT_EQ(refusal(kHeader), "g.csv:2: expected at least one row after the header, found none");
    EXPECT_EQ(refusal(std::string(kGestureHeader)),
              "g.csv:2: expected at least one row after the header, found none");
}

TEST(RejectsGesture, WithAnotherHeader) {
    const std::string row = "0,0,0,0,0,10\n";
    EXPECT_EQ(refusal("t,x,y,z,b,r\n" + row),
              "g.csv:1: expected the header t_s,x_mm,y_mm,z_mm,button,tool_radius_mm: column t_s is missing, "
              "found 't'");
    EXPECT_NE(refusal("t_s,x_mm,y_mm,z_mm,tool_radius_mm\n" + row).find("column button is missing"),
              std::string::npos);
    EXPECT_NE(refusal("t_s,x_mm,y_mm,z_mm,button\n" + row)
                  .find("column tool_radius_mm is missing, found the end of the line"),
              std::string::npos);
    EXPECT_NE(refusal("x_mm,t_s,y_mm,z_mm,button,tool_radius_mm\n" + row).find("column t_s is missing"),
              std::string::npos);
    EXPECT_NE(refusal("t_s, x_mm,y_mm,z_mm,button,tool_radius_mm\n" + row).find("found ' x_mm'"),
              std::string::npos);
    EXPECT_NE(refusal("\n" + kHeader + row).find("g.csv:1:"), std::string::npos);
    EXPECT_NE(refusal(row).find("g.csv:1:"), std::string::npos);
    EXPECT_NE(refusal("\xef\xbb\xbf" + kHeader + row).find("byte order mark"), std::string::npos);
    const std::string header(kGestureHeader);
    EXPECT_EQ(refusal(header + ",\n0,0,0,0,0,10,\n"),
              "g.csv:1: column 7: expected a name of its own, found ''");
    EXPECT_NE(refusal(header + ",side,side\n").find("column 8"), std::string::npos);
    EXPECT_NE(refusal(header + ",t_s\n").find("column 7"), std::string::npos);
}

TEST(RejectsGesture, WithTooFewOrTooManyColumns) {
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0\n"),
              "g.csv:2: tool_radius_mm: expected a value, found the end of the line");
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,10\n1,2\n"),
              "g.csv:3: y_mm: expected a value, found the end of the line");
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,10,7\n"), "g.csv:2: expected 6 columns, found more");
    EXPECT_EQ(refusal(std::string(kGestureHeader) + ",side\n0,0,0,0,0,10\n"),
              "g.csv:2: side: expected a value, found the end of the line");
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,10\n\n"), "g.csv:3: t_s: expected a number, found ''");
}

TEST(RejectsGesture, WithAnInvalidNumber) {
    for (const char* word : {"abc", "", " 1", "1 ", "+1", "1,5", "0x10", "1.2.3", "--1", "1e", "\x01"}) {
        const std::string found = refusal(kHeader + "0,0,0,0,0,10\n1,2," + word + ",0,0,10\n");
        EXPECT_TRUE(found.starts_with("g.csv:3: ")) << found;
        EXPECT_EQ(found.find("accepted"), std::string::npos) << word;
    }
    EXPECT_EQ(refusal(kHeader + "0,abc,0,0,0,10\n"), "g.csv:2: x_mm: expected a number, found 'abc'");
}

TEST(RejectsGesture, WithNanOrInfinity) {
    for (const char* word : {"nan", "NaN", "-nan", "inf", "-inf", "infinity", "INF", "1e999", "-1e999"}) {
        for (const char* column : {"x_mm", "y_mm", "z_mm"}) {
            std::string row = "0,A,B,C,0,10\n";
            const char letter = column[0] == 'x' ? 'A' : column[0] == 'y' ? 'B' : 'C';
            for (const char other : {'A', 'B', 'C'}) {
                row.replace(row.find(other), 1, other == letter ? word : "0");
            }
            EXPECT_EQ(refusal(kHeader + row),
                      "g.csv:2: " + std::string(column) + ": expected a finite number, found '" + word + "'");
        }
        EXPECT_NE(refusal(kHeader + word + ",0,0,0,0,10\n").find("t_s: expected a finite number"),
                  std::string::npos);
        EXPECT_NE(refusal(kHeader + "0,0,0,0,0," + word + "\n").find("tool_radius_mm: expected a finite"),
                  std::string::npos);
        EXPECT_NE(refusal(kHeader + "0,0,0,0," + word + ",10\n").find("button: expected 0 or 1"),
                  std::string::npos);
    }
}

TEST(RejectsGesture, WhoseTimeDoesNotAscendFromZero) {
    EXPECT_EQ(refusal(kHeader + "0.1,0,0,0,0,10\n"),
              "g.csv:2: t_s: expected 0 in the first row, found '0.1'");
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,10\n0.5,0,0,0,0,10\n0.5,0,0,0,0,10\n"),
              "g.csv:4: t_s: expected a time after 0.5, found '0.5'");
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,10\n0.5,0,0,0,0,10\n0.4,0,0,0,0,10\n"),
              "g.csv:4: t_s: expected a time after 0.5, found '0.4'");
    EXPECT_EQ(refusal(kHeader + "-1,0,0,0,0,10\n"), "g.csv:2: t_s: expected 0 to 3600, found '-1'");
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,10\n3600.001,0,0,0,0,10\n"),
              "g.csv:3: t_s: expected 0 to 3600, found '3600.001'");
}

TEST(RejectsGesture, BeyondTheBoundsOfToolAndWorkspace) {
    for (const char* radius : {"0", "1000", "1.999", "40.001", "-10"}) {
        EXPECT_EQ(refusal(kHeader + "0,0,0,0,0," + radius + "\n"),
                  std::string("g.csv:2: tool_radius_mm: expected 2 to 40, found '") + radius + "'");
    }
    for (const char* place : {"1000.001", "-1000.001", "1e300"}) {
        EXPECT_EQ(refusal(kHeader + "0,0," + place + ",0,0,10\n"),
                  std::string("g.csv:2: y_mm: expected -1000 to 1000, found '") + place + "'");
    }
    gesture_of("0,1000,-1000,0,0,2\n3600,0,0,0,1,40\n");
}

TEST(RejectsGesture, WithAButtonThatIsNeitherZeroNorOne) {
    for (const char* button : {"2", "-1", "0.5", "true", "", "1.0", "00", " 1"}) {
        EXPECT_EQ(refusal(kHeader + "0,0,0,0," + button + ",10\n"),
                  std::string("g.csv:2: button: expected 0 or 1, found '") + button + "'");
    }
}

TEST(RejectsGesture, OfAnotherKindOfFile) {
    EXPECT_NE(refusal(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)).find("found '\\x89PNG'"),
              std::string::npos);
    EXPECT_NE(refusal(std::string("\x7f"
                                  "ELF\x02\x01\x01\0\0\0",
                                  10))
                  .find("g.csv:1: expected the header"),
              std::string::npos);
    EXPECT_NE(refusal(kHeader + std::string("\0\0\0\0,1\n", 7)).find("t_s: expected a number, found '\\x00"),
              std::string::npos);
}

TEST(RejectsGesture, WithALineThatDoesNotEnd) {
    const std::string junk(std::size_t{100} << 20U, '7');
    EXPECT_EQ(refusal(junk), "g.csv:1: expected a line of at most 4096 bytes, found a longer one");
    EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,10\n1," + junk),
              "g.csv:3: expected a line of at most 4096 bytes, found a longer one");
    // A number as long as a line may be is still read or refused, not run over.
    EXPECT_NE(refusal(kHeader + std::string(4000, '1') + ",0,0,0,0,10\n").find("g.csv:2: t_s"),
              std::string::npos);
}

TEST(GestureStart, TellsAWrongFileByItsFirstBytes) {
    EXPECT_TRUE(check_gesture_start(kHeader + "0,1,", "g.csv"));
    EXPECT_TRUE(check_gesture_start(kGestureHeader, "g.csv"));
    EXPECT_FALSE(check_gesture_start("\x89PNG", "g.csv"));
    EXPECT_FALSE(check_gesture_start(std::string(5000, 'x'), "g.csv"));
    EXPECT_FALSE(check_gesture_start("", "g.csv"));
}

}  // namespace
}  // namespace onggi::tool
