#include "game/haptic/start_state.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>

namespace onggi::haptic {
namespace {

haptics::ToolState tool_at(std::uint64_t tick) {
    const double t = static_cast<double>(tick) / 1000.0;
    return {.position_mm = {75.0 - 10.0 * t, 60.0 + 50.0 * t, 3.0},
            .radius_mm = 9.0,
            .wheel_button = tick % 200 < 150};
}

// A lump somewhere in the middle of being thrown, with parameters of its own.
Start a_start() {
    Start start{HapticState(clay::PaperClay({.element_count = 150})), {}};
    start.parameters.clay.rate_hz = 1000.0;
    start.parameters.clay.softness_c1_per_mm = 12.0;
    start.parameters.clay.wheel_speed_rad_s = 7.0;
    for (std::uint64_t tick = 0; tick < 777; ++tick)
        haptic::tick(start.state, tool_at(tick), start.parameters);
    return start;
}

TEST(StartState, GoesOnAsIfNothingHadHappened) {
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
    EXPECT_EQ(copy->parameters.clay.rate_hz, 4000.0);
    EXPECT_TRUE(start_state_bytes(copy->state, copy->parameters) == bytes);
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

TEST_F(DamagedStartState, IsRefusedWithWhatIsWrong) {
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
    EXPECT_NE(refusal(108, std::uint32_t{2}).find("start state, button"), std::string::npos);
    EXPECT_NE(refusal(bytes_, 99.0).find("rate"), std::string::npos);
    EXPECT_NE(refusal(bytes_, nan).find("rate"), std::string::npos);
}

}  // namespace
}  // namespace onggi::haptic
