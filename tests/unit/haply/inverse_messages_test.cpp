// Parsing the Inverse service's messages, and refusing everything else.
#include "engine/haptics/haply/inverse_messages.h"

#include <gtest/gtest.h>

#include <string>

namespace onggi::haptics::haply {
namespace {

// The form of the service's public description, 3.5.
constexpr std::string_view kInventory =
    R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"inverse3",
 "gravity":{"enabled":true,"scale":1.0}},"state":{"cursor_position":{"x":0.01,"y":-0.15,"z":2.0e-1},
 "cursor_velocity":{"x":0.0,"y":0.0,"z":0.0},"body_orientation":{"w":1,"x":0,"y":0,"z":0},"control_mode":"idle"},
 "status":{"ready":true,"error":null}}],"verse_grip":[]})";

std::string refusal(std::string_view message) {
    const auto state = inverse_state(message);
    return state ? "taken" : state.error().message;
}

TEST(InverseMessages, FindsTheFirstDeviceAndItsCursor) {
    const auto state = inverse_state(kInventory);
    ASSERT_TRUE(state) << state.error().message;
    ASSERT_TRUE(*state);
    EXPECT_EQ((*state)->device_id, "049D");
    EXPECT_EQ((*state)->cursor_m, dvec3(0.01, -0.15, 0.2));
}

TEST(InverseMessages, FindNoDeviceBeforeOneIsPluggedIn) {
    const auto state = inverse_state(R"({"session_id":7,"inverse3":[],"verse_grip":[]})");
    ASSERT_TRUE(state);
    EXPECT_FALSE(*state);
    ASSERT_TRUE(inverse_state("{}"));
}

TEST(InverseMessages, RejectsInvalidJson) {
    EXPECT_EQ(refusal(""), "byte 0: expected JSON, found the end");
    EXPECT_EQ(refusal("{\"a\":1"), "byte 6: expected JSON, found the end");
    EXPECT_EQ(refusal("[1,]"), "byte 3: expected JSON, found byte 0x5d");
    EXPECT_EQ(refusal("{} x"), "byte 3: expected JSON, found byte 0x78");
    EXPECT_EQ(refusal("\"\xff"), "byte 1: expected JSON, found byte 0xff");
    EXPECT_EQ(refusal("nan"), "byte 1: expected JSON, found byte 0x61");
    EXPECT_EQ(refusal("[1e999]"), "byte 5: expected a number within range, found byte 0x39");
    EXPECT_EQ(refusal("[inf]"), "byte 1: expected JSON, found byte 0x69");
    EXPECT_EQ(refusal("\"\\"), "byte 2: expected JSON, found the end");
}

TEST(InverseMessages, RejectsTooLargeMessages) {
    const auto nested = [](std::size_t deep) { return std::string(deep, '[') + std::string(deep, ']'); };
    EXPECT_EQ(refusal(nested(kMaxJsonDepth)), "taken");
    EXPECT_EQ(refusal(nested(kMaxJsonDepth + 1)), "expected values at most 32 deep, found one deeper");
    EXPECT_EQ(refusal(std::string(kMaxMessageBytes, '[')),
              "expected values at most 32 deep, found one deeper");
    EXPECT_EQ(refusal("1" + std::string(kMaxMessageBytes - 1, ' ')), "taken");
    EXPECT_EQ(refusal("1" + std::string(kMaxMessageBytes, ' ')), "expected at most 65536 bytes, found 65537");
}

TEST(InverseMessages, RejectsAnInvalidDevice) {
    EXPECT_EQ(refusal(R"({"inverse3":[{"device_id":"a\"b","state":{}}]})"),
              "inverse3.0.device_id: expected up to 32 letters and digits, found something else");
    EXPECT_EQ(refusal(R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0,"y":"far"}}}]})"),
              "inverse3.0.state.cursor_position: expected the numbers x, y and z, found fewer");
    EXPECT_EQ(
        refusal(R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0,"y":0,"z":-7}}}]})"),
        "inverse3.0.state.cursor_position: expected a place within 1 m, found 7 m");
}

TEST(InverseMessages, StateForcesInBothFormsAndNameTheProgramInTheFirst) {
    EXPECT_EQ(force_message("049D", {0.5, 0.0, -1.25}, "vector", false),
              R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"vector":)"
              R"({"x":0.5000,"y":0.0000,"z":-1.2500}}}}]})");
    EXPECT_EQ(
        force_message("049D", {0.0, 0.0, 0.0}, "values", true),
        R"({"session":{"configure":{"profile":{"name":"onggi"}}},"inverse3":[{"device_id":"049D","commands":)"
        R"({"set_cursor_force":{"values":{"x":0.0000,"y":0.0000,"z":0.0000}}}}]})");
    EXPECT_EQ(probe_message("049D", false),
              R"({"inverse3":[{"device_id":"049D","commands":{"probe_position":{}}}]})");
}

TEST(WalkJson, TellsEachValueWithItsPlace) {
    std::string told;
    ASSERT_TRUE(walk_json(
        R"( {"a" : [1, {"b":"x"}, true], "c":-2.5e1} )", [&](std::string_view place, const JsonValue& value) {
            told += std::string(place) + "=" + std::string(value.text) + std::to_string(value.number) + ";";
        }));
    EXPECT_EQ(told, "a.0=1.000000;a.1.b=x0.000000;a.2=0.000000;c=-25.000000;");
    told.clear();
    ASSERT_TRUE(walk_json(
        R"([{}, [], [[-3], "\u0041\n"], null])", [&](std::string_view place, const JsonValue& value) {
            told += std::string(place) + "=" + std::string(value.text) + std::to_string(value.number) + ";";
        }));
    EXPECT_EQ(told, "2.0.0=-3.000000;2.1=A\n0.000000;3=0.000000;");
}

}  // namespace
}  // namespace onggi::haptics::haply
