// A fault during throwing: the message to the visitor, the retry, and that a mouse keeps working.
#include "game/app/kiosk/visit/visit_wheel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "engine/haptics/device_group.h"
#include "game/haptic/job.h"
#include "game/haptic/simulated_device.h"

namespace onggi::app {
namespace {

using haptics::Fault;

TEST(KioskFault, LetsTheVisitorGoOnAndTriesAgainAfterEachRest) {
    for (const Fault fault : {Fault::kPositionNotFinite, Fault::kOutsideWorkspace, Fault::kInputNotSound,
                              Fault::kEnergyGenerated}) {
        KioskFault kiosk;
        EXPECT_FALSE(kiosk.look(Fault::kNone, 0.0).force_rests);
        int tries = 0;
        for (double now_s = 10.0; now_s < 10.0 + 2.5 * KioskFault::kRestS; now_s += 0.1) {
            const KioskFault::Advice advice = kiosk.look(fault, now_s);
            EXPECT_TRUE(advice.force_rests);
            EXPECT_FALSE(advice.wheel_rests);
            tries += advice.take_back ? 1 : 0;
            if (now_s < 10.0 + KioskFault::kRestS - 0.05) {
                EXPECT_EQ(tries, 0) << "a fault is no flicker";
            }
        }
        EXPECT_EQ(tries, 2);
        EXPECT_FALSE(kiosk.look(Fault::kNone, 30.0).force_rests);
        EXPECT_FALSE(kiosk.look(fault, 30.1).take_back) << "a new fault has a rest of its own";
    }
}

TEST(KioskFault, EndsTheVisitOnlyWhereTheClayHasLostItsSenses) {
    KioskFault kiosk;
    EXPECT_TRUE(kiosk.look(Fault::kForceNotFinite, 1.0).wheel_rests);
    EXPECT_TRUE(kiosk.look(Fault::kForceNotFinite, 1.0 + KioskFault::kRestS).take_back);
}

TEST(KioskFault, NeverTakesAPersonsStopBackByAClock) {
    KioskFault kiosk;
    for (double now_s = 0.0; now_s < 600.0; now_s += 1.0) {
        const KioskFault::Advice advice = kiosk.look(Fault::kStopped, now_s);
        EXPECT_TRUE(advice.force_rests);
        EXPECT_FALSE(advice.take_back);
    }
}

// A force-feedback device and its state.
struct Stick {
    dvec3 position_mm{95.0, 100.0, 0.0};
    bool is_here = true;
    bool is_moving = false;
    double felt_n = 0.0;
};

class StickDevice final : public haptics::HapticDevice {
  public:
    explicit StickDevice(Stick& stick) : stick_(stick) {}
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override {
        return {.name = "stick", .force_axes = 3, .peak_force_n = 3.0, .continuous_force_n = 3.0};
    }
    [[nodiscard]] haptics::HandSample read(std::uint64_t, double) noexcept override {
        return {.position_mm = stick_.position_mm};
    }
    void write(const dvec3& force_n) noexcept override {
        stick_.felt_n = std::sqrt(glm::dot(force_n, force_n));
    }
    [[nodiscard]] bool is_here() const noexcept override { return stick_.is_here; }
    [[nodiscard]] bool is_moving() const noexcept override { return stick_.is_moving; }
    void take_over(const dvec3&) noexcept override {}

  private:
    Stick& stick_;
};

constexpr dvec3 kAside(110.0, 100.0, 0.0);
constexpr double kInwardsMmS = 10.0;  // which keeps a tool about a mm deep in the clay

// The haptic loop with a mouse and a stick, on a virtual clock, watched by the kiosk at 50 Hz.
class MouseAndStick {
  public:
    MouseAndStick() {
        auto own_mouse = std::make_unique<haptic::SimulatedDevice>();
        mouse_ = own_mouse.get();
        hold_mouse(kAside);
        std::vector<std::unique_ptr<haptics::HapticDevice>> devices;
        devices.push_back(std::move(own_mouse));
        devices.push_back(std::make_unique<StickDevice>(stick));
        haptic::HapticParameters parameters;
        parameters.set_rate_hz(1000.0);
        work_ = std::make_unique<haptic::HapticWork>(
            haptic::HapticState(), parameters,
            haptic::ToolDevices(std::make_unique<haptics::DeviceGroup>(std::move(devices)), *mouse_),
            haptic::HapticJobOptions{});
    }

    void hold_mouse(const dvec3& place_mm) {
        mouse_->set_target({.position_mm = place_mm, .wheel_button = true});
    }
    void run(double seconds) {
        run(seconds, [] {});
    }
    // Moves the mouse inwards from from_x_mm for `seconds`.
    void press_with_the_mouse(double from_x_mm, double seconds) {
        double x_mm = from_x_mm;
        run(seconds, [&] {
            x_mm -= 0.001 * kInwardsMmS;
            hold_mouse({x_mm, 100.0, 0.0});
        });
    }
    // The stick holds the tool and feels the clay.
    void throw_with_the_stick() {
        stick.is_moving = true;
        run(2.5);
        run(3.5, [&] { stick.position_mm.x -= 0.001 * kInwardsMmS; });  // from 95 to 60 mm
        ASSERT_GT(stick.felt_n, 0.05);
    }
    [[nodiscard]] double clay_mm3() const { return work_->state().volume_mm3(); }
    [[nodiscard]] int contacts() { return work_->newest_snapshot().result.forces.contacts; }
    [[nodiscard]] double felt_n() {
        const dvec3& force_n = work_->newest_snapshot().result.limited_force_n;
        return std::sqrt(glm::dot(force_n, force_n));
    }

    Stick stick;
    KioskFault::Advice advice;
    int rests = 0;  // how often the visitor was told that the force is off
    int tries = 0;

  private:
    template <typename Each>
    void run(double seconds, const Each& each) {
        for (int k = 0; k < static_cast<int>(seconds * 1000.0 + 0.5); ++k) {
            each();
            ASSERT_TRUE(work_->tick(period_));
            ++period_.index;
            ++period_.tick;
            haptic::TickRecord record;
            while (work_->take_record(record)) {
            }
            if (period_.index % 20 != 0) continue;
            const bool rested = advice.force_rests;
            advice = fault_.look(work_->newest_snapshot().fault, 0.001 * static_cast<double>(period_.index));
            rests += advice.force_rests && !rested ? 1 : 0;
            tries += advice.take_back ? 1 : 0;
            if (advice.take_back) {
                EXPECT_TRUE(work_->send(haptic::Command::kRearmForce));
            }
        }
    }

    haptic::SimulatedDevice* mouse_ = nullptr;
    std::unique_ptr<haptic::HapticWork> work_;
    jobs::Period period_{.dt_s = 0.001};
    KioskFault fault_;
};

TEST(AFaultWhileSomebodyThrows, LeavesTheMouseItsClayAndGivesTheForceBackAfterARest) {
    MouseAndStick wheel;
    wheel.throw_with_the_stick();
    wheel.stick.position_mm.x = std::numeric_limits<double>::quiet_NaN();  // and keeps moving
    wheel.run(0.1);
    EXPECT_TRUE(wheel.advice.force_rests) << "the visitor is told";
    EXPECT_EQ(wheel.stick.felt_n, 0.0);
    const double before_mm3 = wheel.clay_mm3();
    wheel.press_with_the_mouse(70.0, 2.0);
    EXPECT_LT(wheel.clay_mm3(), before_mm3 - 100.0) << "the mouse throws on";
    EXPECT_GT(wheel.contacts(), 0);
    EXPECT_EQ(wheel.felt_n(), 0.0) << "without force as yet";
    wheel.hold_mouse(kAside);
    wheel.run(KioskFault::kRestS);
    EXPECT_EQ(wheel.tries, 1);
    EXPECT_FALSE(wheel.advice.force_rests) << "it went well: the stick has not the tool any more";
    wheel.press_with_the_mouse(70.0, 3.5);
    EXPECT_GT(wheel.felt_n(), 0.05) << "the mouse is pushed back again";
    EXPECT_EQ(wheel.stick.felt_n, 0.0);
}

TEST(AFaultWhileSomebodyThrows, ThatRepeatsIsClearedAgainWithoutAForce) {
    MouseAndStick wheel;
    wheel.throw_with_the_stick();
    for (int time = 1; time <= 3; ++time) {
        wheel.stick.position_mm = {60.0, 5000.0, 0.0};
        wheel.run(KioskFault::kRestS + 1.0);
        EXPECT_EQ(wheel.rests, time);
        EXPECT_EQ(wheel.tries, time);
        EXPECT_FALSE(wheel.advice.force_rests);
        EXPECT_EQ(wheel.stick.felt_n, 0.0);
        wheel.stick.position_mm = {95.0, 100.0, 0.0};  // valid again: it gets the tool
        wheel.run(1.0);
    }
}

TEST(ADeviceThatIsLostWhileItThrows, LeavesTheClayAndTheMouseThrowsOn) {
    MouseAndStick wheel;
    wheel.throw_with_the_stick();
    EXPECT_GT(wheel.contacts(), 0);
    wheel.stick.is_here = wheel.stick.is_moving = false;
    wheel.run(0.02);
    EXPECT_EQ(wheel.stick.felt_n, 0.0) << "without a hand no force is announced";
    wheel.run(1.5);
    EXPECT_EQ(wheel.contacts(), 0) << "the tool is taken out of the clay";
    EXPECT_EQ(wheel.rests, 0) << "a pulled plug is no fault";
    const double before_mm3 = wheel.clay_mm3();
    wheel.press_with_the_mouse(70.0, 3.0);
    EXPECT_LT(wheel.clay_mm3(), before_mm3 - 100.0);
    EXPECT_GT(wheel.felt_n(), 0.05) << "and feels it";
}

}  // namespace
}  // namespace onggi::app
