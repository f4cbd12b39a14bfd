// Several devices at one wheel: which one holds the tool, how it changes, and which one feels the clay.
#include "engine/haptics/device_group.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace onggi::haptics {
namespace {

constexpr double kStep = 0.001;

// The test's control of a hand.
struct Puppet {
    HandSample sample;
    DeviceCapabilities can{.name = "puppet"};
    bool is_here = true;
    bool is_moving = false;
    std::optional<bool> lives = std::nullopt;  // none: while it moves
    bool never_rests = false;
    bool fails_to_open = false;
    int opened = 0;
    int closed = 0;
    dvec3 force_n{0.0};
    WorkFelt felt;
    std::optional<dvec3> took_over_mm = std::nullopt;
};

class PuppetDevice final : public HapticDevice {
  public:
    explicit PuppetDevice(Puppet& puppet) : puppet_(puppet) {}
    Result<void> open() override {
        ++puppet_.opened;
        if (puppet_.fails_to_open) return failed("stuck");
        return {};
    }
    void close() noexcept override { ++puppet_.closed; }
    [[nodiscard]] DeviceCapabilities capabilities() const override { return puppet_.can; }
    [[nodiscard]] HandSample read(std::uint64_t, double) noexcept override { return puppet_.sample; }
    void write(const dvec3& force_n) noexcept override { puppet_.force_n = force_n; }
    void feel(const WorkFelt& work) noexcept override { puppet_.felt = work; }
    [[nodiscard]] bool is_here() const noexcept override { return puppet_.is_here; }
    [[nodiscard]] bool is_moving() const noexcept override { return puppet_.is_moving; }
    [[nodiscard]] bool lives() const noexcept override { return puppet_.lives.value_or(puppet_.is_moving); }
    [[nodiscard]] bool never_rests() const noexcept override { return puppet_.never_rests; }
    void take_over(const dvec3& position_mm) noexcept override { puppet_.took_over_mm = position_mm; }

  private:
    Puppet& puppet_;
};

class DeviceGroupTest : public ::testing::Test {
  protected:
    explicit DeviceGroupTest(const DeviceGroupOptions& options = {}) {
        mouse_.can = {.name = "mouse",
                      .force_axes = 3,
                      .peak_force_n = 3.3,
                      .continuous_force_n = 3.3,
                      .max_stiffness_n_per_mm = 0.5,
                      .has_motors = false};
        stick_.can = {.name = "stick",
                      .force_axes = 2,
                      .peak_force_n = 3.0,
                      .continuous_force_n = 3.0,
                      .max_stiffness_n_per_mm = 0.3};
        group_ = make(options);
        mouse_.sample = {.position_mm = {100.0, 50.0, 0.0}};
        stick_.sample = {.position_mm = {70.0, 60.0, 0.0}};
        pad_.is_here = false;
    }
    std::unique_ptr<DeviceGroup> make(const DeviceGroupOptions& options) {
        std::vector<std::unique_ptr<HapticDevice>> devices;
        for (Puppet* puppet : {&mouse_, &pad_, &stick_})
            devices.push_back(std::make_unique<PuppetDevice>(*puppet));
        return std::make_unique<DeviceGroup>(std::move(devices), options);
    }
    HandSample after(double seconds, const dvec3& force_n = dvec3(0.0)) {
        HandSample sample;
        for (int step = 0; step < static_cast<int>(seconds / kStep + 0.5); ++step) {
            sample = group_->read(tick_++, kStep);
            group_->write(force_n);
        }
        return sample;
    }

    Puppet mouse_;
    Puppet pad_;
    Puppet stick_;
    Puppet pedal_;
    std::unique_ptr<DeviceGroup> group_;
    std::uint64_t tick_ = 0;
};

TEST_F(DeviceGroupTest, CountsSignsOfLifeOfEveryHandButTheFirst) {
    after(0.1);
    EXPECT_EQ(group_->signs_of_life(), 0U);
    mouse_.is_moving = true;
    after(0.1);
    EXPECT_EQ(group_->signs_of_life(), 0U) << "the window tells of the mouse";
    stick_.is_moving = true;
    after(0.01);
    EXPECT_EQ(group_->signs_of_life(), 10U) << "though the mouse has the tool";
    stick_.is_here = false;
    after(0.01);
    EXPECT_EQ(group_->signs_of_life(), 10U);
}

TEST_F(DeviceGroupTest, TheFirstIsAloneWhileNoOtherDeviceIsPluggedIn) {
    after(0.1);
    EXPECT_FALSE(group_->signs().is_alone);
    stick_.is_here = false;
    after(kStep);
    EXPECT_TRUE(group_->signs().is_alone);
    pad_.is_here = true;
    pad_.sample.position_mm = {1e9, 0.0, 0.0};
    after(kStep);
    EXPECT_FALSE(group_->signs().is_alone) << "a device that reports nonsense may have motors";
}

TEST_F(DeviceGroupTest, TellsAHandThatHoldsAStickStillFromASignOfLife) {
    group_->add_pedal(std::make_unique<PuppetDevice>(pedal_));
    stick_.is_moving = true;
    stick_.lives = false;
    pedal_.sample.button = true;
    after(0.6);
    EXPECT_EQ(group_->holder(), 2U);
    EXPECT_EQ(group_->signs_of_life(), 0U) << "nor does a pedal that is down give one";
    pedal_.lives = true;
    after(0.01);
    EXPECT_EQ(group_->signs_of_life(), 10U) << "it is pressed";
}

TEST_F(DeviceGroupTest, SaysWhichDevicesDoNotRest) {
    group_->add_pedal(std::make_unique<PuppetDevice>(pedal_));
    after(kStep);
    EXPECT_EQ(group_->restless(), 0U);
    mouse_.never_rests = pad_.never_rests = stick_.never_rests = pedal_.never_rests = true;
    after(kStep);
    EXPECT_EQ(group_->restless(), 0b1100U) << "the window tells of the mouse, and the pad is not here";
    stick_.never_rests = false;
    after(kStep);
    EXPECT_EQ(group_->restless(), 0b1000U);
}

TEST_F(DeviceGroupTest, TheFirstHasTheToolUntilAnotherMoves) {
    EXPECT_EQ(after(1.0).position_mm, mouse_.sample.position_mm);
    EXPECT_EQ(group_->holder(), 0U);
    stick_.is_moving = true;
    EXPECT_EQ(after(1.0).position_mm, stick_.sample.position_mm);
    EXPECT_EQ(group_->holder(), 2U);
    stick_.is_moving = false;
    EXPECT_EQ(after(5.0).position_mm, stick_.sample.position_mm) << "held still, it is still held";
}

TEST_F(DeviceGroupTest, AWorkingHandKeepsTheTool) {
    stick_.is_moving = true;
    after(1.0);
    mouse_.is_moving = true;
    after(2.0);
    EXPECT_EQ(group_->holder(), 2U);
    stick_.is_moving = false;
    after(0.4);
    EXPECT_EQ(group_->holder(), 2U);
    after(0.2);
    EXPECT_EQ(group_->holder(), 0U);
}

TEST_F(DeviceGroupTest, AMovingDeviceTakesTheToolOfAnAbsentOne) {
    stick_.is_moving = true;
    after(1.0);
    stick_.is_here = false;
    stick_.sample.button = true;
    EXPECT_EQ(after(0.3).position_mm, stick_.sample.position_mm) << "the tool stays where it was left";
    EXPECT_FALSE(after(kStep).button) << "and what a gone hand pressed counts for nothing";
    mouse_.is_moving = true;
    after(kStep);
    EXPECT_EQ(group_->holder(), 0U);
}

TEST_F(DeviceGroupTest, TheToolLeavesTheClayWhenTheHandThatHeldItIsGoneForGood) {
    stick_.is_moving = true;
    after(1.0);
    stick_.is_here = false;
    after(0.4);
    EXPECT_EQ(group_->holder(), 2U) << "a loose plug is back in a moment";
    after(0.2);
    EXPECT_EQ(group_->holder(), 0U) << "the visitor need not know that the mouse must be moved";
    EXPECT_EQ(after(0.2).position_mm, mouse_.sample.position_mm);
    stick_.is_here = true;
    after(kStep);
    EXPECT_EQ(group_->holder(), 0U) << "until it is moved";
}

TEST_F(DeviceGroupTest, OneThatSaysNonsenseLosesTheToolAndGetsItBackBySense) {
    const dvec3 sense_mm = stick_.sample.position_mm;
    for (const dvec3& nonsense_mm :
         {dvec3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), dvec3(0.0, 2000.0, 0.0)}) {
        stick_.is_moving = true;  // and never stops trembling
        after(1.0);
        ASSERT_EQ(group_->holder(), 2U);
        stick_.sample.position_mm = nonsense_mm;
        const HandSample said = after(kStep);
        EXPECT_FALSE(said.position_mm == sense_mm) << "the gate has to see it";
        EXPECT_FALSE(group_->signs().hand_is_there);
        mouse_.is_moving = true;
        after(kStep);
        EXPECT_EQ(group_->holder(), 0U);
        EXPECT_EQ(after(1.0).position_mm, mouse_.sample.position_mm);
        mouse_.is_moving = false;
        stick_.sample.position_mm = sense_mm;
        after(1.0);
        EXPECT_EQ(group_->holder(), 2U);
    }
}

TEST_F(DeviceGroupTest, AnAbsentDeviceNeverGetsTheTool) {
    pad_.is_moving = true;
    after(2.0);
    EXPECT_EQ(group_->holder(), 0U);
    pad_.is_here = true;
    after(kStep);
    EXPECT_EQ(group_->holder(), 1U);
}

TEST_F(DeviceGroupTest, TheToolGoesFromHandToHandWithoutAJump) {
    after(1.0);
    stick_.is_moving = true;
    dvec3 last = mouse_.sample.position_mm;
    for (int step = 0; step < 200; ++step) {
        const dvec3 now = after(kStep).position_mm;
        EXPECT_LE(glm::length(now - last), 0.6 + 1e-9) << step;
        last = now;
    }
    EXPECT_EQ(last, stick_.sample.position_mm);
    stick_.sample.position_mm.x = 20.0;
    EXPECT_EQ(after(kStep).position_mm.x, 20.0) << "once there, it follows the hand wherever that goes";
    ASSERT_TRUE(stick_.took_over_mm);
    EXPECT_EQ(*stick_.took_over_mm, mouse_.sample.position_mm);
}

TEST_F(DeviceGroupTest, ADeviceThatComesInTheMidstOfATouchIsABallThatComesFromBeforeTheClay) {
    mouse_.sample = {.position_mm = {10.0, 40.0, 0.0}, .on_screen = true, .presses = true};
    mouse_.is_moving = true;
    const HandSample finger = after(1.0);
    EXPECT_TRUE(finger.on_screen && finger.presses);
    EXPECT_EQ(finger.position_mm, mouse_.sample.position_mm);
    mouse_.is_moving = false;
    stick_.is_moving = true;
    const HandSample first = after(0.5 + kStep);
    EXPECT_FALSE(first.on_screen) << "not a finger in the clay, for no tick";
    EXPECT_GT(first.position_mm.z, 150.0);
    ASSERT_TRUE(stick_.took_over_mm);
    EXPECT_EQ(*stick_.took_over_mm, dvec3(70.0, 60.0, 180.0)) << "at its own height and side";
    EXPECT_EQ(after(1.0).position_mm, stick_.sample.position_mm);
    // And back: a finger's position applies at once, without an approach.
    stick_.is_moving = false;
    mouse_.is_moving = true;
    mouse_.sample.presses = false;
    const HandSample back = after(0.5 + kStep);
    EXPECT_TRUE(back.on_screen);
    EXPECT_FALSE(back.presses);
    EXPECT_EQ(back.position_mm, mouse_.sample.position_mm);
}

TEST_F(DeviceGroupTest, EitherTurnsTheWheel) {
    stick_.is_moving = true;
    after(1.0);
    EXPECT_FALSE(after(kStep).button);
    mouse_.sample.button = true;
    EXPECT_TRUE(after(kStep).button) << "either turns the wheel";
    mouse_.sample.button = false;
    stick_.sample.button = true;
    EXPECT_TRUE(after(kStep).button);
}

TEST_F(DeviceGroupTest, OnlyTheHandWithTheToolFeelsTheClay) {
    const dvec3 push(2.0, 0.0, 0.0);
    after(0.1, push);
    EXPECT_EQ(mouse_.force_n, push) << "the first starts with the loop, whose own ramp is the start's";
    group_->feel({.touches = true, .wall_mm = 6.0});
    EXPECT_EQ(mouse_.felt.wall_mm, 6.0);
    EXPECT_EQ(stick_.force_n, dvec3(0.0));
    EXPECT_EQ(stick_.felt.wall_mm, 0.0);
}

TEST_F(DeviceGroupTest, AfterAChangeTheForceRampsUpFromZeroOnceItIsSmall) {
    const dvec3 push(2.0, 0.0, 0.0);
    stick_.is_moving = true;
    after(1.0, push);
    after(3.0, push);
    EXPECT_EQ(stick_.force_n, dvec3(0.0)) << "taken over inside the wall: loose until it is out";
    EXPECT_EQ(mouse_.force_n, dvec3(0.0));
    after(0.01);
    after(0.5, push);
    EXPECT_GT(stick_.force_n.x, 0.8);
    EXPECT_LT(stick_.force_n.x, 1.2);
    after(0.6, push);
    EXPECT_EQ(stick_.force_n, push);
}

TEST_F(DeviceGroupTest, TheObserverCountsTheWorkOfTheAppliedForce) {
    // A device takes the tool over and feels a force while it moves: its own ramp multiplies the chain's.
    const SafetyLimits limits = limits_for(stick_.can);
    SafetyState safety;
    dvec3 last_mm(0.0);
    double work_mj = 0.0;
    double asked_mj = 0.0;
    std::size_t holder = 0;
    stick_.is_moving = true;
    for (int k = 0; k < 3000; ++k) {
        if (k > 1000) stick_.sample.position_mm.x += 0.01;
        const HandSample sample = group_->read(tick_++, kStep);
        const DeviceSigns signs = group_->signs();
        if (std::exchange(holder, signs.device) != signs.device) restart_ramp(safety);
        const dvec3 step = k == 0 ? dvec3(0.0) : sample.position_mm - last_mm;
        last_mm = sample.position_mm;
        work_mj += glm::dot(stick_.force_n + mouse_.force_n, step);
        asked_mj += glm::dot(safety.applied_force_n, step);
        const dvec3 push(k > 1000 ? 2.0 : 0.0, 0.0, 0.0);
        group_->write(apply_safety_chain(
            push,
            {.position_mm = sample.position_mm, .dt_s = kStep, .applied_fraction = signs.force_fraction},
            limits, safety));
        ASSERT_NEAR(safety.given_mj - safety.taken_mj, work_mj, 1e-9) << k;
    }
    EXPECT_GT(asked_mj, work_mj + 1.0) << "the ramp has reduced it";
    EXPECT_GT(work_mj, 1.0);
}

TEST_F(DeviceGroupTest, MotorsGetNoMoreThanTheyBearForAMomentAndForEver) {
    stick_.is_moving = true;
    after(2.0);
    after(0.4, {9.0, 0.0, 0.0});
    EXPECT_NEAR(stick_.force_n.x, 3.0, 1e-9) << "its peak, though others bear more";
    after(60.0, {9.0, 0.0, 0.0});
    EXPECT_LE(stick_.force_n.x, kKioskContinuousForceN + 1e-9);
    EXPECT_GT(stick_.force_n.x, 0.7 * kKioskContinuousForceN);
    stick_.is_moving = false;
    mouse_.is_moving = true;
    after(60.0, {3.0, 0.0, 0.0});
    EXPECT_EQ(mouse_.force_n.x, 0.0) << "it was taken over inside the wall";
    after(0.01);
    after(60.0, {3.0, 0.0, 0.0});
    EXPECT_EQ(mouse_.force_n.x, 3.0) << "a picture of a tool does not get warm";
}

TEST_F(DeviceGroupTest, AreNoStifferThanTheSoftestThatClosesALoop) {
    EXPECT_EQ(group_->capabilities().max_stiffness_n_per_mm, 0.3);
    EXPECT_EQ(group_->capabilities().peak_force_n, 3.3);
    EXPECT_FALSE(group_->capabilities().has_motors);
    stick_.can.has_own_walls = true;
    EXPECT_EQ(make({})->capabilities().max_stiffness_n_per_mm, 0.5);
}

TEST_F(DeviceGroupTest, NoHandIsPresentWhileTheHolderIsAbsent) {
    stick_.is_moving = true;
    after(1.0);
    EXPECT_TRUE(group_->signs().hand_is_there);
    stick_.is_here = false;
    after(kStep);
    EXPECT_FALSE(group_->signs().hand_is_there);
    EXPECT_FALSE(group_->signs().position_is_new);
}

TEST_F(DeviceGroupTest, TheDeviceThatTurnsTheWheelSetsItsSpeed) {
    mouse_.sample.rev_min = 90.0;
    stick_.sample.rev_min = 150.0;
    stick_.is_moving = true;
    EXPECT_EQ(after(1.0).rev_min, 90.0);
    stick_.sample.button = true;
    EXPECT_EQ(after(kStep).rev_min, 150.0);
    pedal_.sample = {.button = true, .rev_min = 200.0};
    group_->add_pedal(std::make_unique<PuppetDevice>(pedal_));
    EXPECT_EQ(after(kStep).rev_min, 200.0);
}

TEST_F(DeviceGroupTest, OpensAndClosesAllAndFailsWithTheFirstAlone) {
    stick_.fails_to_open = true;
    EXPECT_TRUE(group_->open());
    EXPECT_EQ(mouse_.opened + pad_.opened + stick_.opened, 3);
    group_->close();
    EXPECT_EQ(mouse_.closed + pad_.closed + stick_.closed, 3);
    mouse_.fails_to_open = true;
    EXPECT_FALSE(group_->open());
}

TEST_F(DeviceGroupTest, APedalTurnsTheWheelWithAnyHolder) {
    group_->add_pedal(std::make_unique<PuppetDevice>(pedal_));
    EXPECT_FALSE(after(kStep).button);
    pedal_.sample.button = true;
    EXPECT_TRUE(after(kStep).button);
    EXPECT_EQ(after(kStep).position_mm, mouse_.sample.position_mm);
}

class RecordedDeviceGroupTest : public DeviceGroupTest {
  protected:
    RecordedDeviceGroupTest() : DeviceGroupTest({.chooser = {.first_yields = true}}) {
        mouse_.is_moving = true;
    }
};

TEST_F(RecordedDeviceGroupTest, ARecordingYieldsAtOnceAndGoesOnWhenThePersonHasLongBeenStill) {
    after(1.0);
    EXPECT_EQ(group_->holder(), 0U);
    stick_.is_moving = true;
    after(kStep);
    EXPECT_EQ(group_->holder(), 2U);
    after(5.0);
    EXPECT_EQ(group_->holder(), 2U);
    stick_.is_moving = false;
    after(2.9);
    EXPECT_EQ(group_->holder(), 2U);
    after(0.2);
    EXPECT_EQ(group_->holder(), 0U);
}

}  // namespace
}  // namespace onggi::haptics
