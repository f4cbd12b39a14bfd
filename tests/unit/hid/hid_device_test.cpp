// A HID device as the haptic loop sees it, with its I/O thread running against a scripted device. Few tests;
// those without a thread are in hid_session_test.cpp.
#include "engine/haptics/hid/hid_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <thread>

#include "tests/support/comes_true.h"
#include "tests/support/pid_descriptors.h"
#include "tests/support/scripted_hid.h"

namespace onggi::haptics {
namespace {

using test::comes_true;

// A pedal that is down, behind a lock: the I/O thread reads while the test looks on.
class LockedPort final : public hid::HidPort {
  public:
    explicit LockedPort(int& open_ports, std::mutex& mutex) : open_ports_(open_ports), mutex_(mutex) {
        const std::lock_guard lock(mutex_);
        ++open_ports_;
    }
    ~LockedPort() override {
        const std::lock_guard lock(mutex_);
        --open_ports_;
    }
    Result<std::size_t> read(std::span<std::uint8_t> report, int timeout_ms) override {
        if (timeout_ms == 0) return std::size_t{0};
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        report[0] = 0x02;
        report[1] = 0x00;
        return std::size_t{2};
    }
    Result<void> write(std::span<const std::uint8_t>) override { return {}; }
    Result<void> set_feature(std::span<const std::uint8_t>) override { return {}; }
    Result<std::size_t> get_feature(std::span<std::uint8_t>) override { return failed("none"); }
    bool is_there() override { return true; }
    void pause_ms(int) override {}

  private:
    int& open_ports_;
    std::mutex& mutex_;
};

class LockedBus final : public hid::HidBus {
  public:
    LockedBus(int& open_ports, std::mutex& mutex) : open_ports_(open_ports), mutex_(mutex) {}
    Result<std::vector<HidDeviceInfo>> list() override {
        return std::vector<HidDeviceInfo>{
            {.path = "/dev/hidraw9", .may_open = true, .kind = HidKind::kVecPedal}};
    }
    Result<std::unique_ptr<hid::HidPort>> open(const HidDeviceInfo&) override {
        return std::unique_ptr<hid::HidPort>(std::make_unique<LockedPort>(open_ports_, mutex_));
    }

  private:
    int& open_ports_;
    std::mutex& mutex_;
};

class HidDeviceTest : public ::testing::Test {
  protected:
    int open_ports() {
        const std::lock_guard lock(mutex_);
        return open_ports_;
    }

    int open_ports_ = 0;
    std::mutex mutex_;
    HidDevice pedal{{.kind = HidKind::kVecPedal}, std::make_unique<LockedBus>(open_ports_, mutex_)};
};

TEST_F(HidDeviceTest, IsHeardThroughItsThreadAndClosedWithIt) {
    std::uint64_t tick = 0;
    EXPECT_FALSE(pedal.read(tick++, 0.001).button);
    ASSERT_TRUE(pedal.open());
    EXPECT_TRUE(comes_true([&] { return pedal.read(tick++, 0.0).button; }));
    EXPECT_EQ(open_ports(), 1);
    pedal.write({1.0, 2.0, 3.0});
    pedal.close();
    EXPECT_EQ(open_ports(), 0);
    EXPECT_FALSE(pedal.read(tick++, 0.001).button) << "closed, it holds nothing";
    pedal.close();
    ASSERT_TRUE(pedal.open()) << "and can be opened again";
    EXPECT_TRUE(comes_true([&] { return pedal.read(tick++, 0.0).button; }));
    EXPECT_EQ(pedal.status().times_found, 2U);
}

TEST_F(HidDeviceTest, IsClosedWhenItGoesOutOfScope) {
    {
        HidDevice another({.kind = HidKind::kVecPedal}, std::make_unique<LockedBus>(open_ports_, mutex_));
        ASSERT_TRUE(another.open());
        EXPECT_TRUE(comes_true([&] { return open_ports() == 1; }));
    }
    EXPECT_EQ(open_ports(), 0);
}

TEST(HidDeviceOfAJoystick, SaysThatItShowsAWallOnceItIsPluggedInAndDoes) {
    auto script = std::make_shared<testing::ScriptedHid>();
    script->info = {.path = "/dev/hidraw9", .may_open = true, .kind = HidKind::kForceJoystick};
    script->info.report_descriptor = testing::open_ffboard_descriptor();
    for (const char* answer : {"12 01 01 00 01", "12 02 01 00 01", "12 03 01 00 01", "12 04 01 00 01"})
        script->features[0x12].push_back(testing::hex(answer));
    HidDevice stick({.kind = HidKind::kForceJoystick}, std::make_unique<testing::ScriptedBus>(script));
    (void)stick.read(0, 0.001);
    EXPECT_FALSE(stick.signs().shows_wall);
    ASSERT_TRUE(stick.open());
    std::uint64_t tick = 1;
    EXPECT_TRUE(comes_true([&] {
        (void)stick.read(tick++, 0.0);
        return stick.signs().shows_wall;
    }));
    stick.close();
    EXPECT_EQ(stick.capabilities().wire_rate_hz, 250.0);
}

TEST(MakeHidDevice, MakesOneOfEachKindButTheUnknown) {
    for (const HidKind kind :
         {HidKind::kForceJoystick, HidKind::kSpaceMouse, HidKind::kDualSense, HidKind::kVecPedal}) {
        const auto device = make_hid_device({.kind = kind});
        ASSERT_NE(device, nullptr);
        EXPECT_EQ(device->kind(), kind);
        EXPECT_FALSE(device->capabilities().name.empty());
        EXPECT_LE(device->capabilities().peak_force_n, 3.3);
    }
    EXPECT_EQ(make_hid_device({}), nullptr);
    EXPECT_EQ(make_hid_device({.kind = HidKind::kForceJoystick})->capabilities().force_axes, 2);
    EXPECT_EQ(make_hid_device({.kind = HidKind::kSpaceMouse})->capabilities().force_axes, 0);
    // A trigger gets a resistance, not a force; a device without motors renders no wall.
    EXPECT_TRUE(make_hid_device({.kind = HidKind::kDualSense})->capabilities().has_own_walls);
    EXPECT_EQ(make_hid_device({.kind = HidKind::kDualSense})->capabilities().wire_rate_hz, 0.0);
    EXPECT_FALSE(make_hid_device({.kind = HidKind::kSpaceMouse})->capabilities().has_own_walls);
}

}  // namespace
}  // namespace onggi::haptics
