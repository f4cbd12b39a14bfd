#include "game/haptic/tool_device.h"

#include <gtest/gtest.h>

#include "game/haptic/simulated_device.h"
#include "tests/unit/record/recordings.h"

namespace onggi::haptic {
namespace {

TEST(GesturePlayer, ReadsTickKAtExactlyKOverTheRate) {
    std::string text(tool::kGestureHeader);
    text += "\n0,0,0,0,0,10\n1,1000,0,0,0,10\n";
    const auto gesture = tool::parse_gesture(text, "g.csv");
    ASSERT_TRUE(gesture);
    GesturePlayer player(*gesture, 1000.0);
    ASSERT_TRUE(player.open());
    for (const std::uint64_t tick : {0U, 1U, 3U, 333U, 999U, 1000U, 5000U})
        EXPECT_EQ(player.read_tool(tick, 0.001), gesture->at(static_cast<double>(tick) / 1000.0));
    EXPECT_EQ(player.capabilities().force_axes, 0);
}

TEST(SessionPlayer, PlaysTheRecordedTools) {
    auto session = record::parse_session(record::session_bytes(1500), "s.onggi");
    ASSERT_TRUE(session);
    SessionPlayer player(std::move(session).value());
    ASSERT_TRUE(player.open());
    for (std::uint64_t tick = 0; tick < 1500; ++tick)
        ASSERT_EQ(player.read_tool(tick, 1.0 / 4000.0), record::tool_at(tick));
    EXPECT_EQ(player.capabilities().force_axes, 0);
}

// A stick at one place, whose button is down.
class Stick final : public haptics::HapticDevice {
  public:
    static constexpr dvec3 kPlaceMm{70.0, 60.0, 0.0};

    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override { return {.name = "stick"}; }
    [[nodiscard]] haptics::HandSample read(std::uint64_t, double) noexcept override {
        return {.position_mm = kPlaceMm, .button = true, .rev_min = 90.0};
    }
    void write(const dvec3& /*force_n*/) noexcept override {}
};

TEST(ToolDevices, LeaveNoSecondFingerInTheClayOfADevice) {
    auto mouse = std::make_unique<SimulatedDevice>();
    const SimulatedDevice& first = *mouse;
    tool::ToolState fingers{.position_mm = {100.0, 50.0, 0.0}, .guided = true};
    fingers.second = {.present = true, .position_mm = {-100.0, 50.0, 0.0}};
    mouse->set_target(fingers);
    ASSERT_TRUE(mouse->open());
    EXPECT_TRUE(tool::moved_by(mouse->read(0, 0.001), first.last_tool()).second.present);
    EXPECT_FALSE(tool::moved_by({.position_mm = Stick::kPlaceMm}, first.last_tool()).second.present)
        << "it would be a ball in the wall";
}

TEST(ToolDevices, MoveTheToolThatTheFirstOfThemKnows) {
    auto mouse = std::make_unique<SimulatedDevice>();
    const SimulatedDevice& first = *mouse;
    mouse->set_target({.position_mm = {100.0, 50.0, 0.0},
                       .radius_mm = 14.0,
                       .tool = tool::Tool::kSponge,
                       .water = 0.5,
                       .guided = true,
                       .pressing = false});
    std::vector<std::unique_ptr<haptics::HapticDevice>> devices;
    devices.push_back(std::move(mouse));
    devices.push_back(std::make_unique<Stick>());
    ToolDevices tools(std::make_unique<haptics::DeviceGroup>(std::move(devices)), first);
    ASSERT_TRUE(tools.all().open());
    tool::ToolState tool;
    for (std::uint64_t tick = 0; tick < 2000; ++tick)
        tool = tools.read(tick, 0.001);
    EXPECT_EQ(tool, (tool::ToolState{.position_mm = Stick::kPlaceMm,
                                     .radius_mm = 14.0,
                                     .wheel_button = true,
                                     .tool = tool::Tool::kSponge,
                                     .water = 0.5,
                                     .wheel_speed_rev_min = 90.0}));
}

}  // namespace
}  // namespace onggi::haptic
