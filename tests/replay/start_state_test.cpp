#include "game/haptic/start_state.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace onggi::haptic {
namespace {

tool::ToolState tool_at(std::uint64_t tick) {
    const double t = static_cast<double>(tick) / 1000.0;
    return {.position_mm = {75.0 - 10.0 * t, 60.0 + 50.0 * t, 3.0},
            .radius_mm = 9.0,
            .wheel_button = tick % 200 < 150};
}

// Two hands in a studio lump, the first coming down at the axis, later as a finger's; now and then they let
// go.
tool::ToolState studio_tool_at(std::uint64_t tick) {
    const double t = static_cast<double>(tick) / 1000.0;
    tool::ToolState tool{
        .position_mm = {10.0 * t, 60.0 - 15.0 * t, 0.0}, .radius_mm = 9.0, .wheel_button = tick % 500 < 450};
    tool.water = 1.0;
    tool.second = {.present = tick > 300, .position_mm = {-45.0, 15.0, 0.0}};
    tool.guided = tick > 700;
    tool.pressing = tick % 200 < 190;
    return tool;
}

// A lump somewhere in the middle of being thrown, with parameters of its own.
Start a_start() {
    Start start{HapticState(clay::PaperClay({.element_count = 150})), {}};
    start.parameters.set_rate_hz(1000.0);
    start.parameters.paper.softness_c1_per_mm = 12.0;
    start.parameters.paper.wheel_speed_rad_s = 7.0;
    for (std::uint64_t tick = 0; tick < 777; ++tick)
        haptic::tick(start.state, tool_at(tick), start.parameters);
    return start;
}

TEST(StartState, ContinuesIdentically) {
    Start original = a_start();
    const auto bytes = start_state_bytes(original.state, original.parameters);
    auto copy = start_from_bytes(bytes, 1000.0);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy->state.hash(), original.state.hash());
    EXPECT_EQ(copy->state.tool, original.state.tool);
    EXPECT_EQ(copy->state.ticks, 777U);
    for (std::uint64_t tick = 777; tick < 3000; ++tick) {
        const auto a = haptic::tick(original.state, tool_at(tick), original.parameters);
        const auto b = haptic::tick(copy->state, tool_at(tick), copy->parameters);
        ASSERT_EQ(a.forces.total_n(), b.forces.total_n()) << tick;
    }
    EXPECT_EQ(copy->state.hash(), original.state.hash());
}

TEST(StartState, IsTheSameBytesBackAgain) {
    const Start original = a_start();
    const auto bytes = start_state_bytes(original.state, original.parameters);
    const auto copy = start_from_bytes(bytes, 4000.0);
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy->parameters.paper.rate_hz, 4000.0);
    EXPECT_TRUE(start_state_bytes(copy->state, copy->parameters) == bytes);
}

// A studio lump somewhere in the middle of being thrown.
Start a_studio_start(std::uint64_t ticks = 777) {
    Start start{HapticState(clay::StudioClay({.mass_g = 300.0, .rings = 400, .sectors = 32})), {}};
    start.parameters.set_rate_hz(1000.0);
    start.parameters.studio.wheel = clay::studio::kick_wheel();
    start.parameters.studio.forgiving = true;
    for (std::uint64_t tick = 0; tick < ticks; ++tick)
        haptic::tick(start.state, studio_tool_at(tick), start.parameters);
    return start;
}

// With a ball in the clay, with a finger on it, and with a finger that has just let go.
TEST(StudioStartState, ContinuesIdentically) {
    for (const std::uint64_t ticks : {std::uint64_t{555}, std::uint64_t{777}, std::uint64_t{795}}) {
        Start original = a_studio_start(ticks);
        const auto bytes = start_state_bytes(original.state, original.parameters);
        auto copy = start_from_bytes(bytes, 1000.0);
        ASSERT_TRUE(copy) << copy.error().message;
        EXPECT_TRUE(start_state_bytes(copy->state, copy->parameters) == bytes);
        EXPECT_EQ(copy->state.hash(), original.state.hash());
        EXPECT_EQ(copy->state.tool, original.state.tool);
        EXPECT_EQ(copy->state.tool.guided, ticks > 700);
        EXPECT_EQ(copy->state.tool.pressing, ticks < 790);
        EXPECT_FALSE(copy->parameters.studio.wheel.can_brake);
        EXPECT_TRUE(copy->parameters.studio.forgiving);
        for (std::uint64_t tick = ticks; tick < 3000; ++tick) {
            const auto a = haptic::tick(original.state, studio_tool_at(tick), original.parameters);
            const auto b = haptic::tick(copy->state, studio_tool_at(tick), copy->parameters);
            ASSERT_EQ(a.forces.total_n(), b.forces.total_n()) << tick;
        }
        EXPECT_EQ(copy->state.hash(), original.state.hash());
    }
}

TEST(StudioStartState, StatesTheMannerOfTheHandsAndTakesStatesOfBefore) {
    Start start = a_studio_start();
    const auto wide = start_state_bytes(start.state, start.parameters);
    start.parameters.studio.manner = clay::studio::Manner::kNarrow;
    const auto narrow = start_state_bytes(start.state, start.parameters);
    EXPECT_EQ(narrow.size() + sizeof(double), wide.size());
    EXPECT_EQ(narrow[3], std::byte{'3'});
    EXPECT_EQ(wide[3], std::byte{'4'});
    const auto copy = start_from_bytes(narrow, 1000.0);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy->parameters.studio.manner, clay::studio::Manner::kNarrow);
    EXPECT_TRUE(start_state_bytes(copy->state, copy->parameters) == narrow);
    EXPECT_EQ(start_from_bytes(wide, 1000.0)->parameters.studio.manner, clay::studio::Manner::kWide);
    auto unknown = wide;
    unknown[4 + 31 * 8 + 7] = std::byte{0x41};
    const auto refused = start_from_bytes(unknown, 1000.0);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("manner of the hands: expected 2"), std::string::npos)
        << refused.error().message;
}

TEST(RejectsStudioStartState, ThatNoTickCouldHaveLeft) {
    const Start original = a_studio_start();
    const auto bytes = start_state_bytes(original.state, original.parameters);
    const auto refusal = [&](std::size_t offset, std::uint8_t byte) {
        auto damaged = bytes;
        damaged[offset] = static_cast<std::byte>(byte);
        const auto start = start_from_bytes(damaged, 1000.0);
        return start ? std::string("accepted") : start.error().message;
    };
    EXPECT_NE(refusal(0, 'X').find("tag"), std::string::npos);
    EXPECT_NE(refusal(4 + 7, 0xff).find("flow time"), std::string::npos) << refusal(4 + 7, 0xff);
    constexpr std::size_t kFirstSwitchAt = 4 + 28 * 8;
    EXPECT_NE(refusal(kFirstSwitchAt + 7, 0x40).find("switch: expected 0 or 1, found "), std::string::npos)
        << refusal(kFirstSwitchAt + 7, 0x40);
    constexpr std::size_t kToolBytes = 112;
    const std::size_t tool_at = bytes.size() - original.state.studio()->start_state().size() - 8 - kToolBytes;
    EXPECT_NE(refusal(tool_at + 7, 0x7f).find("tool"), std::string::npos) << refusal(tool_at + 7, 0x7f);
    EXPECT_NE(refusal(tool_at + kToolBytes - 1, 2).find("tool: expected pressing of 0 to 1, found 2"),
              std::string::npos);
    EXPECT_NE(refusal(tool_at + kToolBytes + 8, 'X').find("studio clay start state, tag"), std::string::npos);
    for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{200}, bytes.size() - 1}) {
        EXPECT_FALSE(start_from_bytes(std::span(bytes).first(size), 1000.0)) << size;
    }
    auto longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(start_from_bytes(longer, 1000.0));
}

class DamagedStartState : public testing::Test {
  protected:
    // The line with which it is refused when these bytes are put at this offset.
    template <typename T>
    std::string refusal(std::size_t offset, T number) const {
        auto bytes = bytes_;
        std::memcpy(bytes.data() + offset, &number, sizeof number);
        return refusal(bytes);
    }
    static std::string refusal(std::span<const std::byte> bytes, double rate_hz = 1000.0) {
        const auto start = start_from_bytes(bytes, rate_hz);
        if (start) return "accepted";
        EXPECT_EQ(start.error().kind, ErrorKind::kBadInput);
        EXPECT_EQ(start.error().message.find('\n'), std::string::npos);
        return start.error().message;
    }

    std::vector<std::byte> bytes_ = [] {
        const Start start = a_start();
        return start_state_bytes(start.state, start.parameters);
    }();
};

TEST_F(DamagedStartState, IsRefusedAtEveryLengthButItsOwn) {
    for (std::size_t size = 0; size < bytes_.size(); ++size) {
        EXPECT_NE(refusal(std::span(bytes_).first(size)), "accepted") << size;
    }
    auto longer = bytes_;
    longer.push_back(std::byte{0});
    EXPECT_NE(refusal(longer), "accepted");
    EXPECT_NE(refusal({}).find("expected at least"), std::string::npos);
}

TEST_F(DamagedStartState, IsRefusedWithItsFault) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal(0, std::uint32_t{1}).find("start state, tag"), std::string::npos);
    EXPECT_NE(refusal(4, 0.1).find("c1"), std::string::npos);
    EXPECT_NE(refusal(4, nan).find("c1"), std::string::npos);
    EXPECT_NE(refusal(12, -1.0).find("c2"), std::string::npos);
    EXPECT_NE(refusal(44, 1e9).find("wheel speed"), std::string::npos);
    EXPECT_NE(refusal(60, 2.0).find("wheel direction"), std::string::npos);
    EXPECT_NE(refusal(60, nan).find("wheel direction"), std::string::npos);
    EXPECT_NE(refusal(76, 1000.5).find("start state, tool"), std::string::npos);
    EXPECT_NE(refusal(84, nan).find("start state, tool"), std::string::npos);
    EXPECT_NE(refusal(100, 41.0).find("start state, tool"), std::string::npos);
    EXPECT_NE(refusal(108, std::uint32_t{2}).find("start state, button: expected 0 or 1, found 2"),
              std::string::npos);
    EXPECT_NE(refusal(bytes_, 99.0).find("rate"), std::string::npos);
    EXPECT_NE(refusal(bytes_, nan).find("rate"), std::string::npos);
}

}  // namespace
}  // namespace onggi::haptic
