// The Inverse3 end to end: the device, its thread, libwebsockets, and a service on loopback.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "engine/haptics/haply/inverse_device.h"
#include "tests/support/comes_true.h"
#include "tests/support/held_port.h"
#include "tests/unit/haply/fake_service.h"

namespace onggi::haptics {
namespace {

using State = hid::HidStatus::State;
using testing::FakeService;

class InverseDeviceTest : public ::testing::Test {
  protected:
    // Runs the loop until the condition holds. If the machine delays the loop beyond the gate's timeout, the
    // gate stays shut until the force has been small: then the tool leaves the clay until it opens.
    template <typename Condition>
    bool comes_true(InverseDevice& device, Condition condition, const dvec3& force_n = dvec3(0.0)) {
        return test::comes_true([&] {
            tool_ = device.read(tick_++, 0.001);
            device.write(device.signs().force_fraction > 0.0 ? force_n : dvec3(0.0));
            return condition();
        });
    }

    HandSample tool_;
    std::uint64_t tick_ = 0;
};

TEST_F(InverseDeviceTest, IsFoundMovesTheToolAndFeelsThreeAxes) {
    FakeService service;
    InverseDevice device({.port = service.port()});
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(comes_true(device, [&] { return device.is_here(); })) << device.status().message;
    EXPECT_EQ(device.status().state, State::kReady);
    const dvec3 start = tool_.position_mm;
    service.put_cursor_m({0.02, -0.1, 0.13});
    EXPECT_TRUE(comes_true(
        device, [&] { return glm::length(tool_.position_mm - start - dvec3(20.0, 30.0, 0.0)) < 1e-6; }));
    const auto hears = [&](std::string_view text) {
        return [&service, text] { return service.last_heard().find(text) != std::string::npos; };
    };
    EXPECT_TRUE(comes_true(device, hears(R"("vector":{"x":1.0000,"y":-0.5000,"z":2.0000})"), {1.0, 2.0, 0.5}))
        << service.last_heard();
    const int before = service.times_heard();
    EXPECT_TRUE(comes_true(device, [&] { return service.times_heard() > before + 100; }));
    device.close();
    EXPECT_TRUE(comes_true(device, hears(R"("vector":{"x":0.0000,"y":0.0000,"z":0.0000})")))
        << "left without force: " << service.last_heard();
    EXPECT_EQ(device.capabilities().force_axes, 3);
}

TEST_F(InverseDeviceTest, TellsOfEachReadWhetherAMessageCame) {
    FakeService service;
    InverseDevice device({.port = service.port()});
    EXPECT_FALSE(device.signs().hand_is_there);
    EXPECT_FALSE(device.signs().position_is_new);
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(comes_true(device, [&] { return device.is_here(); }));
    EXPECT_TRUE(device.signs().hand_is_there);
    int fresh = 0;
    ASSERT_TRUE(comes_true(device, [&] { return (fresh += device.signs().position_is_new ? 1 : 0) > 100; }));
    service.be_silent(true);
    // Messages already sent still arrive.
    ASSERT_TRUE(comes_true(device, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        (void)device.read(tick_++, 0.0);
        return !device.signs().position_is_new;
    }));
    for (int tick = 0; tick < 40; ++tick) {
        (void)device.read(tick_++, 0.001);
        EXPECT_FALSE(device.signs().position_is_new) << tick;
    }
    EXPECT_TRUE(device.signs().hand_is_there) << "40 ms";
    for (int tick = 0; tick < 20; ++tick)
        (void)device.read(tick_++, 0.001);
    EXPECT_FALSE(device.signs().hand_is_there) << "60 ms";
    EXPECT_EQ(device.capabilities().report_rate_hz, 1000.0);
}

TEST_F(InverseDeviceTest, LetsGoWhenTheWatchdogAsksAlthoughItsOrdersGoOn) {
    FakeService service;
    InverseDevice device({.port = service.port()});
    ASSERT_TRUE(device.open());
    const auto hears = [&](std::string_view text) {
        return service.last_heard().find(text) != std::string::npos;
    };
    ASSERT_TRUE(comes_true(device, [&] { return hears(R"("x":1.0000)"); }, {1.0, 0.0, 0.0}));
    device.silence();
    EXPECT_TRUE(test::comes_true([&] {
        (void)device.read(tick_++, 0.001);
        device.write({1.0, 0.0, 0.0});
        return hears("probe_position");
    })) << service.last_heard();
}

TEST_F(InverseDeviceTest, ComesAndGoesWithItsService) {
    const test::HeldPort port;
    auto service = std::make_unique<FakeService>(port.number());
    InverseDevice device({.port = port.number()});
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(comes_true(device, [&] { return device.is_here(); }));
    const dvec3 left_at = tool_.position_mm;
    service.reset();
    ASSERT_TRUE(comes_true(device, [&] { return !device.is_here(); }));
    EXPECT_EQ(tool_.position_mm, left_at);
    service = std::make_unique<FakeService>(port.number());
    service->put_cursor_m({0.1, 0.0, 0.0});
    ASSERT_TRUE(comes_true(device, [&] { return device.is_here(); }));
    EXPECT_NEAR(glm::length(tool_.position_mm - left_at), 0.0, 1e-9) << "and goes on from where it was left";
    EXPECT_EQ(device.status().times_found, 2U);
}

TEST_F(InverseDeviceTest, RejectsAServiceThatSpeaksNonsenseWithOneLineAndTriesAgain) {
    FakeService service;
    service.say("<html>not here</html>");
    InverseDevice device({.port = service.port()});
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(comes_true(device, [&] { return device.status().state == State::kFailed; }));
    EXPECT_EQ(device.status().message,
              "not a message of the Inverse service: byte 0: expected JSON, found byte 0x3c");
    EXPECT_FALSE(device.is_here());
    service.say(std::string(100'000, ' '));
    ASSERT_TRUE(comes_true(device, [&] {
        return device.status().message.starts_with("expected messages of at most");
    })) << device.status().message;
    service.say("");
    EXPECT_TRUE(comes_true(device, [&] { return device.is_here(); })) << "the service has come to its senses";
}

TEST_F(InverseDeviceTest, IsAbsentWithoutAService) {
    const test::HeldPort port;
    InverseDevice device({.port = port.number()});
    ASSERT_TRUE(device.open());
    EXPECT_FALSE(device.read(0, 0.001).button);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(device.status().state, State::kAbsent);
    EXPECT_EQ(device.status().message, "");
    device.close();
}

}  // namespace
}  // namespace onggi::haptics
